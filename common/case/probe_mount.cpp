#include "common/case/probe_mount.hpp"

#include <cmath>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"

namespace cosurge {
namespace {

constexpr double rounding = 0.01;  // spacings

template <int dim>
int obstacle_at(const v1::Fluid& fluid, const Vec<dim>& x) {
  for (int k = 0; k < fluid.obstacle_size(); ++k) {
    const auto shape = from_case<dim>(fluid.obstacle(k).shape());
    if (shape.contains(x) || (shape.nearest(x) - x).norm() <= rounding * fluid.spacing()) return k;
  }
  return -1;
}

template <int dim>
ProbeMount mount_in_fluid(const v1::Fluid& fluid, const Vec<dim>& x) {
  if (const int k = obstacle_at<dim>(fluid, x); k >= 0) return {.on = ProbeMount::On::obstacle, .number = k};
  const double near = rounding * fluid.spacing();
  for (int axis = dim - 1; axis >= 0; --axis) {
    for (const bool upper : {false, true}) {
      if (upper && axis == dim - 1) continue;  // the tank is open at the top
      const double face = upper ? fluid.tank().max(axis) : fluid.tank().min(axis);
      if (std::abs(x[axis] - face) <= near) return {.on = ProbeMount::On::face, .axis = axis, .upper = upper};
    }
  }
  return {};
}

}  // namespace

ProbeMount mount_of(const v1::Case& the_case, const v1::Probe& probe) {
  const int body = body_at(the_case.solid(), probe.position());
  if (body >= 0) return {.on = ProbeMount::On::body, .number = body};
  if (!the_case.has_fluid()) return {};
  return the_case.dimension() == 2 ? mount_in_fluid<2>(the_case.fluid(), from_case<2>(probe.position()))
                                   : mount_in_fluid<3>(the_case.fluid(), from_case<3>(probe.position()));
}

}  // namespace cosurge
