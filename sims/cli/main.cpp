// The program: its subcommands, and what becomes of errors.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "kernel/errors.h"
#include "sims/cli/commands.h"
#include "sims/support/version.h"

namespace {

int report(const std::exception& error, int exit) {
  fmt::print(stderr, "suture: {}\n", error.what());
  return exit;
}

int run_program(int argc, char** argv) {
  using namespace suture;
  using namespace suture::sims;
  int exit = kDone;
  try {
    CLI::App app("Deforming meshes that split and merge.", "suture");
    app.set_version_flag("--version", std::string("suture ") + kVersion);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 1 the answer is no (check), 2 bad input or options, 3 an "
        "internal failure, with a reproducer saved and named.");
    add_resolve(app, exit);
    add_check(app, exit);
    add_make(app, exit);
    add_run(app, exit);
    add_fuzz(app, exit);
    add_trade(app, exit);
    add_draw(app, exit);
    add_measure(app, exit);
    add_keys(app, exit);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? kDone : kBadInput;
    }
    return exit;
  } catch (const InvalidInput& error) {
    return report(error, kBadInput);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "suture: there is not enough memory for this; give larger cells\n");
    return kBadInput;
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "suture: {}: {}; check the name and its permissions\n",
               error.path1().string(), error.code().message());
    return kBadInput;
  } catch (const std::exception& error) {
    return std::ferror(stdout) != 0 ? exit : report(error, kFailure);  // main tells of stdout
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int exit = run_program(argc, argv);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit;
  fmt::print(stderr, "suture: standard output could not be written; check the space there\n");
  return exit == suture::sims::kFailure ? exit : suture::sims::kBadInput;
}
