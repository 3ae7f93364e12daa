// The subcommands: each adds itself to the command line and runs when it is the one that was given.
#pragma once

#include <CLI/CLI.hpp>

namespace suture::sims {

/// The exit codes by which the program answers its caller.
enum Exit : int { kDone = 0, kNo = 1, kBadInput = 2, kFailure = 3 };

/// Each sets `exit` when its subcommand has run; errors are thrown.
void add_resolve(CLI::App& app, int& exit);
void add_check(CLI::App& app, int& exit);
void add_make(CLI::App& app, int& exit);
void add_run(CLI::App& app, int& exit);
void add_fuzz(CLI::App& app, int& exit);
void add_trade(CLI::App& app, int& exit);
void add_draw(CLI::App& app, int& exit);
void add_measure(CLI::App& app, int& exit);
void add_keys(CLI::App& app, int& exit);

}  // namespace suture::sims
