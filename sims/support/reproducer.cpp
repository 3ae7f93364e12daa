// The mesh of a refused surgery, saved for whoever looks into it.
#include "sims/support/reproducer.h"

#include <string>

#include "kernel/formats/mesh_io.h"

namespace suture::sims {

std::filesystem::path save_reproducer(const std::filesystem::path& folder, std::size_t number,
                                      const Triangles& surface) {
  std::filesystem::create_directories(folder);
  std::filesystem::path file = folder / ("refused_remodel_" + std::to_string(number) + ".ply");
  write_triangles(file, surface);
  return file;
}

}  // namespace suture::sims
