// Force of the water on walls and bodies besides its pressure: friction, and collisions with faces.
#pragma once

#include <vector>

#include "fluid_solver/collision.hpp"
#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/viscosity.hpp"

namespace cosurge::fluid {

/// Reaction to eqs. (7a) and (8): what these terms take from the momentum of the water, walls and bodies get.
template <int dim>
class DirectForce {
 public:
  /// Forgets the last step. `particles`: their number.
  void clear(int particles);

  /// Notes that faces stop or push water particle i in this step; may be called by several threads, once for
  /// each i.
  void note_struck(int i) { struck_[static_cast<std::size_t>(i)] = 1; }

  /// Adds the collisions of the noted particles. `mass`: of a particle [kg], `dt`: of the step [s].
  void add_collisions(const Particles<dim>& particles, const Neighbors<dim>& neighbors,
                      const CollisionLaw& law, double mass, double dt);

  /// Notes that water particle i rubs on a face; may be called by several threads, once for each i.
  void note_rubbing(int i) { rubs_[static_cast<std::size_t>(i)] = 1; }

  /// Adds the friction of eq. (8) of the noted particles. Layers behind a face give theirs to its nearest
  /// point. `factor`: mass of a particle times 2 d nu / (lambda0 n0) [kg/s]; `spacing`, `kick`: as for
  /// face_before() and beyond_face().
  void add_friction(const Particles<dim>& particles, const Neighbors<dim>& neighbors, double spacing,
                    const Vec<dim>& kick, double factor);

  /// On the particle of a wall or body at this place [N]; zero before the first step.
  Vec<dim> on(int place) const {
    return force_.empty() ? Vec<dim>(Vec<dim>::Zero()) : force_[static_cast<std::size_t>(place)];
  }

 private:
  std::vector<Vec<dim>> force_;
  std::vector<char> struck_;
  std::vector<char> rubs_;
};

}  // namespace cosurge::fluid
