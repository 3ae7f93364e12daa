// One row of the table of extremes: what happened, how far off it was, what it cost.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "kernel/triangles.h"
#include "surgery/tracker.h"

namespace suture::extremes {

struct Result {
  std::string outcome;  ///< committed, unchanged, refused: why, or the exception's message
  double error = std::numeric_limits<double>::quiet_NaN();  ///< of the volume, relative
  std::string bits;  ///< "yes" or "no": those of the twin; empty where there is none
  std::size_t before = 0, after = 0;  ///< triangles
  double seconds = 0;                 ///< of the processor, for the tracker's work alone
  std::string note;
};

struct Row {
  std::string extreme, value;
  std::function<Result()> run;
};

/// The calls that are made on a surface.
struct Task {
  bool remodel = true, improve = false;
};

/// Runs the task; fills outcome, triangles and seconds. \param surface becomes the result
Result perform(Triangles& surface, const TrackerOptions& options, const Task& task = {});

/// a / b − 1.
inline double relative(double a, double b) { return a / b - 1; }

/// Volume of the union of two_balls(frequency), by corefinement where that is quick; of the round
/// balls above frequency 64, which the faceted ones approach.
double union_of_two_balls(int frequency);

double cpu_seconds();
std::string text(const char* format, double value);

void add_scale_rows(std::vector<Row>& rows);
void add_lattice_rows(std::vector<Row>& rows);
void add_size_rows(std::vector<Row>& rows);
void add_shape_rows(std::vector<Row>& rows);
void add_time_rows(std::vector<Row>& rows);

}  // namespace suture::extremes
