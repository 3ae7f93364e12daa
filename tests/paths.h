// Where tests find the project's files and its program.
#pragma once

#include <string>

namespace suture {

/// The folder of the project's CMakeLists.txt.
std::string source_dir();

/// The path of the program `suture` of this build; empty where it is not built.
std::string program_path();

}  // namespace suture
