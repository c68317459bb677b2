#include "coupler/study/plan.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "coupler/case_grid.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

constexpr double perturbation = 1e-6;  // relative change of gravity, far below the error of any run

/// A cell of a spreadsheet without the quotes around it and the blanks.
std::string plain_cell(std::string cell) {
  const auto first = cell.find_first_not_of(" \t\r"), last = cell.find_last_not_of(" \t\r");
  cell = first == std::string::npos ? "" : cell.substr(first, last - first + 1);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  return cell;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells = split_values(line + ",", ',');  // an empty last cell is one, too
  for (std::string& cell : cells) cell = plain_cell(cell);
  return cells;
}

/// Keys and rows of a plan. @throws Error with all wrong lines.
void read_rows(const std::string& file, std::vector<std::string>& keys,
               std::vector<std::vector<std::string>>& rows) {
  std::ifstream in(file);
  require(in.good(), "--plan {}: cannot be read", file);
  std::vector<std::string> wrong;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with("#") || line.find_first_not_of(" \t\r,") == std::string::npos) continue;
    const auto cells = cells_of(line);
    if (keys.empty())
      keys = cells;
    else if (cells.size() != keys.size())
      wrong.push_back(
          fmt::format("{}:{}: {} values for {} keys; a vector or a text with commas needs "
                      "brackets or quotes",
                      file, number, cells.size(), keys.size()));
    else
      rows.push_back(cells);
  }
  if (std::find(keys.begin(), keys.end(), "") != keys.end())
    wrong.push_back(fmt::format("{}: a column has no key in the first line", file));
  if (wrong.empty() && rows.empty())
    wrong.push_back(fmt::format("--plan {}: must have a line of keys and a line for each run", file));
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
}

/// Gravity of a perturbed start, as an override.
std::string gravity_of(const v1::Case& the_case, int start) {
  std::vector<std::string> components;
  for (const double g : the_case.gravity())
    components.push_back(fmt::format("{}", g * (1 + perturbation * start)));
  return fmt::format("gravity=[{}]", fmt::join(components, ", "));
}

/// The runs of one combination of values, appended. @throws Error where the case is not valid.
void add_runs(const StudyOptions& options, PlannedRun run, StudyPlan& plan) {
  run.overrides = options.overrides;
  run.overrides.insert(run.overrides.end(), run.settings.begin(), run.settings.end());
  run.the_case = load_case(options.case_path, run.overrides);
  plan.runs.push_back(run);
  const auto& gravity = run.the_case.gravity();
  require(
      options.scatter == 0 || std::any_of(gravity.begin(), gravity.end(), [](double g) { return g != 0; }),
      "--scatter {}: perturbs gravity, and the case has none", options.scatter);
  const auto unperturbed = run.overrides;
  for (run.start = 1; run.start <= options.scatter; ++run.start) {
    run.overrides = unperturbed;
    run.overrides.push_back(gravity_of(run.the_case, run.start));
    PlannedRun perturbed = run;
    perturbed.the_case = load_case(options.case_path, run.overrides);
    plan.runs.push_back(std::move(perturbed));
  }
}

/// Two settings with the same case would be one row that costs twice.
void add_repeated(const StudyPlan& plan, std::vector<std::string>& wrong) {
  std::map<std::string, const PlannedRun*> known;
  for (const PlannedRun& run : plan.runs) {
    const auto [first, is_new] = known.emplace(run.the_case.SerializeAsString(), &run);
    if (!is_new && run.start == 0)
      wrong.push_back(fmt::format("{} and {}: are the same case; leave one out",
                                  fmt::join(first->second->settings, " "), fmt::join(run.settings, " ")));
  }
}

}  // namespace

StudyPlan read_plan(const StudyOptions& options) {
  require(!options.over.empty() || !options.plan.empty(),
          "--over KEY=A,B,... or --plan FILE.csv is missing: settings to compare");
  StudyPlan plan;
  plan.starts = options.scatter + 1;
  std::vector<std::vector<std::string>> rows;
  if (options.plan.empty())
    rows.emplace_back();
  else
    read_rows(options.plan, plan.keys, rows);
  const std::vector<std::string> row_keys = plan.keys;
  std::vector<Axis> axes;
  for (const std::string& text : options.over) {
    axes.push_back(read_axis(text));
    for (const std::string& key : split_values(axes.back().key, '/')) plan.keys.push_back(key);
  }
  const std::set<std::string> different(plan.keys.begin(), plan.keys.end());
  require(different.size() == plan.keys.size(), "a key is given twice in the plan: {}",
          fmt::join(plan.keys, ", "));
  std::vector<std::string> wrong;
  for (const auto& row : rows)
    for (const auto& cell : combinations(axes)) {
      PlannedRun run;
      run.values = row;
      for (std::size_t k = 0; k < row.size(); ++k)
        if (!row[k].empty()) run.settings.push_back(row_keys[k] + "=" + row[k]);
      for (const std::string& setting : settings_of(axes, cell)) {
        run.settings.push_back(setting);
        run.values.push_back(setting.substr(setting.find('=') + 1));
      }
      note_errors(wrong, [&] { add_runs(options, std::move(run), plan); });
    }
  if (wrong.empty()) add_repeated(plan, wrong);
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  return plan;
}

}  // namespace cosurge
