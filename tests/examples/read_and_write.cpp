// A mesh is read, checked, and written in another format.
#include <suture/kernel/audit.h>
#include <suture/kernel/errors.h>
#include <suture/kernel/formats/mesh_io.h>

#include <cstdio>

int main(int argc, char** argv) {
  const char* const from = argc > 1 ? argv[1] : "out/union.ply";
  const char* const to = argc > 2 ? argv[2] : "out/union.obj";
  try {
    const suture::Triangles mesh = suture::read_triangles(from);
    for (const std::string& fault : suture::audit(mesh).faults) std::puts(fault.c_str());
    suture::write_triangles(to, mesh);
    std::printf("%s: %zu vertices, %zu triangles\n", to, mesh.positions.size(),
                mesh.triangles.size());
  } catch (const suture::InvalidInput& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
