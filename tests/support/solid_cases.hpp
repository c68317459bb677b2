// Solids for the tests: small bodies on a lattice of 1 mm, as cases and as interfaces.
#pragma once

#include <vector>

#include "common/participant.hpp"
#include "proto/case.pb.h"

namespace cosurge::test {

inline constexpr double l0 = 0.001;

/// @param box a Box, or a Shape that is one
template <typename Corners>
void set_box(Corners& box, const std::vector<double>& min, const std::vector<double>& max) {
  box.mutable_min()->Assign(min.begin(), min.end());
  box.mutable_max()->Assign(max.begin(), max.end());
}

struct SolidParameters {
  int columns = 12;
  int rows = 80;
  bool clamped = true;  ///< at the foot
  double young_modulus = 1e6;
  double poisson_ratio = 0;
  double density = 2500;
  std::vector<double> gravity = {0, 0};
};

/// An upright plate with its left foot at the origin; default: that of Amaro & Cheng. A probe "tip" on its
/// upper right corner.
inline v1::Case plate(const SolidParameters& p) {
  v1::Case c;
  c.set_title("plate");
  c.mutable_gravity()->Assign(p.gravity.begin(), p.gravity.end());
  c.mutable_time()->set_end(1);
  c.mutable_time()->set_window(1e-4);
  v1::Solid& solid = *c.mutable_solid();
  solid.set_model(v1::SolidModel::mps);
  solid.set_spacing(l0);
  solid.set_density(p.density);
  solid.set_young_modulus(p.young_modulus);
  solid.set_poisson_ratio(p.poisson_ratio);
  v1::Body& body = *solid.add_body();
  set_box(*body.mutable_box(), {0, 0}, {p.columns * l0, p.rows * l0});
  if (p.clamped) set_box(*body.add_clamp(), {0, -0.02}, {p.columns * l0, 0});
  v1::Probe& tip = *c.mutable_output()->add_probe();
  tip.set_name("tip");
  tip.set_quantity(v1::Probe::displacement);
  tip.add_position(p.columns * l0);
  tip.add_position(p.rows * l0);
  return c;
}

/// The points of a fluid of the same spacing along the left face of body 0.
inline Interface left_face(int rows) {
  Interface interface {
    .dimension = 2, .position = Field(2, rows), .area = Field::Zero(2, rows), .body = {}
  };
  for (int j = 0; j < rows; ++j) {
    interface.position.col(j) << 0.5 * l0, (j + 0.5) * l0;
    interface.area(0, j) = -l0;
  }
  interface.body.assign(static_cast<std::size_t>(rows), 0);
  return interface;
}

}  // namespace cosurge::test
