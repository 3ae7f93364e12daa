// What the cases of the fluid's validation share: the rows that they write.
#pragma once

#include <string>

namespace suture {

double cpu_seconds();

/// Rows of one case; `error` is relative to what is exact, or the figure itself where that is 0.
struct Rows {
  std::string name, text;
  double from = cpu_seconds();

  void add(const std::string& what, double resolution, double time, double measured, double exact);
  void restart() { from = cpu_seconds(); }
};

void dams(Rows& rows);
void falls(Rows& rows);
void dam_causes(Rows& rows);
void drops(Rows& rows);
void fine_drop(Rows& rows);
void currents(Rows& rows);
void shear(Rows& rows);
void elastic(Rows& rows);
void yielding(Rows& rows);
void translation(Rows& rows);
void vortices(Rows& rows);
void still_water(Rows& rows);
void projections(Rows& rows);
void sloshing(Rows& rows);
void meetings(Rows& rows);
void buckling(Rows& rows);

}  // namespace suture
