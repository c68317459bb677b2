// The particles of one body on its lattice, and where they lie in arrays that a stencil walks by constant
// shifts.
#pragma once

#include <vector>

#include "solid_solver/models/particles/stencil.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge::particles {

/// Particles on the sites of a body are free, except in supports. Held particles fill its clamps as far as
/// free ones interact with them. All are stored in a padded block of the lattice: slots without a particle
/// are void, and the slot of a neighbour is that of the particle plus a constant that is the same for all
/// particles. Particles are numbered in the order of their slots.
template <int dim>
class BodyGrid {
 public:
  /// @param index of the body, for messages
  /// @throws Error for a body without free particles or thinner than two, and for a support without particles
  BodyGrid(const Body<dim>& body, std::size_t index, const Stencil<dim>& stencil);

  const std::vector<Vec<dim>>& positions() const {
    return positions_;
  }  ///< positions of all particles, held ones too [m]
  bool held(std::size_t particle) const { return held_[particle]; }  ///< in a clamp, along all axes
  const Axes<dim>& held_axes(std::size_t particle) const { return held_axes_[particle]; }
  Eigen::Index slot(std::size_t particle) const { return slots_[particle]; }

  Eigen::Index slots() const { return slot_count_; }  ///< length of arrays over slots
  Eigen::Index first_slot() const { return first_; }  ///< slots before it and from last_slot on are void
  Eigen::Index last_slot() const { return last_; }    ///< first_slot plus a multiple of `lanes`
  Eigen::Index shift(const SiteIndex<dim>& offset) const;

  /// The particle in a slot, or -1.
  long particle_in(Eigen::Index slot) const { return particle_of_slot_[static_cast<std::size_t>(slot)]; }
  /// The particle at a point that coincides with its site, or -1.
  long particle_at(const Vec<dim>& x) const;
  /// Particles whose sites lie less than `radius` from a point.
  std::vector<std::size_t> particles_near(const Vec<dim>& x, double radius) const;
  bool in_clamp(const Vec<dim>& x) const;
  /// For x outside the clamps and x + r0 in a clamp: the share of the way between them that lies outside it.
  double share_outside_clamps(const Vec<dim>& x, const Vec<dim>& r0) const;
  /// Whether x lies in the body's shape, its faces included.
  bool in_shape(const Vec<dim>& x) const;

  static constexpr Eigen::Index lanes = 8;

 private:
  SiteIndex<dim> index_of(const Vec<dim>& x) const;
  void check(std::size_t index) const;
  void number_slots(const std::vector<SiteIndex<dim>>& sites, int reach);

  double spacing_;
  Shape<dim> shape_;
  std::vector<Shape<dim>> clamps_;
  std::vector<Vec<dim>> positions_;
  std::vector<char> held_;
  std::vector<Axes<dim>> held_axes_;
  std::vector<Eigen::Index> slots_;
  std::vector<long> particle_of_slot_;  // -1 where void
  SiteIndex<dim> lower_, upper_;        // corners of the block of sites
  SiteIndex<dim> stride_;
  Eigen::Index first_ = 0, last_ = 0, slot_count_ = 0;
};

}  // namespace cosurge::particles
