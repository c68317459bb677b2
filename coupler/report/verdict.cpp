// One line on the reliability of a run, from its results; the same warnings as
// at the end of the run (coupler/conclusion.cpp).
#include <fmt/ranges.h>

#include <cmath>

#include "coupler/conclusion.hpp"
#include "coupler/created_work.hpp"
#include "coupler/report/run_numbers.hpp"

namespace cosurge {
namespace {

/// Work through the interface, without signs.
double passed(const RunRecord& run) {
  double sum = 0;
  if (const Series* work = run.find("coupling/work_points"))
    for (std::size_t k = 1; k < work->values.size(); ++k)
      sum += std::abs(work->values[k] - work->values[k - 1]);
  return sum;
}

class Remarks {
 public:
  void bad(const std::string& text) { add(text, "bad"); }
  void doubt(const std::string& text) { add(text, level_ == "good" ? "doubt" : level_); }

  nlohmann::ordered_json verdict(const std::string& otherwise) const {
    return {{"level", level_},
            {"text", texts_.empty() ? otherwise : fmt::format("{}", fmt::join(texts_, "; "))}};
  }

 private:
  void add(const std::string& text, const std::string& level) {
    texts_.push_back(text);
    level_ = level;
  }

  std::string level_ = "good";
  std::vector<std::string> texts_;
};

void remark_on_end(const RunRecord& run, const v1::Case& the_case, Remarks& remarks) {
  const std::string state = run.summary.value("status", "");
  const double time = run.rows() > 0 ? run.time().back() : 0;
  const std::string reason = run.summary.value("reason", "");
  const std::string place = fmt::format("at t = {:.6g} of {:g} s", time, the_case.time().end());
  if (state == "failed") remarks.bad(fmt::format("failed {}: {}", place, reason));
  if (state == "interrupted") remarks.doubt(fmt::format("interrupted {}", place));
  if (state.empty()) remarks.doubt(fmt::format("not finished, {}: it is running, or was killed", place));
}

void remark_on_water(const RunRecord& run, const v1::Case& the_case, Remarks& remarks) {
  const double lost = run.last("fluid/lost"), left = run.last("fluid/water");
  if (lost > 0) {
    const double share = lost / (lost + left);
    const std::string text =
        fmt::format("{:.2g} % of the water has left the tank (particles: {:.0f})", 100 * share, lost);
    share > the_case.fluid().most_lost() ? remarks.bad(text) : remarks.doubt(text);
  }
  if (const double inside = run.most("fluid/inside_bodies"); inside > 0)
    remarks.doubt(fmt::format("up to {:.0f} water particles were inside a body", inside));
}

void remark_on_coupling(const RunRecord& run, const v1::Case& the_case, Remarks& remarks) {
  if (const double windows = run.last("coupling/unconverged"); windows > 0)
    remarks.doubt(fmt::format("{:.0f} of {} windows did not converge", windows, run.rows()));
  if (const std::string energy =
          created_work_remark(the_case, run.last("coupling/work_created"), passed(run));
      !energy.empty())
    remarks.bad(energy);
  constexpr double small = small_deflection;
  double bent = 0;
  for (const Series& history : run.histories)
    if (is_largest_deflection(history.name)) bent = std::max(bent, run.most(history.name));
  if (bent > small)
    remarks.bad(fmt::format("a body bends by {:.3g} % of its length; the model modal is valid up to {:.0f} %",
                            100 * bent, 100 * small));
}

}  // namespace

nlohmann::ordered_json verdict(const RunRecord& run, const v1::Case& the_case) {
  Remarks remarks;
  remark_on_end(run, the_case, remarks);
  remark_on_water(run, the_case, remarks);
  remark_on_coupling(run, the_case, remarks);
  return remarks.verdict("finished; no water lost, no warnings from the coupling or a model");
}

}  // namespace cosurge
