#include "coupler/chart/chart_command.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "common/error.hpp"
#include "coupler/chart/chart_table.hpp"
#include "coupler/chart/truth.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/say.hpp"
#include "coupler/study/run_quantities.hpp"
#include "coupler/study/runs.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// The checked options of a chart, before any run.
struct Request {
  StudyPlan plan;
  std::vector<Quantity> quantities;
  Truths truths;
  std::size_t truth_run = none;  // the run that --truth KEY=VALUE chooses

  explicit Request(const ChartOptions& options);
};

/// The one setting of the plan with all of these values.
std::size_t run_with(const StudyPlan& plan, const std::vector<std::string>& settings) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    const auto& own = plan.runs[k].settings;
    const bool all = std::all_of(settings.begin(), settings.end(), [&](const std::string& setting) {
      return std::find(own.begin(), own.end(), setting) != own.end();
    });
    if (all && plan.runs[k].start == 0) found.push_back(k);
  }
  require(found.size() == 1,
          "--truth {}: {} settings of the plan have these values; name one by KEY=VALUE as in the plan",
          fmt::join(settings, " "), found.size());
  return found.front();
}

Request::Request(const ChartOptions& options) {
  std::vector<std::string> wrong;
  note_errors(wrong, [&] { plan = read_plan(options); });
  quantities = read_quantities(options.quantities, options, plan, wrong);
  double end = std::numeric_limits<double>::infinity();
  for (const PlannedRun& run : plan.runs) end = std::min(end, run.the_case.time().end());
  if (quantities.size() == options.quantities.size())
    note_errors(wrong, [&] { truths = read_truths(options.truth, quantities, end); });
  if (!truths.settings.empty() && !plan.runs.empty())
    note_errors(wrong, [&] { truth_run = run_with(plan, truths.settings); });
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
}

/// The most expensive run that finished, which is the default truth.
std::size_t dearest(const StudyPlan& plan, const std::vector<FinishedRun>& runs) {
  std::size_t best = none;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (runs[k].finished && plan.runs[k].start == 0 &&
        (best == none || runs[k].core_seconds > runs[best].core_seconds))
      best = k;
  return best;
}

ChartValue summed_up(const std::vector<Comparison>& starts) {
  ChartValue sum{.value = 0,
                 .truth = 0,
                 .error = 0,
                 .lowest = unknown,
                 .highest = unknown,
                 .front = false,
                 .over_front = unknown};
  const auto count = static_cast<double>(starts.size());
  for (const Comparison& start : starts) {
    sum.value += start.value / count;
    sum.truth += start.truth / count;
    sum.error += start.error * start.error / count;
    if (!(start.error >= sum.lowest)) sum.lowest = start.error;
    if (!(start.error <= sum.highest)) sum.highest = start.error;
  }
  sum.error = std::sqrt(sum.error);
  return sum;
}

/// Compares all runs with the truth.
class Comparer {
 public:
  Comparer(const Request& request, const std::vector<FinishedRun>& runs, std::size_t truth)
      : request_(request), runs_(runs), truth_(truth), units_(request.quantities.size()) {
    if (truth == none) return;
    const Results results(runs[truth].folder);
    for (std::size_t q = 0; q < request.quantities.size(); ++q)
      true_curves_.push_back(history_of(results, request.quantities[q], units_[q]));
  }

  /// The row of the setting whose first start is run `first`.
  ChartRow row(std::size_t first) {
    const PlannedRun& planned = request_.plan.runs[first];
    ChartRow row;
    row.values = planned.values;
    row.settings = planned.settings;
    row.state = "finished";
    std::vector<std::vector<Comparison>> starts(request_.quantities.size());
    const auto count = static_cast<std::size_t>(request_.plan.starts);
    for (std::size_t k = first; k < first + count; ++k) {
      row.core_seconds += runs_[k].core_seconds / static_cast<double>(count);
      if (!runs_[k].finished) {
        row.state = "failed";
        row.reason = runs_[k].reason;
        continue;
      }
      add(runs_[k], starts);
    }
    if (first == truth_ && request_.truths.needs_run()) row.state = "truth";
    for (const auto& quantity : starts) row.quantities.push_back(summed_up(quantity));
    if (row.state == "failed")
      for (ChartValue& value : row.quantities) value = summed_up({{unknown, unknown, unknown}});
    return row;
  }

  const std::vector<std::string>& units() const { return units_; }

 private:
  void add(const FinishedRun& run, std::vector<std::vector<Comparison>>& starts) {
    const Results results(run.folder);
    for (std::size_t q = 0; q < request_.quantities.size(); ++q) {
      const Curve history = history_of(results, request_.quantities[q], units_[q]);
      starts[q].push_back(compare(request_.quantities[q], history, request_.truths.of_quantity[q],
                                  true_curves_.empty() ? history : true_curves_[q]));
    }
  }

  const Request& request_;
  const std::vector<FinishedRun>& runs_;
  std::size_t truth_;
  std::vector<std::string> units_;
  std::vector<Curve> true_curves_;
};

ChartTable table_of(const ChartOptions& options, const Request& request, const std::vector<FinishedRun>& runs,
                    std::size_t truth) {
  Comparer comparer(request, runs, truth);
  ChartTable table;
  table.note = options.note;
  table.keys = request.plan.keys;
  table.starts = request.plan.starts;
  for (std::size_t k = 0; k < runs.size(); k += static_cast<std::size_t>(table.starts))
    table.rows.push_back(comparer.row(k));
  for (std::size_t q = 0; q < request.quantities.size(); ++q) {
    const Quantity& quantity = request.quantities[q];
    const std::string& name = request.truths.of_quantity[q].name;
    table.quantities.push_back(quantity.text());
    table.units.push_back(quantity.unit(comparer.units()[q]));
    table.truths.push_back(
        name.empty() ? fmt::format("the run {}", fmt::join(request.plan.runs[truth].settings, " ")) : name);
  }
  mark_front(table);
  return table;
}

}  // namespace

int chart_command(const ChartOptions& options) {
  const Request request(options);
  const StudyRuns folder(options.out);
  const std::vector<FinishedRun> runs = folder.run(request.plan, options.case_path, options.cores);
  std::size_t truth = request.truth_run;
  if (request.truths.needs_run()) {
    if (truth == none) truth = dearest(request.plan, runs);
    if (truth != none)
      require(runs[truth].finished,
              "the run that is to be the truth failed ({}): {}; the other runs are kept, "
              "choose another --truth",
              fmt::join(request.plan.runs[truth].settings, " "), runs[truth].reason);
  }
  if (std::none_of(runs.begin(), runs.end(), [](const FinishedRun& run) { return run.finished; })) {
    say("no run finished; the logs are in {}\n", (fs::path(options.out) / "runs").string());
    return 1;
  }
  const ChartTable table = table_of(options, request, runs, truth);
  const fs::path csv = fs::path(options.out) / "chart.csv";
  replace_file(csv, {csv_of(table)});
  say("{}\n{}\n", text_of(table), csv.string());
  return 0;
}

}  // namespace cosurge
