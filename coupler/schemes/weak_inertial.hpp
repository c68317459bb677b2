// Weak coupling with the added mass of the structure's lowest modes.
#pragma once

#include "coupler/scheme.hpp"

namespace cosurge {

/// First the solid computes the window under the last load, and gives its lowest modes; the fluid finds
/// the pressure of that motion, and with the same matrix the pressure of each mode, and so the load that is
/// consistent with the response of the modes (docs/method.md, eq. 20). Then the solid computes the window
/// again under that load. One step of the fluid per window, no iteration, and stable for any added mass of
/// the included modes; the others are coupled as with `weak`.
class WeakInertial : public Scheme {
 public:
  explicit WeakInertial(Participants participants) : participants_(participants) {}

  Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) override;

  void forget_ratio() { ratio_ = {}; }  ///< windows by another scheme have come between

  const Effort& effort() const override { return effort_; }
  const AddedMassRatio& ratio() const override { return ratio_; }
  void save(StateWriter& state) const override { ratio_.save(state); }
  void restore(InterfaceReader& state) override { ratio_.restore(state); }

 private:
  Participants participants_;
  Effort effort_;
  AddedMassRatio ratio_;
};

}  // namespace cosurge
