// The weight of a neighbour.
#pragma once

#include <cmath>

namespace cosurge::fluid {

/// Eq. (1): w = r_e / r - 1 for r < r_e, else 0 (Koshizuka & Oka 1996, doi 10.13182/NSE96-A24205).
inline double weight(double r, double re) { return r < re ? re / r - 1.0 : 0.0; }

/// Eq. (1) in single precision from a squared distance; 0 at r = 0, the particle itself, and on the edge
/// r = r_e, where rounding would decide.
inline float weight_of(float r2, float re) {
  constexpr float edge = 1e-6F;
  const float w = re / std::sqrt(r2) - 1.0F;
  return r2 > 0 && w > edge ? w : 0.0F;
}

/// Eq. (2b): share of a neighbour in the smooth density, (1 - r / r_e)^2, from its weight of eq. (1). Finite
/// for near pairs, hence hardly moved by disorder.
template <typename Number>
Number smooth_share(Number w) {
  const Number rest = w / (w + 1);
  return rest * rest;
}

}  // namespace cosurge::fluid
