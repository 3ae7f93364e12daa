// The only file that is told paths, so that moving the project recompiles no other.
#include "tests/paths.h"

namespace suture {

std::string source_dir() { return SUTURE_SOURCE_DIR; }

std::string program_path() { return SUTURE_PROGRAM; }

}  // namespace suture
