// Water that has left the tank: how much, and over which side.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/geometry/motion.hpp"
#include "common/participant.hpp"
#include "common/state_bytes.hpp"
#include "fluid_solver/particles.hpp"
#include "fluid_solver/water.hpp"

namespace cosurge::fluid {

/// Counts the water that has left the tank, by side.
template <int dim>
class LostWater {
 public:
  /// `particles`: those of the start.
  LostWater(const Water<dim>& water, const Particles<dim>& particles);

  /// Remembers where the water is, before a step.
  void before_step(const Particles<dim>& particles);

  /// Counts the particles that the step that ended at time `t` [s] has lost. Each counts at the side of the
  /// (possibly moving) tank where it was before the step: over or through a side wall, through the floor, or
  /// out of the top.
  /// @throws NumericalError where more than fluid.most_lost of the water is gone.
  void after_step(const Particles<dim>& particles, double t);

  /// Columns "lost_x_min", ...: particles lost at each side so far; "lost_over_rim": those of them that were
  /// above the top of the tank; "water": particles that are left.
  static std::vector<Column> columns();
  std::vector<double> values() const;

  void save(StateWriter& state) const;
  void restore(StateReader& state);

 private:
  static constexpr std::size_t sides = std::size_t{2} * dim;

  static std::string side_name(std::size_t side);
  std::size_t side_of(const Vec<dim>& at) const;
  double lost() const;
  std::string where() const;

  Box<dim> tank_;
  Motion<dim> motion_;
  double most_lost_;
  double water_;                      // particles at the start
  std::array<double, sides> lost_{};  // smaller, then larger side of each axis
  double over_rim_ = 0;
  std::vector<Vec<dim>> place_;  // positions of the water before the step, by id; valid where here_ is true
  std::vector<char> here_;       // whether the particle with this id was water before the step
};

}  // namespace cosurge::fluid
