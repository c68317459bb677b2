#include "solid_solver/models/particles/particle_model.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "solid_solver/hyperelasticity.hpp"
#include "solid_solver/moving_least_squares.hpp"

namespace cosurge::particles {
namespace {

constexpr double interpolation_radius =
    2.5;                        // l0: the corner of a body, half a spacing off, still finds four particles
constexpr double whole = 1e-6;  // [sub-steps] tolerance: a window of 20.0000001 sub-steps has 20

}  // namespace

template <int dim>
ParticleModel<dim>::ParticleModel(Bodies bodies, const Elasticity& material, double spacing,
                                  const Steps& steps)
    : bodies_(std::move(bodies)),
      material_(material),
      spacing_(spacing),
      steps_(steps),
      substep_(steps.fixed > 0 ? steps.fixed : steps.fraction * steps.stable) {
  require(steps.fixed <= steps.stable, "{}.substep = {:.4g} s: must be <= {:.4g} s, the stable step",
          steps.key, steps.fixed, steps.stable);
  first_.push_back(0);
  for (const auto& body : bodies_) first_.push_back(first_.back() + body->particles());
}

template <int dim>
typename ParticleModel<dim>::Row ParticleModel<dim>::interpolation_row(const BodyGrid<dim>& grid,
                                                                       const Vec<dim>& x) const {
  const long same = grid.particle_at(x);
  if (same >= 0) return {{static_cast<std::size_t>(same), 1.0}};
  if (grid.in_clamp(x) && !grid.in_shape(x)) return {};
  const double radius = interpolation_radius * spacing_;
  const std::vector<std::size_t> near = grid.particles_near(x, radius);
  std::vector<Vec<dim>> positions;
  positions.reserve(near.size());
  for (const std::size_t p : near) positions.push_back(grid.positions()[p]);
  const Eigen::VectorXd coefficients = moving_least_squares<dim>(x, positions, radius);
  require(coefficients.size() > 0,
          "solid: no particles near the interface point ({}); make solid.spacing smaller",
          fmt::join(x.begin(), x.end(), ", "));
  Row row;
  for (std::size_t j = 0; j < near.size(); ++j) row.emplace_back(near[j], coefficients[static_cast<long>(j)]);
  return row;
}

template <int dim>
Interpolation ParticleModel<dim>::interpolation(const Field& position, const std::vector<int>& body) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index point = 0; point < position.cols(); ++point) {
    const auto b = static_cast<std::size_t>(body[static_cast<std::size_t>(point)]);
    for (const auto& [particle, coefficient] : interpolation_row(bodies_.at(b)->grid(), position.col(point)))
      entries.emplace_back(static_cast<int>(point), static_cast<int>(first_[b] + static_cast<long>(particle)),
                           coefficient);
  }
  Interpolation H(position.cols(), nodes());
  H.setFromTriplets(entries.begin(), entries.end());
  return H;
}

template <int dim>
int ParticleModel<dim>::advance(const Window& window, const NodalLoad& load) {
  const int substeps = std::max(1, static_cast<int>(std::ceil(window.size / substep_ - whole)));
  last_dt_ = window.size / substeps;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Eigen::Index count = bodies_[b]->particles();
    bodies_[b]->set_load(load.first.middleCols(first_[b], count), load.last.middleCols(first_[b], count));
    bodies_[b]->advance(substeps, last_dt_);
  }
  check_motion(window);
  return substeps;
}

