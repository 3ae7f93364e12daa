// A power of two as the unit of length, so that products of lengths neither overflow nor vanish.
#pragma once

#include "surgery/model/options.h"
#include "surgery/model/report.h"
#include "surgery/model/surface.h"

namespace suture::surgery {

/// Cells from 2^kSmallestCell to 2^kLargestCell are computed with: below, positions inside a cell
/// run out of digits; above, 2²¹ cells leave the range of doubles.
inline constexpr int kSmallestCell = -800, kLargestCell = 1000;

/// The unit is 2^this: 0 for cells of ordinary size, whose fourth powers are far from the ends of
/// the doubles; else that in which a cell is 1 to 2 long.
int unit_exponent(const TrackerOptions& options);

/// \throw InvalidInput unless the options' lengths are in range, and exact in the unit
void require_unit(const TrackerOptions& options);

/// \throw InvalidInput if a coordinate is too small to be kept in the unit, or no lattice fits
void require_room(const std::vector<Point>& positions, const TrackerOptions& options);

/// The options with their lengths × 2^exponent.
TrackerOptions times_power(TrackerOptions options, int exponent);

/// Every coordinate × 2^exponent. \return whether that was exact
bool multiply(Mesh& mesh, int exponent);
bool multiply(Surface& surface, int exponent);

/// Lengths and volumes × 2^exponent; a volume beyond the doubles becomes infinite or 0.
void multiply(SurgeryReport& report, int exponent);
void multiply(QualityReport& report, int exponent);

}  // namespace suture::surgery
