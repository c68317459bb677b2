// A tank that rolls, with a plate on its floor.
#pragma once

#include <initializer_list>

#include "proto/case.pb.h"

namespace cosurge::test {

constexpr double rolling_window = 1e-3;  // s

/// A plate of 0.04 x 0.12 m that is clamped to the floor of a tank, which rolls about a point below and
/// surges.
template <int dim>
v1::Case rolling_tank(v1::SolidModel::Word model, double young_modulus) {
  v1::Case c;
  c.set_dimension(dim);
  for (int k = 0; k < dim; ++k) c.add_gravity(k == dim - 1 ? -9.81 : 0);
  c.mutable_time()->set_window(rolling_window);
  v1::Fluid& fluid = *c.mutable_fluid();
  fluid.set_spacing(0.01);
  v1::Box& tank = *fluid.mutable_tank();
  v1::Solid& solid = *c.mutable_solid();
  solid.set_model(model);
  solid.set_density(1500);
  solid.set_young_modulus(young_modulus);
  solid.mutable_fem()->set_element(0.04);
  solid.mutable_mps()->set_viscosity(0);
  solid.mutable_hamiltonian()->set_viscosity(0);
  v1::Body& body = *solid.add_body();
  v1::Shape& clamp = *body.add_clamp();
  const auto add = [](auto& box, std::initializer_list<double> min, std::initializer_list<double> max) {
    for (const double x : min) box.add_min(x);
    for (const double x : max) box.add_max(x);
  };
  if (dim == 2) {
    add(tank, {0, 0}, {0.6, 0.4});
    add(*body.mutable_box(), {0.28, 0}, {0.32, 0.12});
    add(clamp, {0.28, -0.04}, {0.32, 0});
  } else {
    add(tank, {0, 0, 0}, {0.6, 0.1, 0.4});
    add(*body.mutable_box(), {0.28, 0.03, 0}, {0.32, 0.07, 0.12});
    add(clamp, {0.28, 0.03, -0.04}, {0.32, 0.07, 0});
  }
  v1::WallMotion& motion = *fluid.mutable_tank_motion();
  for (int k = 0; k < dim; ++k) {
    motion.add_amplitude(k == 0 ? 0.05 : 0);
    motion.add_pivot(k == 0 ? 0.3 : k == dim - 1 ? -0.2 : 0);
  }
  motion.set_angle(0.3);
  motion.set_frequency(0.8);
  motion.set_ramp(0.3);
  return c;
}

}  // namespace cosurge::test
