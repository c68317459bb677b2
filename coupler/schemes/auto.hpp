// The cheapest scheme that is stable.
#pragma once

#include <array>

#include "coupler/scheme.hpp"
#include "coupler/schemes/strong/strong.hpp"
#include "coupler/schemes/weak.hpp"
#include "coupler/schemes/weak_inertial.hpp"

namespace cosurge {

/// Starts as `weak`. Every tenth window is computed by `strong`, which measures the velocity-error gain: the
/// factor by which an error of the velocity is multiplied in a window. If the gain exceeds half of the limit
/// of `weak`, the run continues as `weak_inertial`; or as `strong` if the solid gives no modes, or if the
/// acceleration alternates. `weak` and `weak_inertial` also become `strong` if the coupling creates work. The
/// windows since the last quiet check are then repeated, so that the results contain no trace of the
/// instability. After many windows with a small gain the scheme is `weak` again (docs/method.md, section 3).
class Auto : public Scheme {
 public:
  Auto(const v1::Coupling& coupling, Participants participants);
  Auto(const Auto&) = delete;
  Auto& operator=(const Auto&) = delete;

  Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) override;

  const Effort& effort() const override { return effort_; }
  bool may_go_back() const override { return choice_ != strong; }
  const AddedMassRatio& ratio() const override { return current().ratio(); }
  void save(StateWriter& state) const override;
  void restore(InterfaceReader& state) override;

  static constexpr int probe_interval = 10;  ///< windows
  static constexpr int quiet_windows = 300;  ///< windows with a small gain, after which it is `weak` again
  /// Windows with an alternation after which `weak_inertial` becomes `strong`, and windows with created work
  /// after which `weak` does. (A structure that starts to move creates work for fewer: the water sees its
  /// last velocity.)
  static constexpr int loud_windows = 30;

 private:
  enum Choice : int { weak, weak_inertial, strong };

  Scheme& current() const { return *schemes_[static_cast<std::size_t>(choice_)]; }
  void choose(bool has_modes);
  void watch(const InterfaceAccount& account);
  void change_to(Choice choice, const std::string& why);

  double bearable_;  // gain above which `weak` is not used
  Weak weak_;
  WeakInertial weak_inertial_;
  Strong strong_;
  std::array<Scheme*, 3> schemes_ = {&weak_, &weak_inertial_, &strong_};  // by Choice
  int choice_ = weak;
  int quiet_ = 0;         // windows with a small gain
  int alternating_ = 0;   // windows in which the acceleration has alternated
  bool creates_ = false;  // the coupling created work before the last probe
  int creating_ = 0;      // windows for which it has done so without a break
  bool marked_ = false;   // whether a probe has set created_ and passed_ since the scheme was chosen
  double created_ = 0;    // work that the coupling had created at the last probe [J]
  double passed_ = 0;     // absolute work through the interface at the last probe [J]
  Effort effort_;
};

}  // namespace cosurge
