#include "coupler/schemes/auto.hpp"

namespace cosurge {
namespace {

// Half of the gain at which `weak` becomes unstable: the gain -dg/dv is mu, mu / 2 and mu / 6, and the limits
// of mu are 1, 2 and 3 / 2 (docs/method.md, section 3).
double bearable_gain(const v1::Coupling& coupling) {
  const bool ramped_mean =
      coupling.load() == v1::Coupling::ramped && coupling.velocity() == v1::Coupling::mean;
  return ramped_mean ? 0.125 : 0.5;
}

constexpr double alternating = 1;  // limit of eq. (19); rounding alone gives 0.75

// `much`: least share of the work since the last probe that counts as created by the scheme. `negligible`:
// share of all work below which the work since the last probe is noise.
constexpr double much = 0.1, negligible = 1e-3;

}  // namespace

Auto::Auto(const v1::Coupling& coupling, Participants participants)
    : bearable_(bearable_gain(coupling)),
      weak_(coupling, participants),
      weak_inertial_(participants),
      strong_(coupling, participants) {}

Reports Auto::advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) {
  const bool due = window.index % probe_interval == 0;
  const bool probe = choice_ == strong || due;
  Scheme& scheme = probe ? strong_ : current();
  if (due) watch(account);
  Reports reports = scheme.advance(window, interface, account);
  effort_ = scheme.effort();
  if (probe || choice_ == weak_inertial) choose(strong_.has_modes());
  effort_.settled = choice_ == strong || (due && alternating_ == 0 && !creates_);
  return reports;
}

/// Finds whether the coupling has created work since the last probe.
void Auto::watch(const InterfaceAccount& account) {
  const double created = account.created() - created_, passed = account.passed() - passed_;
  creates_ =
      marked_ && choice_ != strong && created > much * passed && passed > negligible * account.passed();
  creating_ = creates_ ? creating_ + probe_interval : 0;
  created_ = account.created();
  passed_ = account.passed();
  marked_ = true;
}

void Auto::choose(bool has_modes) {
  const double gain = strong_.ratio().value();
  quiet_ = gain > bearable_ / 2 ? 0 : quiet_ + 1;
  alternating_ =
      choice_ == weak_inertial && weak_inertial_.ratio().value() > alternating ? alternating_ + 1 : 0;
  if (choice_ == weak && gain > bearable_) {
    change_to(has_modes ? weak_inertial : strong,
              fmt::format("velocity-error gain {:.2f} exceeds {:.2f}, the limit of scheme `weak`", gain,
                          bearable_));
  } else if (choice_ == weak_inertial && alternating_ >= loud_windows) {
    change_to(strong, "the acceleration alternates although the modes' added mass is included");
  } else if (creates_ && (choice_ == weak_inertial || creating_ >= loud_windows)) {
    change_to(strong,
              fmt::format("the coupling created more than {:.0f} % of the work done since the last check",
                          100 * much));
  } else if (choice_ != weak && quiet_ >= quiet_windows) {
    change_to(weak, fmt::format("velocity-error gain is only {:.2f}", gain));
  }
}

void Auto::change_to(Choice choice, const std::string& why) {
  effort_.again = choice > choice_;
  choice_ = choice;
  quiet_ = alternating_ = creating_ = 0;
  creates_ = marked_ = false;
  if (choice == weak_inertial) weak_inertial_.forget_ratio();
  constexpr std::array<const char*, 3> names = {"weak", "weak_inertial", "strong"};
  effort_.note = fmt::format("coupling scheme changes to {}: {}", names[choice], why);
}

void Auto::save(StateWriter& state) const {
  for (const Scheme* scheme : schemes_) scheme->save(state);
  for (const int number : {choice_, quiet_, alternating_, creating_}) state.put(number);
  for (const bool flag : {creates_, marked_}) state.put(flag);
  state.put(created_);
  state.put(passed_);
}

void Auto::restore(InterfaceReader& state) {
  for (Scheme* scheme : schemes_) scheme->restore(state);
  for (int* number : {&choice_, &quiet_, &alternating_, &creating_}) state.get(*number);
  require(choice_ >= weak && choice_ <= strong,
          "saved state: coupling scheme {}, must be 0 to 2; it is damaged", choice_);
  for (bool* flag : {&creates_, &marked_}) state.get(*flag);
  state.get(created_);
  state.get(passed_);
}

}  // namespace cosurge
