#include "solid_solver/models/sprung/sprung_model.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/geometry/body_sites.hpp"

namespace cosurge::sprung {

template <int dim>
SprungModel<dim>::SprungModel(const Structure<dim>& structure, const SprungParameters<dim>& parameters) {
  for (std::size_t b = 0; b < structure.bodies.size(); ++b) {
    const Shape<dim>& shape = structure.bodies[b].shape;
    bodies_.emplace_back(shape, b, parameters, structure.material.density, structure.gravity,
                         structure.bodies[b].velocity);
    const BodySites<dim> sites(shape, structure.spacing);
    for (const Vec<dim>& x : sites.all())
      sites_.push_back({.body = b, .position = x, .coefficients = bodies_.back().coefficients(x)});
  }
}

template <int dim>
Interpolation SprungModel<dim>::interpolation(const Field& position, const std::vector<int>& body) const {
  Interpolation H(position.cols(), nodes());
  for (Eigen::Index point = 0; point < position.cols(); ++point) {
    const auto b = static_cast<std::size_t>(body[static_cast<std::size_t>(point)]);
    const auto c = bodies_.at(b).coefficients(position.col(point));
    for (int k = 0; k < per_body; ++k) H.insert(point, static_cast<Eigen::Index>(b) * per_body + k) = c[k];
  }
  return H;
}

template <int dim>
int SprungModel<dim>::advance(const Window& window, const NodalLoad& load) {
  int substeps = 1;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto first = static_cast<Eigen::Index>(b) * per_body;
    const int taken = bodies_[b].advance(window.size, load.first.middleCols(first, per_body),
                                         load.last.middleCols(first, per_body));
    substeps = std::max(substeps, taken);
    if (!std::isfinite(bodies_[b].energies().kinetic))
      throw NumericalError(
          fmt::format("solid: the speed of body {} is not finite in the window from t = {:.6g} s: its load "
                      "is unstable (use a shorter time.window, or a heavier body)",
                      b, window.start));
  }
  total_load_ = load.last.rowwise().sum();
  return substeps;
}

template <int dim>
Field SprungModel<dim>::of_bodies(Field (SprungBody<dim>::*part)() const) const {
  Field all(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    all.middleCols(static_cast<Eigen::Index>(b) * per_body, per_body) = (bodies_[b].*part)();
  return all;
}

template <int dim>
std::vector<NodalMode> SprungModel<dim>::modes(int count) const {
  std::vector<NodalMode> all;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    std::vector<NodalMode> own = bodies_[b].modes();
    own.resize(std::min(own.size(), static_cast<std::size_t>(count)));
    for (NodalMode& mode : own) {
      Field shape = Field::Zero(dim, nodes());
      shape.middleCols(static_cast<Eigen::Index>(b) * per_body, per_body) = mode.shape;
      all.push_back({.shape = shape, .mass = mode.mass, .omega_squared = mode.omega_squared});
    }
  }
  return all;
}

template <int dim>
Field SprungModel<dim>::acceleration_by(const Field& load) const {
  Field all = Field::Zero(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto own = static_cast<Eigen::Index>(b) * per_body;
    for (const NodalMode& mode : bodies_[b].modes())
      all.middleCols(own, per_body) +=
          mode.shape.cwiseProduct(load.middleCols(own, per_body)).sum() / mode.mass * mode.shape;
  }
  return all;
}

template <int dim>
NodeLayout SprungModel<dim>::layout() const {
  NodeLayout layout{.position = of_bodies(&SprungBody<dim>::position), .body = {}, .particle_body = {}};
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    layout.body.insert(layout.body.end(), per_body, static_cast<int>(b));
  for (const Site& site : sites_) layout.particle_body.push_back(static_cast<int>(site.body));
  return layout;
}

template <int dim>
Field SprungModel<dim>::inertia(const Field& acceleration) const {
  Field all(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto own = static_cast<Eigen::Index>(b) * per_body;
    all.middleCols(own, per_body) = bodies_[b].inertia(acceleration.middleCols(own, per_body));
  }
  return all;
}

template <int dim>
double SprungModel<dim>::max_speed() const {
  double fastest = 0;
  for (const auto& body : bodies_) fastest = std::max(fastest, body.max_speed());
  return fastest;
}

template <int dim>
Energies SprungModel<dim>::energies() const {
  Energies sum;
  for (const auto& body : bodies_) sum += body.energies();
  return sum;
}

template <int dim>
std::vector<Column> SprungModel<dim>::columns() const {
  std::vector<Column> columns;
  for (int k = 0; k < dim; ++k) columns.push_back({std::string("load_") + "xyz"[k], "N"});
  return columns;
}

template <int dim>
std::vector<double> SprungModel<dim>::values() const {
  return {total_load_.begin(), total_load_.end()};
}

template <int dim>
std::string SprungModel<dim>::save() const {
  StateWriter state;
  for (const auto& body : bodies_) body.save(state);
  state.put(total_load_);
  return state.take();
}

template <int dim>
void SprungModel<dim>::restore(const std::string& text) {
  StateReader state(text);
  for (auto& body : bodies_) body.restore(state);
  state.get(total_load_);
  state.finish();
}

template <int dim>
Snapshot SprungModel<dim>::frame() const {
  Array position{.name = "solid_position", .unit = "m", .components = dim, .values = {}};
  Array velocity{.name = "solid_velocity", .unit = "m/s", .components = dim, .values = {}};
  std::vector<Field> displacements, velocities;
  for (const auto& body : bodies_) {
    displacements.push_back(body.displacement());
    velocities.push_back(body.velocity());
  }
  for (const Site& site : sites_) {
    const Vec<dim> x = site.position + displacements[site.body] * site.coefficients;
    const Vec<dim> v = velocities[site.body] * site.coefficients;
    for (int k = 0; k < dim; ++k) {
      position.values.push_back(static_cast<float>(x[k]));
      velocity.values.push_back(static_cast<float>(v[k]));
    }
  }
  return {std::move(position),
          std::move(velocity),
          {.name = "solid_von_mises",
           .unit = "Pa",
           .components = 1,
           .values = std::vector<float>(sites_.size())}};
}

template class SprungModel<2>;
template class SprungModel<3>;

}  // namespace cosurge::sprung
