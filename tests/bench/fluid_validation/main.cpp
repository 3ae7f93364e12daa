// The fluid solver against experiment, formulas and what has to be kept; as CSV, case by case.
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>

#include "tests/bench/fluid_validation/validation.h"

namespace suture {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void Rows::add(const std::string& what, double resolution, double time, double measured,
               double exact) {
  const double error = exact == 0 ? measured : measured / exact - 1;
  const std::string row =
      fmt::format("{}{},{},{:.5g},{:.6g},{:.6g},{:.3g},{:.2f}\n", name, what, resolution, time,
                  measured, exact, error, cpu_seconds() - from);
  fmt::print("{}", row);
  std::fflush(stdout);
  text += row;
}

namespace {

const std::map<std::string, void (*)(Rows&)> kCases = {{"dam", dams},
                                                       {"fall", falls},
                                                       {"cause", dam_causes},
                                                       {"drop", drops},
                                                       {"fine_drop", fine_drop},
                                                       {"currents", currents},
                                                       {"shear", shear},
                                                       {"elastic", elastic},
                                                       {"yield", yielding},
                                                       {"translation", translation},
                                                       {"vortex", vortices},
                                                       {"still", still_water},
                                                       {"projection", projections},
                                                       {"slosh", sloshing},
                                                       {"meeting", meetings},
                                                       {"buckling", buckling}};

/// Whether a row of the file is of the case: its name goes on with what is measured.
bool is_of(const std::string& line, const std::string& name) {
  return line.starts_with(name + "_") || line.starts_with(name + ".");
}

/// The file's rows, those of the case replaced.
void replace(const std::string& path, const Rows& rows) {
  std::string kept = "case,resolution,time,measured,exact,error,seconds\n";
  std::ifstream old(path);
  for (std::string line; std::getline(old, line);)
    if (!line.starts_with("case,") && !is_of(line, rows.name)) kept += line + "\n";
  old.close();
  std::ofstream(path) << kept << rows.text;
}

}  // namespace
}  // namespace suture

int main(int count, char** words) {
  using namespace suture;
  if (count < 3) {
    fmt::print(stderr, "fluid_validation FILE.csv CASE...; cases:");
    for (const auto& [name, run] : kCases) fmt::print(stderr, " {}", name);
    fmt::print(stderr, "\n");
    return 2;
  }
  for (int i = 2; i < count; ++i) {
    const auto found = kCases.find(words[i]);
    if (found == kCases.end()) {
      fmt::print(stderr, "no case is called {}\n", words[i]);
      return 2;
    }
    Rows rows{found->first, "", cpu_seconds()};
    found->second(rows);
    replace(words[1], rows);
  }
  return 0;
}
