// The weight of a neighbour.
#pragma once

namespace cosurge::fluid {

/// Eq. (1): w = r_e / r - 1 for r < r_e, else 0 (Koshizuka & Oka 1996, doi 10.13182/NSE96-A24205).
inline double weight(double r, double re) { return r < re ? re / r - 1.0 : 0.0; }

}  // namespace cosurge::fluid