template <int dim>
void ParticleModel<dim>::check_motion(const Window& window) const {
  const double limit = material_.pressure_speed();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Field velocity = bodies_[b]->velocity();
    const Vec<dim> mean = velocity.rowwise().mean();
    for (Eigen::Index p = 0; p < velocity.cols(); ++p) {
      const double speed = (velocity.col(p) - mean).norm();
      if (speed <= limit) continue;  // false for NaN
      const Vec<dim>& x = bodies_[b]->grid().positions()[static_cast<std::size_t>(p)];
      throw NumericalError(
          fmt::format("solid: particle {} of body {}, at ({:.6g}) when undeformed, moves at {:.4g} m/s "
                      "relative to the body's mean in the window from t = {:.6g} s; the limit is {:.4g} m/s, "
                      "the wave speed of the material. Either the sub-step of {:.3g} s is unstable (lower "
                      "{}.step_fraction or substep), or the load alternates from window to window "
                      "(coupling.load = \"ramped\"), or the body is too soft or too light{}",
                      p, b, fmt::join(x.begin(), x.end(), ", "), speed, window.start, limit, last_dt_,
                      steps_.key, steps_.else_runs_away));
    }
  }
}

template <int dim>
Field ParticleModel<dim>::of_bodies(Field (ParticleBody<dim>::*part)() const) const {
  Field all(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    all.middleCols(first_[b], bodies_[b]->particles()) = (*bodies_[b].*part)();
  return all;
}

template <int dim>
Field ParticleModel<dim>::acceleration_by(const Field& load) const {
  Field all(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Eigen::Index count = bodies_[b]->particles();
    all.middleCols(first_[b], count) = bodies_[b]->acceleration_by(load.middleCols(first_[b], count));
  }
  return all;
}

template <int dim>
NodeLayout ParticleModel<dim>::layout() const {
  NodeLayout layout{.position = Field(dim, nodes()), .body = {}, .particle_body = {}};
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const Vec<dim>& x : bodies_[b]->grid().positions()) {
      layout.position.col(static_cast<Eigen::Index>(layout.body.size())) = x;
      layout.body.push_back(static_cast<int>(b));
    }
  layout.particle_body = layout.body;
  return layout;
}

template <int dim>
Field ParticleModel<dim>::inertia(const Field& acceleration) const {
  return bodies_.front()->particle_mass() * acceleration;  // one material and one spacing: equal masses
}

template <int dim>
double ParticleModel<dim>::max_speed() const {
  double fastest = 0;
  for (const auto& body : bodies_) fastest = std::max(fastest, body->velocity().colwise().norm().maxCoeff());
  return fastest;
}

template <int dim>
Energies ParticleModel<dim>::energies() const {
  Energies sum;
  for (const auto& body : bodies_) sum += body->energies(last_dt_);
  return sum;
}

template <int dim>
std::string ParticleModel<dim>::save() const {
  StateWriter state;
  state.put(last_dt_);
  for (const auto& body : bodies_) body->save(state);
  return state.take();
}

template <int dim>
void ParticleModel<dim>::restore(const std::string& state) {
  StateReader reader(state);
  reader.get(last_dt_);
  for (auto& body : bodies_) body->restore(reader);
  reader.finish();
}

template <int dim>
Snapshot ParticleModel<dim>::frame() const {
  Array position{.name = "solid_position", .unit = "m", .components = dim, .values = {}};
  Array velocity{.name = "solid_velocity", .unit = "m/s", .components = dim, .values = {}};
  Array stress{.name = "solid_von_mises", .unit = "Pa", .components = 1, .values = {}};
  for (const auto& body : bodies_) {
    const Field q = body->displacement(), v = body->velocity();
    for (Eigen::Index p = 0; p < q.cols(); ++p) {
      const auto particle = static_cast<std::size_t>(p);
      const Vec<dim> x = body->grid().positions()[particle] + q.col(p);
      for (int k = 0; k < dim; ++k) {
        position.values.push_back(static_cast<float>(x[k]));
        velocity.values.push_back(static_cast<float>(v(k, p)));
      }
      const Mat<dim> F = body->deformation_gradient(particle);
      stress.values.push_back(static_cast<float>(von_mises_stress<dim>(F, material_)));
    }
  }
  return {std::move(position), std::move(velocity), std::move(stress)};
}

template class ParticleModel<2>;
template class ParticleModel<3>;

}  // namespace cosurge::particles
