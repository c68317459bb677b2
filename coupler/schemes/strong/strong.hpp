// Coupling that is iterated within a window.
#pragma once

#include "coupler/scheme.hpp"
#include "coupler/schemes/prediction.hpp"
#include "coupler/schemes/strong/relaxation.hpp"

namespace cosurge {

/// Fluid and solid go through the window again and again, each time from its start, until the velocity that
/// the solid answers is the one that the water saw, to a relative tolerance, and the load that it would get
/// by that difference is the load that it got, to the same. The water sees the bodies where they were at the
/// start of the window, in every iteration: so the free surface and the matrix of the pressure do not change,
/// and the load is a smooth function of the velocity but for suction, which is cut off. Where the iterations
/// run out, the window is gone through once more with the velocity that was nearest, and the effort says so.
/// Where nothing moves, one iteration is enough.
///
/// `strong_inertial` gives the water the structure's modes besides, as `weak_inertial` does: it sees the
/// velocity x + R (f - f_0), f its own load and R the modes' mobility, and what is iterated is x. At the end
/// it sees what the structure answers, whatever R; but only what the modes do not tell is left to the
/// iteration.
class Strong : public Scheme {
 public:
  Strong(const v1::Coupling& coupling, Participants participants);

  Reports advance(const Window& window, Surface& surface, InterfaceAccount& account) override;

  bool has_modes() const { return has_modes_; }  ///< whether the solid tells modes

  const Effort& effort() const override { return effort_; }
  const AddedMassRatio& ratio() const override { return ratio_; }
  void save(StateWriter& state) const override;
  void restore(StateReader& state) override;

 private:
  /// Once through the window, by both.
  struct Pass {
    Field asked;   // velocity given to the water
    Field seen;    // velocity that the water used, with the modes' response to its own load
    Field answer;  // velocity of the structure
    Field force;
    double residual() const { return (answer - seen).norm(); }
  };
  Reports pass(const Window& window, const Surface& start, const Field& velocity, Surface& surface);
  void learn(const Pass& now, const Pass& last);

  double tolerance_;
  int iterations_;
  Participants participants_;
  bool inertial_;
  std::vector<Mode> modes_;  // in this window; empty without inertial_
  Prediction prediction_;
  std::unique_ptr<Relaxation> relaxation_;
  bool has_modes_ = false;
  Effort effort_;
  AddedMassRatio ratio_;
  double stiffness_ = -1;  // |df| / |dv|, the largest between iterations of the last window [N s/m]; -1: none
};

}  // namespace cosurge
