// suture make: one of the shapes, written to a file.
#include <fmt/format.h>

#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/shapes/catalogue.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/support/keys.h"

namespace suture::sims {
namespace {

struct Settings {
  std::string shape;
  std::vector<std::string> parameters;
  std::filesystem::path out;
};

std::map<std::string, double> parsed(const std::vector<std::string>& parameters) {
  std::map<std::string, double> values;
  for (const std::string& text : parameters) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    double value = 0;
    if (equals == std::string::npos || name.empty() ||
        !CLI::detail::lexical_cast(text.substr(equals + 1), value))
      throw InvalidInput("\"" + text + "\" is no parameter; write NAME=NUMBER, as in radius=0.5");
    if (!values.emplace(name, value).second)
      throw InvalidInput("the parameter " + name + " is given twice; give it once");
  }
  return values;
}

void make(const Settings& s) {
  require_writable_mesh(s.out);
  const Triangles surface = make_shape(s.shape, parsed(s.parameters));
  write_triangles(s.out, surface);
  fmt::print("{}: {} vertices, {} triangles\n", s.out.string(), surface.positions.size(),
             surface.triangles.size());
}

std::string shapes_help() {
  std::string help = "Shapes, and their parameters with defaults:\n";
  for (const ShapeInfo& shape : shape_catalogue()) {
    help += fmt::format("\n{}: {}\n", shape.name, shape.meaning);
    for (const ShapeParameter& p : shape.parameters)
      help += fmt::format("  {:<24}{} ({})\n", fmt::format("{}={}", p.name, p.value), p.meaning,
                          p.unit);
  }
  return help;
}

}  // namespace

void add_make(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("make", "Make one of the shapes that Suture knows");
  command->add_option("shape", s->shape, "Name of the shape")->required()->type_name("SHAPE");
  command->add_option("parameters", s->parameters, "Parameters of the shape")
      ->type_name("NAME=NUMBER");
  command->add_option("-o,--output", s->out, "Mesh to write, its format by the extension")
      ->required()
      ->type_name("OUT");
  command->footer(shapes_help());
  command->callback([s, &exit] {
    make(*s);
    exit = kDone;
  });
}

}  // namespace suture::sims
