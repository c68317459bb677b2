// Several structures in one water, as one solid.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/participant.hpp"

namespace cosurge {

/// Gives each structure of a case with several [[solid]] its own case and its points of the interface, and
/// joins their motions, modes, columns, frames and states. The structures advance one after the other. Errors
/// and notes begin with the name of the structure. There is no contact between structures: a note reports it
/// when two overlap.
///
/// Columns get the name of the structure in front ("hull/kinetic_energy"), except those of probes; the group
/// adds the energies, works, steps and seconds of all, under the names that a single structure has
/// ("kinetic_energy"). A frame has the arrays of all structures, with the particles of one after those of the
/// other; an array that a structure does not have is zero there.
class SolidGroup : public Solid {
 public:
  struct Entry {
    std::string name;
    Solid* solid;
  };

  /// `solids`: in the order of the case; must outlive the group.
  explicit SolidGroup(const std::vector<Entry>& solids);

  /// The program of all structures if it is the same one; otherwise all programs with the names of their
  /// structures.
  Identity identity() const override;
  Setup initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                   InterfaceMotion& motion) override;
  Report advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) override;
  std::string save() override;
  void restore(const std::string& state) override;
  Snapshot frame() override;
  void finalize() override;

 private:
  /// A structure and its share of the interface.
  struct Part {
    std::string name;
    Solid* solid;
    std::vector<Eigen::Index> points = {};  // indices of its points among those of all
    InterfaceLoad load = {};
    InterfaceMotion motion = {};
    std::vector<double> values = {};  // values of the last window
  };

  /// A column that all structures have: its index in the columns of each.
  using Sum = std::vector<std::size_t>;

  void add_sums(const std::vector<Setup>& setups, Setup& setup);
  void give(const InterfaceLoad& load, Part& part) const;
  void take(const Part& part, InterfaceMotion& motion) const;

  void watch(const Window& window, const InterfaceMotion& motion, Report& report);

  std::vector<Part> parts_;
  std::vector<Sum> sums_;
  Field places_;                      // positions of the points in the reference configuration [m]
  std::vector<int> structure_;        // number of the part of each point
  double spacing_ = 0;                // spacing of the points [m]
  std::optional<std::uint64_t> met_;  // window in which two structures were first found to overlap
};

}  // namespace cosurge
