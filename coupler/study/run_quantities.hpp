// The quantities of the runs of a study.
#pragma once

#include "coupler/results.hpp"
#include "coupler/study/plan.hpp"
#include "coupler/study/quantity.hpp"

namespace cosurge {

/// Reads quantities, which must be there in every run of the plan; where the plan is empty, in the case of
/// the options. What is wrong with them is appended to `wrong`.
std::vector<Quantity> read_quantities(const std::vector<std::string>& texts, const StudyOptions& options,
                                      const StudyPlan& plan, std::vector<std::string>& wrong);

/// The history of a quantity in the results of a run; `unit` gets its unit. @throws Error.
Curve history_of(const Results& results, const Quantity& quantity, std::string& unit);

}  // namespace cosurge
