// Weak coupling with the added mass of the structure's lowest modes.
#pragma once

#include "coupler/scheme.hpp"

namespace cosurge {

/// First the solid goes through the window under the last load, and tells its lowest modes; the fluid finds
/// the pressure of that motion, and with the same matrix the pressure of each mode, and so the load that
/// agrees with what the modes will answer (docs/method.md, eq. 20); then the solid goes through the window
/// again under that load. One step of the fluid a window, no iteration, and stable for any added mass of the
/// modes that are taken along; of the others as `weak`.
class WeakInertial : public Scheme {
 public:
  explicit WeakInertial(Participants participants) : participants_(participants) {}

  Reports advance(const Window& window, Surface& surface, InterfaceAccount& account) override;

  void forget_ratio() { ratio_ = {}; }  ///< windows by another scheme have come between

  const Effort& effort() const override { return effort_; }
  const AddedMassRatio& ratio() const override { return ratio_; }
  void save(StateWriter& state) const override { ratio_.save(state); }
  void restore(StateReader& state) override { ratio_.restore(state); }

 private:
  Participants participants_;
  Effort effort_;
  AddedMassRatio ratio_;
};

}  // namespace cosurge
