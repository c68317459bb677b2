#include "coupler/advise/scene_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/case/water_depth.hpp"
#include "common/case/window_sizes.hpp"
#include "common/geometry/body_sites.hpp"
#include "coupler/advise/static_deflection.hpp"

namespace cosurge {
namespace {

/// Thickness of a rectangle with this area and circumference.
double thickness_of_plate(double area, double circumference) {
  const double quarter = circumference / 4;
  return quarter - std::sqrt(std::max(0.0, quarter * quarter - area));
}

/// Thickness of a square plate with this volume and surface.
double thickness_of_slab(double volume, double surface) {
  double low = std::cbrt(volume), high = std::max(low, std::sqrt(surface / 2));  // of its side
  for (int k = 0; k < 60; ++k) {
    const double side = (low + high) / 2;
    (2 * side * side + 4 * volume / side < surface ? low : high) = side;
  }
  return volume / (low * low);
}

/// The shortest side of a box, and of an outline that of a plate with the same volume and surface.
template <int dim>
double thickness(const Shape<dim>& shape, double volume) {
  if (shape.is_box()) return (shape.bounds().max - shape.bounds().min).minCoeff();
  double surface = 0;
  for (const auto& facet : shape.facets()) surface += normal_of(facet).norm() / (dim - 1);
  return dim == 2 ? thickness_of_plate(volume, surface) : thickness_of_slab(volume, surface);
}

/// Whether two boxes overlap along all axes but one.
template <int dim>
bool face_each_other(const Box<dim>& a, const Box<dim>& b, int axis) {
  for (int k = 0; k < dim; ++k)
    if (k != axis && (a.min[k] >= b.max[k] || b.min[k] >= a.max[k])) return false;
  return true;
}

/// Water that moves with a body, over the body's projected area [kg/m2]; 0: unknown.
template <int dim>
double water_on(const v1::Case& the_case, const Box<dim>& body, int axis) {
  constexpr int up = dim - 1;
  const v1::Fluid& fluid = the_case.fluid();
  double column = 0;
  bool below = false, above = false;
  for (const v1::Shape& water : fluid.water()) {
    const auto shape = from_case<dim>(water);
    const Box<dim>& box = shape.bounds();
    if (!face_each_other(body, box, axis)) continue;
    column = std::max(column, box.max[up] - body.max[up]);
    below |= box.min[axis] < body.min[axis];
    above |= box.max[axis] > body.max[axis];
  }
  if (axis == up) return fluid.density() * column;
  const double floor = std::max(body.min[up], fluid.tank().min(up));
  const double wetted = std::min(body.max[up], highest_water(the_case)) - floor;
  const double sides = below && above ? 2 : 1;
  return sides * fluid.density() * std::max(0.0, wetted) / 2 * wetted / (body.max[up] - body.min[up]);
}

/// The smallest root of x tan x = 1 / mu.
double root_of_bar(double mu) {
  double low = 0, high = std::numbers::pi / 2;
  for (int k = 0; k < 60; ++k) {
    const double x = (low + high) / 2;
    (x * std::sin(x) < std::cos(x) / mu ? low : high) = x;
  }
  return low;
}

std::optional<double> wet_frequency(const v1::Case& the_case, const SceneNumbers& scene) {
  const v1::Solid& solid = the_case.solid();
  if (scene.bodies.size() != 1 || !scene.bodies.front().added_mass_ratio) return {};
  const BodyNumbers& body = scene.bodies.front();
  const double mu = *body.added_mass_ratio;
  if (solid.model() == v1::SolidModel::sprung) {
    if (solid.sprung().spring_size() != 1) return {};
    return scene.dry_frequency / std::sqrt(1 + mu);
  }
  const Hold::Kind kind = hold_of(solid.body(0), the_case.dimension()).kind;
  if (kind == Hold::other || !solid.has_young_modulus()) return {};
  if (kind != Hold::layer) return scene.dry_frequency / std::sqrt(1 + mu);
  const double speed = std::sqrt(layer_modulus(solid) / solid.density());
  return root_of_bar(mu) * speed / (2 * std::numbers::pi * body.thickness);
}

/// Rate of the water's response [1/s]; 0 without gravity.
double rate(const v1::Case& the_case, const SceneNumbers& scene) {
  const v1::Fluid& fluid = the_case.fluid();
  if (fluid.source() != v1::Fluid::time_scale) return 1 / scene.window;
  const double c = fluid.has_propagation_speed() ? fluid.propagation_speed() : scene.speed / std::sqrt(2);
  return std::min(c / fluid.spacing(), 1 / scene.window);
}

template <int dim>
BodyNumbers numbers_of(const v1::Case& the_case, int b, const SceneNumbers& scene) {
  const v1::Solid& solid = the_case.solid();
  const v1::Fluid& fluid = the_case.fluid();
  const v1::Body& body = solid.body(b);
  const auto shape = from_case<dim>(shape_of(body));
  const Vec<dim> side = shape.bounds().max - shape.bounds().min;
  const auto sites = static_cast<double>(BodySites<dim>(shape, fluid.spacing()).all().size());
  const double volume = sites * std::pow(fluid.spacing(), dim);
  BodyNumbers numbers;
  const bool stated = solid.model() == v1::SolidModel::sprung && solid.sprung().has_mass();
  numbers.mass = stated ? solid.sprung().mass() : solid.density() * volume;
  numbers.displaced = fluid.density() * volume;
  numbers.thickness = thickness(shape, volume);
  numbers.longest = side.maxCoeff();
  numbers.deflection = static_deflection(the_case, b);
  int axis = 0;
  const double shortest = side.minCoeff(&axis);
  const double added = water_on<dim>(the_case, shape.bounds(), axis) * side.prod() / shortest;
  if (added <= 0) return numbers;
  const double mu = added / numbers.mass;
  numbers.added_mass_ratio = mu;
  if (const double k = rate(the_case, scene); k > 0 && solid.has_young_modulus())
    numbers.gain = mu * k * numbers.thickness / std::sqrt(solid.young_modulus() / solid.density());
  return numbers;
}

}  // namespace

std::optional<double> SceneNumbers::largest(std::optional<double> BodyNumbers::*value) const {
  std::optional<double> most;
  for (const BodyNumbers& body : bodies) most = std::max(most, body.*value);
  return most;
}

SceneNumbers scene_numbers(const v1::Case& the_case, double dry_frequency) {
  const v1::Fluid& fluid = the_case.fluid();
  const int dim = the_case.dimension();
  SceneNumbers scene;
  scene.head = highest_water(the_case) - lowest_water(the_case);
  scene.speed = std::sqrt(2 * std::abs(the_case.gravity(dim - 1)) * scene.head);
  scene.layers = scene.head / fluid.spacing();
  scene.window = expected_window(the_case);
  scene.courant = scene.speed * scene.window / fluid.spacing();
  if (fluid.kinematic_viscosity() > 0)
    scene.reynolds = scene.speed * scene.head / fluid.kinematic_viscosity();
  if (the_case.solid().has_young_modulus())
    scene.cauchy = fluid.density() * scene.speed * scene.speed / the_case.solid().young_modulus();
  const double k = rate(the_case, scene);
  scene.response = k > 0 ? 1 / k : scene.window;
  scene.dry_frequency = dry_frequency;
  for (int b = 0; b < the_case.solid().body_size(); ++b)
    scene.bodies.push_back(dim == 2 ? numbers_of<2>(the_case, b, scene) : numbers_of<3>(the_case, b, scene));
  scene.wet_frequency = wet_frequency(the_case, scene);
  return scene;
}

}  // namespace cosurge
