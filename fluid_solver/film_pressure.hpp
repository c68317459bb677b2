// The pressure of the film of water in gaps that are too narrow for particles.
#pragma once

#include <vector>

#include "fluid_solver/bodies.hpp"
#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// A film at rest has the pressure of the water around it: p - rho g . x, the height of a standpipe times rho
/// g, is continued from the open points of a body to those in the gap by Laplace's equation over the points
/// of its surface (weights 1 / r^2 between points of the same body that are at most 1.5 spacings apart).
template <int dim>
class FilmPressure {
 public:
  /// Finds which faces have a film: those of `film` points that `open` closes. `faces`: not yet closed.
  void find(const Bodies<dim>& bodies, const Faces<dim>& faces, const std::vector<Openness<dim>>& open,
            const std::vector<char>& film);

  /// Computes the pressures. `place`: of each point among the particles; `slope`: rho g [Pa/m]; `spacing`
  /// [m].
  void solve(const Bodies<dim>& bodies, const std::vector<std::int32_t>& place,
             const Particles<dim>& particles, const Vec<dim>& slope, double spacing);

  /// Particles of water in the gap: nearer than 1.2 spacings to a point whose faces a film covers. They have
  /// less room than a particle needs, so neither their density nor their divergence says anything about the
  /// water around.
  std::vector<int> particles_in_gap(const std::vector<std::int32_t>& place, const Particles<dim>& particles,
                                    const Neighbors<dim>& neighbors, double spacing) const;

  /// Load of the film on a point [N].
  Vec<dim> load(int point) const { return load_.empty() ? Vec<dim>(Vec<dim>::Zero()) : load_[point]; }

 private:
  std::vector<Vec<dim>> area_;  // of the film, by point; empty where there is none
  std::vector<int> points_;     // whose pressure is unknown
  std::vector<Vec<dim>> load_;
};

}  // namespace cosurge::fluid
