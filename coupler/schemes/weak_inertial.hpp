// Weak coupling with the added mass of the structure's lowest modes.
#pragma once

#include "coupler/scheme.hpp"

namespace cosurge {

/// First the solid computes the window under the last load, and returns its lowest modes. The fluid computes
/// the pressure for that motion and, with the same matrix, the pressure of each mode, and from these the load
/// that is consistent with the response of the modes (docs/method.md, eq. 20). Then the solid computes the
/// window again under that load. This takes one step of the fluid per window without iteration, and is stable
/// for any added mass of the included modes; the others are coupled as with `weak`.
class WeakInertial : public Scheme {
 public:
  explicit WeakInertial(Participants participants) : participants_(participants) {}

  Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) override;

  void forget_ratio() { ratio_ = {}; }  ///< after windows that were computed by another scheme

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
