// The processor must round to nearest and keep subnormals: the filters take that for granted.
#pragma once

namespace suture {

/// The filters' error bounds and the balls of construct hold where doubles are rounded to nearest
/// and subnormal ones are kept. Both are a thread's own setting, which a library can change that
/// was linked with -ffast-math.
/// \throw InvalidInput, saying which setting of the calling thread to undo
void require_ieee_arithmetic();

}  // namespace suture
