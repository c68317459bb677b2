#include "fluid_solver/gauges.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <numbers>

#include "common/error.hpp"
#include "common/ordered_sum.hpp"
#include "fluid_solver/snap_to_face.hpp"

namespace cosurge::fluid {
namespace {

/// Calls visit(j, x_j - x, |x_j - x|) for the particles within r_e of a point in the domain.
template <int dim, typename Visit>
void each_around(const Mps<dim>& mps, const Vec<dim>& x, Visit&& visit) {
  const CellGrid<dim>& grid = mps.neighbors().grid();
  const CellIndex<dim> cell = grid.cell_of(x);
  if ((cell.array() < 0).any() || (cell.array() >= grid.counts().array()).any()) return;
  grid.ranges(cell, 1, [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t j = first; j < last; ++j) {
      const Vec<dim> way = mps.particles().x[j] - x;
      if (const double r = way.norm(); r < mps.neighbors().re()) visit(j, way, r);
    }
  });
}

/// The last coordinate of the highest water within r_e of the vertical line through x, or `floor`.
template <int dim>
double highest_near(const Mps<dim>& mps, const Vec<dim>& x, double floor) {
  const Particles<dim>& particles = mps.particles();
  double highest = floor;
  for (int i = 0; i < particles.size(); ++i) {
    const double aside = (particles.x[i] - x).template head<dim - 1>().norm();
    if (particles.kind[i] == Kind::fluid && aside < mps.neighbors().re())
      highest = std::max(highest, particles.x[i][dim - 1]);
  }
  return highest;
}

}  // namespace

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
double level_at(const Mps<dim>& mps, const Vec<dim>& x, double floor, double spacing) {
  const double re = mps.neighbors().re();
  // Integral of (1 - r / r_e)^2 over the support, in particles.
  const double full = (dim == 2 ? 1.0 / 6 : 2.0 / 15) * std::numbers::pi * std::pow(re / spacing, dim);
  const auto share = [&](double height) {
    Vec<dim> at = x;
    at[dim - 1] = height;
    double water = 0;
    double others = 0;
    each_around(mps, at, [&](int j, const Vec<dim>&, double r) {
      (mps.particles().kind[j] == Kind::fluid ? water : others) += (1 - r / re) * (1 - r / re);
    });
    return water / std::max(full - others, 0.3 * full);  // next to a wall half is left
  };
  const double step = 0.5 * spacing;
  double above = highest_near(mps, x, floor) + re;
  while (above > floor && share(above - step) < 0.5) above -= step;
  if (above <= floor) return floor;
  const double high = share(above);
  return above - step * (0.5 - high) / (share(above - step) - high);
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
template double level_at<2>(const Mps<2>&, const Vec<2>&, double, double);
template double level_at<3>(const Mps<3>&, const Vec<3>&, double, double);
template WaterState survey_water<2>(const Mps<2>&, double, double, const Vec<2>&);
template WaterState survey_water<3>(const Mps<3>&, double, double, const Vec<3>&);

}  // namespace cosurge::fluid
