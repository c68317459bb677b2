// Estimates the ratio of the water's added mass to the structure's mass during a run.
#pragma once

#include "common/participant.hpp"
#include "coupler/interface_reader.hpp"

namespace cosurge {

/// mu: by how much a change of the acceleration that the water sees changes the acceleration that comes out,
/// with the opposite sign (docs/method.md, eq. 19). Where mu is near the limit of a weak scheme, the load
/// alternates from window to window.
class AddedMassRatio {
 public:
  /// Two passes through the same window: `velocity` that the water saw, `answer` of the structure.
  /// mu = - d answer . d velocity / |d velocity|^2. Ignored at rest.
  void iterated(const Field& velocity_change, const Field& answer_change);

  /// The next window, where every window is gone through once: the same from the changes of the acceleration
  /// between windows, as the mean over about `memory` windows. It is the ratio where the load rules the
  /// motion, and less where it does not.
  void passed(const Field& velocity, const Window& window);

  double value() const { return value_; }  ///< [-], >= 0; 0 as long as nothing is known

  void save(StateWriter& state) const;
  void restore(InterfaceReader& state);

  static constexpr double memory = 10;  ///< windows

 private:
  double value_ = 0;
  int seen_ = 0;        // windows, up to three
  Field velocity_;      // in the last window
  Field acceleration_;  // into it
  Field change_;        // change of that acceleration
  double product_ = 0;  // product of successive changes, faded
  double square_ = 0;   // square of changes, faded
};

}  // namespace cosurge
