// Water for the tests: blocks of particles, in order or in disorder, and tanks as cases.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "common/case/bodies.hpp"
#include "fluid_solver/density.hpp"
#include "fluid_solver/from_case.hpp"
#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/walls.hpp"
#include "proto/case.pb.h"

namespace cosurge::fluid::test {

/// Sites along each axis.
template <int dim>
using Counts = Eigen::Matrix<int, dim, 1>;

/// Particles and their neighbours in the small radius.
template <int dim>
struct Cloud {
  Particles<dim> particles;
  Neighbors<dim> neighbors;

  /// The particle nearest to `x`.
  int nearest(const Vec<dim>& x) const {
    int best = 0;
    for (int i = 1; i < particles.size(); ++i)
      if ((particles.x[i] - x).squaredNorm() < (particles.x[best] - x).squaredNorm()) best = i;
    return best;
  }
};

/// No symmetry, no zeros.
template <int dim>
Mat<dim> some_matrix() {
  Mat<dim> A;
  for (int k = 0; k < A.size(); ++k) A.data()[k] = std::cos(3.0 * k + 1);
  return A;
}

/// A block of fluid with a corner in the origin: the sites of the lattice, moved by up to `disorder` spacings
/// along each axis. Sorted, with neighbours in a domain that is larger by three spacings.
template <int dim>
Cloud<dim> block(const Counts<dim>& counts, double spacing, double disorder = 0, double re = 2.1) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-disorder * spacing, disorder * spacing);
  const Box<dim> box(Vec<dim>::Zero(), counts.template cast<double>() * spacing);
  const Vec<dim> margin = Vec<dim>::Constant(3 * spacing);
  Cloud<dim> cloud{.particles = {},
                   .neighbors = Neighbors<dim>({box.min - margin, box.max + margin}, re * spacing)};
  for (Vec<dim> x : fill(box, spacing)) {
    if (disorder > 0)
      for (double& coordinate : x) coordinate += shift(random);
    cloud.particles.add(Kind::fluid, x);
  }
  cloud.neighbors.rebuild(cloud.particles);
  return cloud;
}

/// A box of a case.
inline v1::Box box_of(const std::vector<double>& min, const std::vector<double>& max) {
  v1::Box box;
  box.mutable_min()->Assign(min.begin(), min.end());
  box.mutable_max()->Assign(max.begin(), max.end());
  return box;
}

/// Water in a tank, everything else as by default.
inline v1::Fluid tank_of_water(double spacing, const v1::Box& tank, const std::vector<v1::Box>& water) {
  v1::Fluid fluid;
  fluid.set_spacing(spacing);
  *fluid.mutable_tank() = tank;
  for (const v1::Box& box : water) *fluid.add_water() = shape_of(box);
  return fluid;
}

/// The walls of an empty tank, with three layers of dummies.
template <int dim>
Walls<dim> walls_of(const Box<dim>& tank, double spacing) {
  v1::Fluid fluid;
  fluid.set_spacing(spacing);
  fluid.mutable_tank()->mutable_min()->Assign(tank.min.begin(), tank.min.end());
  fluid.mutable_tank()->mutable_max()->Assign(tank.max.begin(), tank.max.end());
  return Walls<dim>(water_from_case<dim>(fluid, Vec<dim>::Zero()), 3);
}

/// A structure of one body.
inline v1::Solid solid_of(const v1::Box& box, const std::vector<v1::Box>& clamps = {}) {
  v1::Solid solid;
  v1::Body& body = *solid.add_body();
  *body.mutable_box() = box;
  for (const v1::Box& clamp : clamps) *body.add_clamp() = shape_of(clamp);
  return solid;
}

}  // namespace cosurge::fluid::test
