// Estimates the ratio of the water's added mass to the structure's mass during a run.
#pragma once

#include "common/participant.hpp"
#include "coupler/interface_reader.hpp"

namespace cosurge {

/// mu: the negative ratio of the change of the structure's acceleration to the change of the acceleration
/// that the water used (docs/method.md, eq. 19). Where mu is near the limit of a weak scheme, the load
/// alternates from window to window.
class AddedMassRatio {
 public:
  /// Updates mu from two passes through the same window: `velocity` that the water used, `answer` of the
  /// structure. mu = - d answer . d velocity / |d velocity|^2. Ignored at rest.
  void iterated(const Field& velocity_change, const Field& answer_change);

  /// Updates mu from the next window of a scheme that computes every window once, from the changes of the
  /// acceleration between windows, as the mean over about `memory` windows. The value is mu if the load
  /// dominates the motion, and smaller otherwise.
  void passed(const Field& velocity, const Window& window);

  double value() const { return value_; }  ///< [-], >= 0; 0 while nothing is known

  void save(StateWriter& state) const;
  void restore(InterfaceReader& state);

  static constexpr double memory = 10;  ///< windows

 private:
  double value_ = 0;
  int seen_ = 0;        // number of windows so far, at most three
  Field velocity_;      // velocity in the last window
  Field acceleration_;  // acceleration from the window before into the last one
  Field change_;        // last change of the acceleration
  double product_ = 0;  // sum of the products of successive changes, weighted with the memory
  double square_ = 0;   // sum of the squares of the changes, weighted likewise
};

}  // namespace cosurge
