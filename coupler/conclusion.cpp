#include "coupler/conclusion.hpp"

#include <functional>
#include <nlohmann/json.hpp>

#include "coupler/checkpoint.hpp"
#include "coupler/created_work.hpp"
#include "coupler/lost_water.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

/// The deflection history with the largest value among those of all modal structures; null if there is none.
const History* largest_deflection(const std::vector<History>& histories) {
  const History* largest = nullptr;
  for (const History& history : histories) {
    if (is_largest_deflection(history.name()) &&
        (largest == nullptr || history.max().value > largest->max().value))
      largest = &history;
  }
  return largest;
}

/// Warning that a linear model was used beyond its range.
void warn_of_deflection(const Recorder& recorder) {
  constexpr double small = small_deflection;
  const History* deflection = largest_deflection(recorder.histories());
  if (deflection == nullptr || deflection->max().value <= small) return;
  say("warning: unreliable result: a body bends by {:.3g} % of its length at t = {:.4g} s; "
      "the model modal is linear and valid up to {:.0f} %; use solid.model = \"fem\"\n",
      100 * deflection->max().value, deflection->max().time, 100 * small);
}

/// Warnings that limit the validity of the result.
void remark(const Coupler& coupler, const Recorder& recorder) {
  for (const std::string& note : coupler.notes()) say("{}\n", note);
  if (const std::string lost = lost_water(recorder); !lost.empty()) say("{}\n", lost);
  if (coupler.unconverged() > 0)
    say("warning: {} of {} windows did not converge in {} iterations (coupling.iteration.limit); the "
        "iteration with the smallest residual was used; lower time.window or raise the limit\n",
        coupler.unconverged(), coupler.windows(), recorder.the_case().coupling().iteration().limit());
  const InterfaceAccount& account = coupler.account();
  if (const std::string energy =
          created_work_remark(recorder.the_case(), account.created(), account.passed());
      !energy.empty())
    say("warning: unreliable result: {}; use coupling.scheme = \"strong\" or see docs/stability.md\n",
        energy);
  warn_of_deflection(recorder);
}

/// Calls `write`; if it fails, the run has failed, possibly for a further reason.
void attempt(Outcome& outcome, const std::function<void()>& write) {
  try {
    write();
  } catch (const std::exception& error) {
    const std::string reason = error.what();
    if (outcome.status == "finished") outcome.status = "failed";
    if (outcome.reason.find(reason) == std::string::npos)
      outcome.reason += (outcome.reason.empty() ? "" : "; ") + reason;
  }
}

/// How to continue a run that has not finished; empty after a failed computation, which would fail again.
void advise(const std::filesystem::path& folder, bool broken_down, double checkpoint_time) {
  if (!std::filesystem::exists(folder / Checkpoint::name))
    say("there is no checkpoint to resume from: run the case again with another --out\n");
  else if (broken_down)
    say("cosurge resume {0} without changes would fail at the same window. From t = {1:.6g} s on you may "
        "change time.window, coupling, fluid.courant, fluid.pressure and fluid.most_lost (--set); any other "
        "change needs a new run\n",
        folder.string(), checkpoint_time);
  else
    say("to resume: cosurge resume {}\n", folder.string());
}

}  // namespace

bool is_largest_deflection(const std::string& history) {
  return history.starts_with("solid/") && history.ends_with("/largest_deflection");
}

void conclude(const std::filesystem::path& folder, const Coupler& coupler, Recorder& recorder,
              double checkpoint_time, Outcome& outcome, bool quiet) {
  attempt(outcome, [&] { recorder.flush(); });
  attempt(outcome, [&] { write_summary(folder, recorder, outcome); });
  remark(coupler, recorder);
  if (quiet && outcome.status == "finished") return;
  say("{} at t = {:.6g} s after {} windows{}{}\n", outcome.status, coupler.time(), coupler.windows(),
      outcome.reason.empty() ? "" : ": ", outcome.reason);
  if (outcome.status != "finished") advise(folder, outcome.broken_down, checkpoint_time);
}

bool concluded(const std::filesystem::path& folder) {
  const auto summary = summary_in(folder);
  return summary.is_object() && summary.value("status", "") == "finished";
}

}  // namespace cosurge
