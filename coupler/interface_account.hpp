// Work and force at the interface.
#pragma once

#include "coupler/interface_reader.hpp"
#include "coupler/interface_state.hpp"

namespace cosurge {

/// Work and force at the interface points, from exchanged values only. The solid keeps the same
/// account in its own unknowns; the two agree to rounding because loads are mapped with the transpose of
/// the motion's mapping. The work on the motion that the water used differs from it by the energy that the
/// coupling scheme creates or destroys.
class InterfaceAccount {
 public:
  explicit InterfaceAccount(bool ramped) : ramped_(ramped) {}

  /// Call it before the solid gets the new load of a window.
  void open(const InterfaceState& interface);

  /// Call it after the solid has moved. The load changes from f0 to f over the window with the ramp s: the
  /// work is f0 . (du - m) + f . m, with m the integral of s du (docs/method.md, eq. 16c); a held load is f
  /// over the whole window. `seen` is the velocity that the water used.
  void close(const InterfaceState& interface, const Field& seen, const Window& window);

  double work() const { return work_; }                  ///< done on the solid so far [J]
  double seen_work() const { return seen_work_; }        ///< work on the motion that the water used [J]
  double created() const { return work_ - seen_work_; }  ///< energy created by the coupling scheme [J]
  double passed() const { return passed_; }              ///< sum of the absolute work of all windows [J]
  Eigen::VectorXd force() const { return load_.rowwise().sum(); }  ///< on the solid, in the last window [N]

  /// Limit of created() / passed() for a stable scheme. Stable runs stay below 0.01; unstable runs that are
  /// bounded by the cut-off of suction have 0.1 to 2.
  static constexpr double much = 0.05;
  /// The same for energy that the scheme takes away. `weak` takes 9 % of the amplitude in a period of 100
  /// windows, and less than a tenth of the work that passes; an unstable run that ends in a collision takes
  /// as much as the work.
  static constexpr double much_taken = 0.2;

  static std::vector<Column> columns(int dimension);
  std::vector<double> values() const;

  void save(StateWriter& state) const;
  void restore(InterfaceReader& state);

 private:
  bool ramped_;
  double work_ = 0;
  double seen_work_ = 0;
  double passed_ = 0;
  Field load_;          // load in the last window
  Field displacement_;  // displacement at the start of the last window
};

}  // namespace cosurge
