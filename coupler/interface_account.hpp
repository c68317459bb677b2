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

  /// Before the solid gets the new load of a window.
  void open(const InterfaceState& interface);

  /// After the solid has moved. The load goes from f0 to f over the window on a ramp s: the work is
  /// f0 . (du - m) + f . m with m the integral of s du; a held load is f all the while. `seen` is the
  /// velocity that the water had for the load.
  void close(const InterfaceState& interface, const Field& seen, const Window& window);

  double work() const { return work_; }                  ///< done on the solid so far [J]
  double seen_work() const { return seen_work_; }        ///< the same by the fluid's account [J]
  double created() const { return work_ - seen_work_; }  ///< energy created by the coupling scheme [J]
  double passed() const { return passed_; }              ///< work of all windows, without signs [J]
  Eigen::VectorXd force() const { return load_.rowwise().sum(); }  ///< on the solid, in the last window [N]

  /// Limit of created() / passed() for a stable scheme. Stable runs stay below 0.01; unstable runs that are
  /// bounded by the cut-off of suction have 0.1 to 2.
  static constexpr double much = 0.05;

  static std::vector<Column> columns(int dimension);
  std::vector<double> values() const;

  void save(StateWriter& state) const;
  void restore(InterfaceReader& state);

 private:
  bool ramped_;
  double work_ = 0;
  double seen_work_ = 0;
  double passed_ = 0;
  Field load_;          // in the last window
  Field displacement_;  // at its start
};

}  // namespace cosurge
