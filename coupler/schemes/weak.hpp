// Conventional serial staggered coupling.
#pragma once

#include "coupler/scheme.hpp"
#include "coupler/schemes/prediction.hpp"

namespace cosurge {

/// As Amaro & Cheng: the fluid steps with the motion of the solid at the end of the last window, then the
/// solid computes the same window in sub-cycles under the resulting load. There is one exchange per window.
/// Unstable if the added mass exceeds the mass of the solid by a factor near one, for any window (Causin,
/// Gerbeau & Nobile 2005, doi 10.1016/j.cma.2004.12.005; docs/stability.md has the factors).
class Weak : public Scheme {
 public:
  Weak(const v1::Coupling& coupling, Participants participants)
      : participants_(participants), prediction_(coupling.prediction()) {}

  Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) override;

  const Effort& effort() const override { return effort_; }
  const AddedMassRatio& ratio() const override { return ratio_; }
  void save(StateWriter& state) const override;
  void restore(InterfaceReader& state) override;

 private:
  Participants participants_;
  Prediction prediction_;
  Effort effort_;
  AddedMassRatio ratio_;
};

}  // namespace cosurge
