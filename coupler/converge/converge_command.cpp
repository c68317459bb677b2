#include "coupler/converge/converge_command.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "common/error.hpp"
#include "coupler/case_grid.hpp"
#include "coupler/converge/spacing_runs.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/say.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// What the user asks for.
struct Aim {
  std::optional<double> error;      // relative
  double core_seconds = unlimited;  // of one run
};

/// A number and what follows it.
std::optional<std::pair<double, std::string>> number_and_unit(const std::string& text) {
  const std::string plain = without_blanks(text);
  const auto end = plain.find_first_not_of("0123456789.eE+-");
  const auto number = number_of(plain.substr(0, end));
  if (!number || *number <= 0) return std::nullopt;
  return std::pair{*number, end == std::string::npos ? "" : plain.substr(end)};
}

double read_error(const std::string& text) {
  const auto read = number_and_unit(text);
  require(read && (read->second == "%" || read->second.empty()),
          "--accuracy {}: must be a relative error such as 2% or 0.02", text);
  const double error = read->second == "%" ? read->first / 100 : read->first;
  require(error < 1, "--accuracy {}: must be below 100 %", text);
  return error;
}

double read_seconds(const std::string& text) {
  const auto read = number_and_unit(text);
  for (const auto& [unit, seconds] : {std::pair{"s", 1.0}, std::pair{"min", 60.0}, std::pair{"h", 3600.0}})
    if (read && read->second == unit) return read->first * seconds;
  throw Error(fmt::format("--budget {}: must be a time with its unit, such as 90s, 10min or 2h", text));
}

Aim read_aim(const ConvergeOptions& options) {
  Aim aim;
  std::vector<std::string> wrong;
  if (options.accuracy.empty() && options.budget.empty())
    wrong.emplace_back(
        "--accuracy or --budget is missing: the relative error or the core time that is wanted");
  if (!options.accuracy.empty()) note_errors(wrong, [&] { aim.error = read_error(options.accuracy); });
  if (!options.budget.empty()) note_errors(wrong, [&] { aim.core_seconds = read_seconds(options.budget); });
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  return aim;
}

std::string time_words(double seconds) {
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  return seconds < 7200 ? fmt::format("{:.3g} min", seconds / 60) : fmt::format("{:.3g} h", seconds / 3600);
}

/// Relative errors, the costs and the choice that follow from the runs so far.
class Prediction {
 public:
  explicit Prediction(const SpacingRuns& runs) : runs_(runs), cost_(runs.samples(0), runs.dimension()) {
    for (std::size_t q = 0; q < runs.quantities().size(); ++q) fits_.emplace_back(runs.samples(q));
  }

  double core_seconds(int k) const { return cost_.core_seconds(runs_.spacing(k)); }

  /// Of the quantity with the largest.
  double error(int k) const {
    double largest = 0;
    for (const SpacingFit& fit : fits_) largest = std::max(largest, fit.error(runs_.spacing(k)));
    return largest;
  }

  const SpacingFit& fit(std::size_t quantity) const { return fits_[quantity]; }

  /// The coarsest spacing with this error, not coarser than the first runs. @throws Error where none has it.
  int for_error(double error) const {
    double spacing = unlimited;
    for (std::size_t q = 0; q < fits_.size(); ++q) {
      const double own = fits_[q].spacing_for(error);
      require(
          own > 0,
          "{}: its values scatter by {:.2g} % about a straight line over the spacing, more than the accuracy "
          "of {:.2g} %: ask for less, take a quantity that varies less from run to run (an impulse), or "
          "lower "
          "fluid.spacing",
          runs_.quantities()[q].text(), 100 * fits_[q].scatter(), 100 * error);
      spacing = std::min(spacing, own);
    }
    return std::max(runs_.first().front(), runs_.at_least_as_fine(spacing));
  }

  /// The finest spacing within this cost. @throws Error where it is coarser than the first runs.
  int for_cost(double core_seconds) const {
    const int k = runs_.at_least_as_coarse(cost_.spacing_for(core_seconds));
    require(k >= runs_.first().front(),
            "--budget: a run with the spacing of {:.4g} m takes {}; raise the budget",
            runs_.spacing(runs_.first().front()), time_words(this->core_seconds(runs_.first().front())));
    return k;
  }

 private:
  const SpacingRuns& runs_;
  CostFit cost_;
  std::vector<SpacingFit> fits_;
};

/// The coarse runs. With a budget the cost of each but the first is estimated before it runs.
void run_first(SpacingRuns& runs, double budget) {
  const int coarsest = runs.first().front();
  for (const int k : runs.first()) {
    if (k != coarsest) {
      const double so_far = runs.samples(0).front().core_seconds;
      const double next = so_far * std::pow(static_cast<double>(k) / coarsest, runs.dimension() + 1);
      require(
          next <= budget,
          "--budget: the run with {:.4g} m takes {}, that with {:.4g} m about {}, and both are needed for an "
          "estimate; raise the budget, or raise fluid.spacing (and round the boxes to whole spacings)",
          runs.spacing(coarsest), time_words(so_far), runs.spacing(k), time_words(next));
    }
    runs.run(k, true);
  }
}

