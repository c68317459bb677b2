#include "coupler/study/run_quantities.hpp"

#include "common/case/case_file.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {

std::vector<Quantity> read_quantities(const std::vector<std::string>& texts, const StudyOptions& options,
                                      const StudyPlan& plan, std::vector<std::string>& wrong) {
  std::vector<v1::Case> cases;
  for (const PlannedRun& run : plan.runs) cases.push_back(run.the_case);
  if (cases.empty())
    note_errors(wrong, [&] { cases.push_back(load_case(options.case_path, options.overrides)); });
  std::vector<Quantity> quantities;
  for (const std::string& text : texts)
    for (std::size_t k = 0; k < cases.size(); ++k)
      note_errors(wrong, [&] {
        const Quantity quantity = Quantity::read(text, cases[k]);
        if (k == 0) quantities.push_back(quantity);
      });
  return quantities;
}

Curve history_of(const Results& results, const Quantity& quantity, std::string& unit) {
  Curve curve{.time = results.history("time").values, .values = {}};
  for (const std::string& column : quantity.columns()) {
    Series series = results.history(column);
    unit = series.unit;
    if (curve.values.empty()) {
      curve.values = std::move(series.values);
      continue;
    }
    for (std::size_t k = 0; k < std::min(curve.values.size(), series.values.size()); ++k)
      curve.values[k] -= series.values[k];
  }
  const std::size_t rows = std::min(curve.time.size(), curve.values.size());
  curve.time.resize(rows);
  curve.values.resize(rows);
  return curve;
}

}  // namespace cosurge
