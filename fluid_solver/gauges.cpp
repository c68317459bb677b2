#include "fluid_solver/gauges.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "common/error.hpp"
#include "common/ordered_sum.hpp"
#include "fluid_solver/particles_around.hpp"
#include "fluid_solver/snap_to_face.hpp"

namespace cosurge::fluid {
template <int dim>
SurfacePressureProbe<dim>::SurfacePressureProbe(const std::string& name, const Vec<dim>& position,
                                                const Interface& interface, double spacing) {
  const Vec<dim> on_face = snap_to_face<dim>(name, position, interface, spacing);
  double sum = 0;
  for (Eigen::Index k = 0; k < interface.points(); ++k) {
    const Vec<dim> area = interface.area.col(k);
    const Vec<dim> way = interface.position.col(k) - on_face;
    for (int axis = 0; axis < dim; ++axis) {
      // The point must lie on this face of the particle: half a spacing from its centre along the outward
      // normal.
      const double side = area[axis] > 0 ? -0.5 : 0.5;
      if (area[axis] == 0 || std::abs(way[axis] - side * spacing) > 0.01 * spacing) continue;
      double weight = 1;
      for (int other = 0; other < dim; ++other)
        if (other != axis) weight *= std::max(0.0, 1 - std::abs(way[other]) / spacing);
      if (weight > 0) weights_.emplace_back(k, weight);
      sum += weight;
    }
  }
  require(sum > 0, "output.probe {}: no wet face of a body at its position", name);
  for (auto& [k, weight] : weights_) weight /= sum;
}

template <int dim>
double SurfacePressureProbe<dim>::read(const Eigen::VectorXd& pressure) const {
  double sum = 0;
  for (const auto& [k, weight] : weights_) sum += weight * pressure[k];
  return sum;
}

template <int dim>
double pressure_at(const Mps<dim>& mps, const Vec<dim>& x) {
  using Basis = Eigen::Matrix<double, dim + 1, 1>;
  using Moments = Eigen::Matrix<double, dim + 1, dim + 1>;
  const Particles<dim>& particles = mps.particles();
  const double re = mps.neighbors().re();
  Moments moments = Moments::Zero();
  Basis right = Basis::Zero();
  each_around(mps, x, [&](int j, const Vec<dim>& way, double r) {
    if (!has_pressure(particles.kind[j])) return;
    Basis basis;
    basis << 1, way / re;
    const double w = (1 - r / re) * (1 - r / re);
    moments += w * basis * basis.transpose();
    right += w * particles.p[j] * basis;
  });
  const double weights = moments(0, 0);
  if (weights == 0) return 0;
  constexpr double flat = 1e-4;  // too few particles, or all on a line
  if (moments.determinant() < flat * std::pow(weights, dim + 1)) return right[0] / weights;
  return moments.ldlt().solve(right)[0];
}

template <int dim>
WaterState survey_water(const Mps<dim>& mps, double particle_mass, double spacing, const Vec<dim>& gravity) {
  const Particles<dim>& particles = mps.particles();
  const auto is_fluid = [&](int i) { return particles.kind[i] == Kind::fluid; };
  WaterState state;
  state.kinetic_energy = 0.5 * particle_mass * ordered_sum(particles.size(), [&](int i) {
                           return is_fluid(i) ? particles.u[i].squaredNorm() : 0.0;
                         });
  state.gravity_energy = -particle_mass * ordered_sum(particles.size(), [&](int i) {
    return is_fluid(i) ? gravity.dot(particles.x[i]) : 0.0;
  });
  state.front = std::numeric_limits<double>::lowest();
  for (int i = 0; i < particles.size(); ++i) {
    if (!is_fluid(i) || particles.x[i][0] <= state.front) continue;
    int touching = 0;
    mps.neighbors().each(particles, i,
                         [&](int j, const Vec<dim>&, double) { touching += is_fluid(j) ? 1 : 0; });
    if (touching >= dim) state.front = particles.x[i][0] + 0.5 * spacing;
  }
  for (int i = 0; i < particles.size(); ++i) {
    if (!is_fluid(i)) continue;
    bool inside = false;
    mps.neighbors().each(particles, i, [&](int j, const Vec<dim>&, double r) {
      inside = inside || (particles.kind[j] == Kind::body_inner && r < 0.5 * spacing);
    });
    state.inside_bodies += inside ? 1 : 0;
  }
  return state;
}

template class SurfacePressureProbe<2>;
template class SurfacePressureProbe<3>;
template double pressure_at<2>(const Mps<2>&, const Vec<2>&);
template double pressure_at<3>(const Mps<3>&, const Vec<3>&);
template WaterState survey_water<2>(const Mps<2>&, double, double, const Vec<2>&);
template WaterState survey_water<3>(const Mps<3>&, double, double, const Vec<3>&);

}  // namespace cosurge::fluid