int choose(const Aim& aim, const SpacingRuns& runs, const Prediction& prediction) {
  if (!aim.error) return prediction.for_cost(aim.core_seconds);
  const int k = prediction.for_error(*aim.error);
  if (prediction.core_seconds(k) <= aim.core_seconds || runs.has(k)) return k;
  const int within = prediction.for_cost(aim.core_seconds);
  throw Error(
      fmt::format("an error of {:.2g} % needs a spacing of {:.4g} m and about {}, beyond the budget of {}, "
                  "which allows {:.4g} m with an error of {:.2g} %; raise --budget or --accuracy",
                  100 * *aim.error, runs.spacing(k), time_words(prediction.core_seconds(k)),
                  time_words(aim.core_seconds), runs.spacing(within), 100 * prediction.error(within)));
}

void say_expected(const SpacingRuns& runs, const Prediction& prediction, int k) {
  say("\nexpected with {:.4g} m: {} of core time\n", runs.spacing(k), time_words(prediction.core_seconds(k)));
  for (std::size_t q = 0; q < runs.quantities().size(); ++q)
    say("  {:<28} {:.5g} {}, error {:.2g} %\n", runs.quantities()[q].text(),
        prediction.fit(q).value(runs.spacing(k)), runs.units()[q],
        100 * prediction.fit(q).error(runs.spacing(k)));
}

/// The value of the last run, with the error that all runs together suggest. Returns the largest error.
double say_reached(const SpacingRuns& runs, const Prediction& before, int k) {
  const Prediction after(runs);
  const SpacingSample& last = runs.samples(0).back();
  if (runs.spacing(k) == last.spacing)
    say("\ncomputed with {:.4g} m: {} of core time, {:.2g} of the expected\n", runs.spacing(k),
        time_words(last.core_seconds), last.core_seconds / before.core_seconds(k));
  for (std::size_t q = 0; q < runs.quantities().size(); ++q) {
    const auto& samples = runs.samples(q);
    const auto own = std::find_if(samples.begin(), samples.end(), [&](const SpacingSample& sample) {
      return sample.spacing == runs.spacing(k);
    });
    say("  {:<28} {:.5g} {}, error {:.2g} % with this run; for a spacing of zero {:.5g} {}\n",
        runs.quantities()[q].text(), own->value, runs.units()[q], 100 * after.fit(q).error(runs.spacing(k)),
        after.fit(q).limit(), runs.units()[q]);
  }
  return after.error(k);
}

/// One run a line: spacing, cost, quantities.
std::string csv_of(const SpacingRuns& runs, const std::string& note) {
  std::string text = "# " + note + "\nspacing [m],core_seconds";
  for (std::size_t q = 0; q < runs.quantities().size(); ++q)
    text +=
        fmt::format(",{}", quoted_cell(fmt::format("{} [{}]", runs.quantities()[q].text(), runs.units()[q])));
  for (std::size_t k = 0; k < runs.samples(0).size(); ++k) {
    text += fmt::format("\n{:.8g},{:.4g}", runs.samples(0)[k].spacing, runs.samples(0)[k].core_seconds);
    for (std::size_t q = 0; q < runs.quantities().size(); ++q)
      text += fmt::format(",{:.8g}", runs.samples(q)[k].value);
  }
  return text + "\n";
}

/// Runs until the chosen spacing is at most twice as fine as the finest that has run: neither line nor power
/// holds farther. The last of these runs costs about a tenth of the chosen one. Returns the choice.
int approach(const Aim& aim, SpacingRuns& runs) {
  for (;;) {
    const int k = choose(aim, runs, Prediction(runs)), next = 2 * runs.finest();
    if (k <= next) return k;
    say("\n{:.4g} m seem to be needed; {:.4g} m come first\n", runs.spacing(k), runs.spacing(next));
    runs.run(next, false);
  }
}

}  // namespace

int converge_command(const ConvergeOptions& options) {
  const Aim aim = read_aim(options);
  SpacingRuns runs(options);
  run_first(runs, aim.core_seconds);
  const int k = approach(aim, runs);
  const Prediction before(runs);
  say_expected(runs, before, k);
  if (!runs.has(k)) runs.run(k, false);
  const double reached = say_reached(runs, before, k);
  const auto csv = std::filesystem::path(options.out) / "converge.csv";
  replace_file(csv, {csv_of(runs, options.note)});
  say("{}; the results are in {}\n", csv.string(), runs.folder(k));
  if (!aim.error || reached <= *aim.error) return 0;
  say("the error of {:.2g} % is above the {:.2g} % that were asked for: repeat with a fluid.spacing of "
      "{:.4g} m\n",
      100 * reached, 100 * *aim.error, runs.spacing(k));
  return 1;
}

}  // namespace cosurge
