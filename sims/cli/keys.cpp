// suture keys: the reference of every key that a scene may have.
#include <fmt/format.h>

#include "sims/cli/commands.h"
#include "sims/scene/reference.h"

namespace suture::sims {

void add_keys(CLI::App& app, int& exit) {
  CLI::App* command = app.add_subcommand("keys", "Print the reference of every key of a scene");
  command->callback([&exit] {
    fmt::print("{}", reference_page());
    exit = kDone;
  });
}

}  // namespace suture::sims
