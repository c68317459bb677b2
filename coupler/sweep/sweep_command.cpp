#include "coupler/sweep/sweep_command.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "common/case/probe_columns.hpp"
#include "common/error.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/say.hpp"
#include "coupler/study/run_quantities.hpp"
#include "coupler/study/runs.hpp"
#include "coupler/study/words.hpp"
#include "coupler/sweep/sweep_table.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

/// Peak and time of peak of every column of every probe; of loads also the impulse.
std::vector<std::string> quantities_of_probes(const v1::Case& the_case) {
  std::vector<std::string> texts;
  for (const v1::Probe& probe : the_case.output().probe()) {
    const bool load = probe.quantity() != v1::Probe::displacement && probe.quantity() != v1::Probe::level;
    for (const std::string& column : probe_columns(probe, the_case.dimension())) {
      const std::string name = column == probe.name() ? column : probe.name() + "." + column.back();
      for (const char* kind : {"peak", "time_of_peak", "impulse"})
        if (load || kind != std::string("impulse")) texts.push_back(fmt::format("{}({})", kind, name));
    }
  }
  return texts;
}

/// Everything that the options say, before anything runs.
struct Request {
  StudyPlan plan;
  std::vector<Quantity> quantities;

  explicit Request(const StudyOptions& options) {
    std::vector<std::string> wrong, texts = options.quantities;
    note_errors(wrong, [&] { plan = read_plan(options); });
    if (texts.empty() && !plan.runs.empty()) texts = quantities_of_probes(plan.runs.front().the_case);
    quantities = read_quantities(texts, options, plan, wrong);
    if (texts.empty() && wrong.empty())
      wrong.emplace_back("the case has no probes: name what to tabulate, --quantity 'peak(fluid/front)'");
    require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  }
};

SweepTable table_of(const SweepOptions& options, const Request& request,
                    const std::vector<FinishedRun>& runs) {
  SweepTable table{.note = options.note, .keys = request.plan.keys, .quantities = {}, .rows = {}};
  std::vector<std::string> units(request.quantities.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    SweepRow row{.values = request.plan.runs[k].values,
                 .finished = runs[k].finished,
                 .core_seconds = runs[k].core_seconds,
                 .quantities = std::vector<double>(units.size(), std::numeric_limits<double>::quiet_NaN()),
                 .reason = runs[k].reason};
    if (row.finished) {
      const Results results(runs[k].folder);
      for (std::size_t q = 0; q < units.size(); ++q)
        row.quantities[q] = request.quantities[q].value(history_of(results, request.quantities[q], units[q]));
    }
    table.rows.push_back(row);
  }
  for (std::size_t q = 0; q < units.size(); ++q)
    table.quantities.push_back(fmt::format("{} [{}]", request.quantities[q].text(),
                                           units[q].empty() ? "-" : request.quantities[q].unit(units[q])));
  return table;
}

/// What becomes of the runs, in words.
std::string clear_up(const SweepOptions& options, const StudyRuns& runs, bool all_finished) {
  const std::string folder = (fs::path(options.out) / "runs").string();
  if (!all_finished)
    return fmt::format("some runs failed; results and logs are kept in {}; the same command repeats them",
                       folder);
  if (options.keep) return fmt::format("the runs are in {}", folder);
  runs.remove();
  return "the runs were removed; --keep keeps them";
}

}  // namespace

int sweep_command(const SweepOptions& options) {
  const Request request(options);
  const StudyRuns folder(options.out);
  const std::vector<FinishedRun> runs = folder.run(request.plan, options.case_path, options.cores);
  const bool all_finished =
      std::all_of(runs.begin(), runs.end(), [](const FinishedRun& run) { return run.finished; });
  const SweepTable table = table_of(options, request, runs);
  const fs::path csv = fs::path(options.out) / "sweep.csv";
  replace_file(csv, {csv_of(table)});
  say("{}{}\n{}\n", text_of(table), csv.string(), clear_up(options, folder, all_finished));
  return all_finished ? 0 : 1;
}

}  // namespace cosurge
