// A model of explicit particles with any law of forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "solid_solver/damping.hpp"
#include "solid_solver/models/particles/particle_body.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge::particles {

/// Nodes are the particles, held ones included, body after body.
template <int dim>
class ParticleModel : public SolidModel {
 public:
  using Bodies = std::vector<std::unique_ptr<ParticleBody<dim>>>;

  /// Sub-steps set in the case, and the longest stable one [s].
  struct Steps {
    std::string key;                  ///< key of the case's table: "solid.mps"
    double stable;                    ///< longest stable sub-step [s]
    double fraction;                  ///< sub-step as a share of the stable one
    double fixed = 0;                 ///< fixed sub-step [s]; 0: none
    std::string else_runs_away = {};  ///< further reason for instability, and a remedy
  };

  /// @throws Error for a fixed sub-step beyond the stable one.
  ParticleModel(Bodies bodies, const Elasticity& material, double spacing, const Steps& steps);

  /// The longest stable step [s].
  double stable_step() const { return steps_.stable; }

  Eigen::Index nodes() const override { return first_.back(); }
  std::uint64_t particles() const override { return static_cast<std::uint64_t>(nodes()); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  double substep() const override { return substep_; }
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return of_bodies(&ParticleBody<dim>::displacement); }
  Field velocity() const override { return of_bodies(&ParticleBody<dim>::velocity); }
  Field ramp_increment() const override { return of_bodies(&ParticleBody<dim>::ramp_increment); }
  Field acceleration_by(const Field& load) const override;
  NodeLayout layout() const override;
  Field inertia(const Field& acceleration) const override;
  double force_instant() const override { return bodies_.front()->force_instant(); }
  double max_speed() const override;
  Energies energies() const override;
  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override;

 private:
  using Row = std::vector<std::pair<std::size_t, double>>;

  Row interpolation_row(const BodyGrid<dim>& grid, const Vec<dim>& x) const;
  void check_motion(const Window& window) const;
  Field of_bodies(Field (ParticleBody<dim>::*part)() const) const;

  Bodies bodies_;
  Elasticity material_;
  double spacing_;
  Steps steps_;
  double substep_;
  double last_dt_ = 0;
  std::vector<Eigen::Index> first_;  // first node of each body, and the number of nodes
};

/// Longest stable step of explicit particles [s], central differences with the viscous force of the velocity
/// half a step before (S12, S41).
/// @param highest frequency [rad/s]
inline double stable_step(double highest, double retardation) {
  const double ratio = 0.5 * highest * retardation;  // damping ratio of the fastest motion
  return 2 / highest * (std::sqrt(1 + ratio * ratio) - ratio);
}

/// The model of a structure's bodies. `make_body(body, number, stencil, substance)` makes a ParticleBody that
/// states its highest_frequency() [rad/s]; `key` is the model's table in the case: "solid.mps".
template <int dim, typename MakeBody>
std::unique_ptr<SolidModel> make_particle_model(const Structure<dim>& structure,
                                                const ParticleParameters& parameters, const std::string& key,
                                                MakeBody&& make_body,
                                                const std::string& else_runs_away = {}) {
  const double spacing = structure.spacing;
  const Stencil<dim> stencil = full_stencil<dim>(spacing, parameters.re);
  const Elasticity& material = structure.material;
  const std::vector<double> damping = damping_rates(structure);
  typename ParticleModel<dim>::Bodies bodies;
  const double retardation = parameters.viscosity * spacing / material.pressure_speed();  // (S40)
  double highest = 0;
  for (std::size_t b = 0; b < structure.bodies.size(); ++b) {
    auto body = make_body(structure.bodies[b], b, stencil,
                          Substance<dim>{.material = material,
                                         .gravity = structure.gravity,
                                         .damping_rate = damping[b],
                                         .retardation = retardation});
    highest = std::max(highest, body->highest_frequency());
    bodies.push_back(std::move(body));
  }
  return std::make_unique<ParticleModel<dim>>(
      std::move(bodies), material, spacing,
      typename ParticleModel<dim>::Steps{.key = key,
                                         .stable = stable_step(highest, retardation),
                                         .fraction = parameters.step_fraction,
                                         .fixed = parameters.substep,
                                         .else_runs_away = else_runs_away});
}

}  // namespace cosurge::particles
