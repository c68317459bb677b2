#include "coupler/conclusion.hpp"

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "coupler/checkpoint.hpp"
#include "coupler/lost_water.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

/// A linear model that has left its range.
void warn_of_deflection(const Recorder& recorder) {
  constexpr double small = small_deflection;
  const History* deflection = recorder.history("solid/largest_deflection");
  if (deflection == nullptr || deflection->max().value <= small) return;
  say("warning: unreliable result: a body bends by {:.3g} % of its length at t = {:.4g} s; "
      "the model modal is linear and valid up to {:.0f} %; use solid.model = \"fem\"\n",
      100 * deflection->max().value, deflection->max().time, 100 * small);
}

/// What makes the result less than it seems.
void remark(const Coupler& coupler, const Recorder& recorder) {
  for (const std::string& note : coupler.notes()) say("{}\n", note);
  if (const std::string lost = lost_water(recorder); !lost.empty()) say("{}\n", lost);
  if (coupler.unconverged() > 0)
    say("{} of {} windows did not converge in {} iterations: the nearest one counts\n", coupler.unconverged(),
        coupler.windows(), recorder.the_case().coupling().iteration().limit());
  if (const InterfaceAccount& account = coupler.account();
      account.created() > InterfaceAccount::much * account.passed())
    say("not to be trusted: the coupling scheme itself has put {:.2g} J into the system, where {:.2g} J have "
        "passed; take coupling.scheme = \"strong\" or what docs/stability.md has instead\n",
        account.created(), account.passed());
  warn_of_deflection(recorder);
}

/// Does what writes; where that fails, the run has failed, for a further reason perhaps.
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

/// How to go on with a run that has not finished. A computation that has broken down would do so again.
void advise(const std::filesystem::path& folder, bool broken_down, double checkpoint_time) {
  if (!std::filesystem::exists(folder / Checkpoint::name))
    say("there is no checkpoint to go on from: run the case again with another --out\n");
  else if (broken_down)
    say("cosurge resume {0} alone would fail at the same window. From t = {1:.6g} s on it may change "
        "time.window, "
        "coupling, fluid.courant, fluid.pressure and fluid.most_lost (--set); anything else needs a new "
        "run\n",
        folder.string(), checkpoint_time);
  else
    say("to go on: cosurge resume {}\n", folder.string());
}

}  // namespace

void conclude(const std::filesystem::path& folder, const Coupler& coupler, Recorder& recorder,
              double checkpoint_time, Outcome& outcome) {
  attempt(outcome, [&] { recorder.flush(); });
  attempt(outcome, [&] { write_summary(folder, recorder, outcome); });
  remark(coupler, recorder);
  say("{} at t = {:.6g} s after {} windows{}{}\n", outcome.status, coupler.time(), coupler.windows(),
      outcome.reason.empty() ? "" : ": ", outcome.reason);
  if (outcome.status != "finished") advise(folder, outcome.broken_down, checkpoint_time);
}

bool concluded(const std::filesystem::path& folder) {
  std::ifstream file(folder / "summary.json");
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  return summary.is_object() && summary.value("status", "") == "finished";
}

}  // namespace cosurge
