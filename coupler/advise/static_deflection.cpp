#include "coupler/advise/static_deflection.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/from_case.hpp"
#include "common/case/water_depth.hpp"
#include "common/geometry/shape.hpp"

namespace cosurge {
namespace {

constexpr double slender = 2;  // length over thickness of a plate or beam

template <int dim>
Box<dim> bounds_of(const v1::Shape& shape) {
  return from_case<dim>(shape).bounds();
}

/// Whether the clamp covers the whole end of the box along an axis.
template <int dim>
bool clamps_end(const Box<dim>& clamp, const Box<dim>& box, int axis, bool upper) {
  const double rounding = 1e-6 * (box.max - box.min).maxCoeff();
  for (int k = 0; k < dim; ++k)
    if (k != axis && (clamp.min[k] > box.min[k] + rounding || clamp.max[k] < box.max[k] - rounding))
      return false;
  const double end = upper ? box.max[axis] : box.min[axis];
  return clamp.min[axis] <= end + rounding && clamp.max[axis] >= end - rounding;
}

template <int dim>
Hold hold(const v1::Body& body) {
  if (!body.has_box() || body.support_size() > 0) return {};
  const auto box = from_case<dim>(body.box());
  const Vec<dim> side = box.max - box.min;
  Hold hold;
  side.minCoeff(&hold.thickness);
  int ends = 0;
  for (const v1::Shape& clamp : body.clamp()) {
    int here = 0;
    for (int axis = 0; axis < dim; ++axis)
      for (const bool upper : {false, true})
        if (clamps_end<dim>(bounds_of<dim>(clamp), box, axis, upper)) {
          if (ends > 0 && axis != hold.length) return {};
          hold.length = axis;
          hold.at_upper = upper;
          ++here;
          ++ends;
        }
    if (here != 1) return {};
  }
  if (ends == 1 && hold.length == hold.thickness)
    hold.kind = Hold::layer;
  else if (ends > 0 && hold.length != hold.thickness && side[hold.length] >= slender * side[hold.thickness])
    hold.kind = ends == 1 ? Hold::cantilever : Hold::fixed;
  return hold;
}

/// Modulus of bending.
template <int dim>
double bending_modulus(const v1::Solid& solid, const Vec<dim>& side, const Hold& hold) {
  const double nu = solid.poisson_ratio();
  bool wide = solid.plane() == v1::Solid::plane_strain;
  if constexpr (dim == 3) wide = side[3 - hold.thickness - hold.length] >= side[hold.length];
  return wide ? solid.young_modulus() / (1 - nu * nu) : solid.young_modulus();
}

template <int dim>
std::optional<double> deflection(const v1::Case& the_case, const v1::Body& body) {
  const v1::Solid& solid = the_case.solid();
  const Hold hold = hold_of(body, dim);
  if (hold.kind == Hold::other) return {};
  const auto box = from_case<dim>(body.box());
  const Vec<dim> side = box.max - box.min;
  const double weight = the_case.fluid().density() * std::abs(the_case.gravity(dim - 1));
  const double surface = highest_water(the_case);
  const auto pressure = [&](double height) { return weight * std::max(0.0, surface - height); };
  const double t = side[hold.thickness];
  if (hold.kind == Hold::layer) {
    const double height = hold.thickness == dim - 1 ? box.max[dim - 1] : box.min[dim - 1];
    return pressure(height) * t / layer_modulus(solid);
  }
  if (hold.thickness != dim - 1 && hold.length != dim - 1) return {};  // a wall that spans sideways
  const double stiffness = bending_modulus<dim>(solid, side, hold) * t * t * t / 12;
  const double length = side[hold.length];
  constexpr int pieces = 1000;
  double sum = 0;
  for (int k = 0; k < pieces; ++k) {
    const double along = (k + 0.5) / pieces * length;  // distance from the lower end [m]
    const double height = hold.length == dim - 1 ? box.min[dim - 1] + along : box.max[dim - 1];
    double s = hold.at_upper ? length - along : along;
    double influence = s * s * (3 * length - s) / 6;
    if (hold.kind == Hold::fixed) {
      s = std::min(along, length - along);
      influence = s * s * (3 * length - 4 * s) / 48;
    }
    sum += pressure(height) * influence * length / pieces;
  }
  return sum / stiffness;
}

}  // namespace

double layer_modulus(const v1::Solid& solid) {
  const double nu = solid.poisson_ratio();
  return solid.young_modulus() * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
}

Hold hold_of(const v1::Body& body, int dimension) { return dimension == 2 ? hold<2>(body) : hold<3>(body); }

std::optional<double> static_deflection(const v1::Case& the_case, int body) {
  if (!the_case.has_fluid() || !the_case.solid().has_young_modulus()) return {};
  const v1::Body& one = the_case.solid().body(body);
  const std::optional<double> value =
      the_case.dimension() == 2 ? deflection<2>(the_case, one) : deflection<3>(the_case, one);
  return value && *value > 0 ? value : std::nullopt;
}

}  // namespace cosurge
