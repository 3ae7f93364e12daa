// Two surfaces are measured, and how far they are apart.
#include <suture/kernel/formats/mesh_io.h>
#include <suture/kernel/measure/distance.h>
#include <suture/kernel/measure/measures.h>

#include <cstdio>

int main() {
  const suture::Triangles before = suture::read_triangles("out/union.ply");
  const suture::Triangles after = suture::read_triangles("out/moved.ply");
  for (const suture::Triangles& mesh : {before, after})
    std::printf("volume %.4f, area %.4f, V - E + F = %lld, smallest angle %.1f degrees\n",
                suture::volume(mesh), suture::area(mesh),
                static_cast<long long>(suture::euler_characteristic(mesh)),
                suture::angles(mesh).smallest);
  const double apart = suture::surface_distance(before, after, {.samples = 2000}).hausdorff();
  std::printf("at most %.4f apart\n", apart);
  return suture::volume(before) > 0 && suture::volume(after) > 0 && apart > 0 ? 0 : 1;
}
