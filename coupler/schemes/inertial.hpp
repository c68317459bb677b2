// Common code of the schemes with the structure's added mass.
#pragma once

#include "coupler/scheme.hpp"

namespace cosurge {

/// Computes the solid's first attempt at a window, under the last load of the interface. Fills its motion and
/// its modes.
inline void predict_motion(const Participants& participants, const Window& window,
                           InterfaceState& interface) {
  Window attempt = window;
  attempt.attempt = Attempt::first;
  participants.solid->advance(attempt, interface.load, interface.motion);
}

/// The change of the modes' velocity by the difference between a load and the predicted load [m/s].
inline Field velocity_of(const std::vector<Mode>& modes, const Field& force) {
  Field velocity = Field::Zero(force.rows(), force.cols());
  for (const Mode& mode : modes)
    velocity += mode.mobility * (mode.shape.cwiseProduct(force).sum() - mode.load) * mode.shape;
  return velocity;
}

}  // namespace cosurge
