#include "coupler/converge/spacing_runs.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "coupler/results.hpp"
#include "coupler/study/run_quantities.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

/// Keys of the case that hold a spacing, and their values [m].
void find_spacings(const v1::Case& the_case, std::vector<std::string>& keys, std::vector<double>& values) {
  if (the_case.has_fluid()) keys.emplace_back("fluid.spacing"), values.push_back(the_case.fluid().spacing());
  if (the_case.has_solid() && the_case.solid().has_spacing())
    keys.emplace_back("solid.spacing"), values.push_back(the_case.solid().spacing());
  require(!keys.empty(), "the case has no spacing to refine; set solid.spacing");
}

}  // namespace

SpacingRuns::SpacingRuns(const ConvergeOptions& options) : options_(options) {
  const v1::Case the_case = load_case(options.case_path, options.overrides);
  find_spacings(the_case, keys_, key_spacings_);
  dimension_ = the_case.dimension();
  weighs_ =
      std::any_of(the_case.gravity().begin(), the_case.gravity().end(), [](double g) { return g != 0; });
  find_coarsest(key_spacings_.front());
  std::vector<std::string> wrong;
  for (const std::string& text : options.quantities)
    note_errors(wrong, [&] {
      quantities_.push_back(Quantity::read(text, the_case));
      require(quantities_.back().kind() != Quantity::Kind::rms,
              "--quantity {}: needs a true history; use peak, time_of_peak or impulse", text);
    });
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  units_.resize(quantities_.size());
  samples_.resize(quantities_.size());
  runs_ = std::make_unique<StudyRuns>(options.out);
}

void SpacingRuns::find_coarsest(double own) {
  constexpr int most = 16;
  const auto valid = [&](int multiple) {
    std::vector<std::string> overrides = options_.overrides;
    for (const std::string& setting : settings(own * multiple)) overrides.push_back(setting);
    try {
      (void)load_case(options_.case_path, overrides);
    } catch (const Error&) {
      return false;
    }
    return true;
  };
  int multiple = most;
  while (multiple > 1 && !valid(multiple)) --multiple;
  coarsest_ = own * multiple;
  if (multiple >= 3)
    first_ = {(multiple + 1) / 2, (3 * multiple + 3) / 4, multiple};
  else
    first_ = {1, 2};
  first_.erase(std::unique(first_.begin(), first_.end()), first_.end());
}

int SpacingRuns::at_least_as_fine(double spacing) const {
  return std::max(1, static_cast<int>(std::ceil(coarsest_ / spacing * (1 - 1e-9))));
}

int SpacingRuns::at_least_as_coarse(double spacing) const {
  return std::max(1, static_cast<int>(std::floor(coarsest_ / spacing * (1 + 1e-9))));
}

std::vector<std::string> SpacingRuns::settings(double spacing) const {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < keys_.size(); ++k)
    all.push_back(fmt::format("{}={:.12g}", keys_[k], key_spacings_[k] * (spacing / key_spacings_.front())));
  return all;
}

StudyPlan SpacingRuns::plan(int k, bool twice) const {
  StudyOptions study;
  study.case_path = options_.case_path;
  study.overrides = options_.overrides;
  study.over = settings(spacing(k));  // each an axis of one value
  study.scatter = twice && weighs_ ? 1 : 0;
  return read_plan(study);
}

void SpacingRuns::run(int k, bool twice) {
  const std::vector<FinishedRun> finished = runs_->run(plan(k, twice), options_.case_path, 1);
  for (const FinishedRun& run : finished) {
    require(run.finished, "the run with a spacing of {:.4g} m failed: {}", spacing(k), run.reason);
    const Results results(run.folder);
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      std::string unit;
      const double value = quantities_[q].value(history_of(results, quantities_[q], unit));
      units_[q] = quantities_[q].unit(unit);
      require(std::isfinite(value), "{} has no value with a spacing of {:.4g} m", quantities_[q].text(),
              spacing(k));
      samples_[q].push_back({.spacing = spacing(k), .value = value, .core_seconds = run.core_seconds});
    }
  }
  folders_.emplace(k, finished.front().folder.string());
}

}  // namespace cosurge
