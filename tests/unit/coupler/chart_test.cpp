// Quantities, errors and the front of a chart, against values by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "coupler/chart/chart_table.hpp"
#include "coupler/chart/pareto.hpp"
#include "coupler/chart/truth.hpp"
#include "coupler/study/plan.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string small_dam_break = COSURGE_SOURCE_DIR "/tests/cases/small_dam_break";  // to 0.2 s

/// A parabola with its top 1 at 0.5 s, zero at 0 and 1 s, at 101 times.
Curve parabola() {
  Curve curve;
  for (int k = 0; k <= 100; ++k) {
    const double t = 0.01 * k;
    curve.time.push_back(t);
    curve.values.push_back(4 * t * (1 - t));
  }
  return curve;
}

Quantity quantity(const std::string& text) {
  return Quantity::read(text, load_case(small_dam_break, {"time.end=1"}));
}

/// What `read` throws.
template <typename Read>
std::string fault_of(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ChartQuantity, HasTheValuesOfAParabola) {
  const Curve curve = parabola();
  EXPECT_DOUBLE_EQ(quantity("peak(tip.x)").value(curve), 1);
  EXPECT_DOUBLE_EQ(quantity("time_of_peak(tip.x)").value(curve), 0.5);
  EXPECT_NEAR(quantity("impulse(foot)").value(curve), 2.0 / 3, 1e-4);  // trapezoids of 0.01 s
  EXPECT_NEAR(quantity("rms(tip.x)").value(curve), std::sqrt(8.0 / 15), 1e-4);
}

TEST(ChartQuantity, KeepsToItsRange) {
  const Curve curve = parabola();
  EXPECT_NEAR(quantity("peak(tip.x, 0.7..0.9)").value(curve), 0.84, 1e-12);
  EXPECT_NEAR(quantity("peak(tip.x, 0.705..0.9)").value(curve), 4 * 0.705 * 0.295,
              2e-4);  // between two points
  EXPECT_NEAR(quantity("impulse(foot, 0..0.5)").value(curve), 1.0 / 3, 1e-4);
}

TEST(ChartQuantity, PeakIsTheValueFarthestFromZero) {
  const Curve curve{.time = {0, 1, 2, 3}, .values = {1, std::nan(""), -3, 2}};
  EXPECT_EQ(peak_of(curve).value, -3);
  EXPECT_EQ(peak_of(curve).time, 2);
}

TEST(ChartQuantity, FindsColumnsOfProbesAndOfResults) {
  EXPECT_THAT(quantity("peak(tip.x)").columns(), ElementsAre("solid/tip_x"));
  EXPECT_THAT(quantity("peak( foot )").columns(), ElementsAre("fluid/foot"));
  EXPECT_THAT(quantity("rms(fluid/front-coupling/force_x)").columns(),
              ElementsAre("fluid/front", "coupling/force_x"));
  EXPECT_EQ(quantity("impulse(foot)").unit("Pa"), "Pa s");
  EXPECT_EQ(quantity("time_of_peak(foot)").unit("Pa"), "s");
}

TEST(ChartQuantity, IsRefusedWithTheReason) {
  EXPECT_THAT(fault_of([] { quantity("mean(tip.x)"); }), HasSubstr("must be peak(H)"));
  EXPECT_THAT(fault_of([] { quantity("peak tip.x"); }), HasSubstr("must be peak(H)"));
  EXPECT_THAT(fault_of([] { quantity("peak(tip.z)"); }),
              HasSubstr("no column tip.z; its probes have tip.x, tip.y"));
  EXPECT_THAT(fault_of([] { quantity("peak(solid/load_x)"); }),
              HasSubstr("no column solid/load_x"));  // not all models
  EXPECT_THAT(fault_of([] { quantity("peak(tip.x, 0.1..1.5)"); }), HasSubstr("the run at 1 s"));
  EXPECT_THAT(fault_of([] { quantity("peak(tip.x, 0.5..0.1)"); }), HasSubstr("FROM < TO"));
  EXPECT_THAT(fault_of([] { quantity("peak(tip.x, 0.5)"); }), HasSubstr("must be peak(H)"));
}

TEST(ChartError, IsTheDifferenceFromANumberOrACurve) {
  const Curve curve = parabola();
  Curve shifted = curve;
  for (double& value : shifted.values) value += 0.25;
  const Truth number{.name = "0.8", .number = 0.8, .curve = {}};
  EXPECT_NEAR(compare(quantity("peak(tip.x)"), curve, number, {}).error, 0.2, 1e-12);
  const Truth run;
  EXPECT_NEAR(compare(quantity("peak(tip.x)"), shifted, run, curve).error, 0.25, 1e-12);
  EXPECT_NEAR(compare(quantity("rms(tip.x)"), shifted, run, curve).error, 0.25, 1e-12);
  EXPECT_NEAR(compare(quantity("impulse(tip.x)"), shifted, run, curve).error, 0.25, 1e-12);
  EXPECT_EQ(compare(quantity("rms(tip.x)"), curve, run, curve).error, 0);
}

TEST(ChartError, ComparesOverTheTimeThatBothHave) {
  const Curve curve = parabola();
  const Curve late{.time = {0.5, 0.75, 2}, .values = {1, 1, 1}};
  const Truth truth{.name = "late.csv", .number = {}, .curve = late};
  EXPECT_NEAR(compare(quantity("impulse(tip.x)"), curve, truth, {}).error, 0.5 - 1.0 / 3, 1e-4);
}

TEST(ChartTruth, IsReadFromTablesAndNumbers) {
  const ScratchFolder scratch;
  const std::string file = scratch.path() / "tip.csv", backwards = scratch.path() / "back.csv";
  std::ofstream(file) << "t_s,ux_m\n0,0\n0.5,2\n";
  std::ofstream(backwards) << "t_s,ux_m\n0.5,0\n0.4,2\n";
  const std::vector<Quantity> both = {quantity("peak(tip.x)"), quantity("rms(tip.x, 0..0.5)")};
  const Truths curve = read_truths({file}, both, 1);
  EXPECT_FALSE(curve.needs_run());
  EXPECT_EQ(curve.of_quantity[1].curve->values.back(), 2);
  EXPECT_TRUE(read_truths({"peak(tip.x)=0.05"}, both, 1).needs_run());
  EXPECT_TRUE(read_truths({"finest"}, both, 1).needs_run());
  EXPECT_THAT(read_truths({"time.window=1e-4"}, both, 1).settings, ElementsAre("time.window=1e-4"));
  const auto fault = [&](const std::vector<std::string>& words, const std::vector<Quantity>& quantities) {
    return fault_of([&] { read_truths(words, quantities, 1); });
  };
  EXPECT_THAT(fault({"rms(tip.x, 0..0.5)=0.1"}, both), HasSubstr("not with a number"));
  EXPECT_THAT(fault({"peak(tip.y)=0.1"}, both), HasSubstr("not among the quantities"));
  EXPECT_THAT(fault({backwards}, both), HasSubstr("back.csv:3: time 0.4 must be later than 0.5"));
  EXPECT_THAT(fault({file}, {quantity("peak(tip.x)"), quantity("peak(foot)")}),
              HasSubstr("cannot be true of"));
  EXPECT_THAT(fault({file}, {quantity("rms(tip.x, 0..0.9)")}), HasSubstr("from 0 to 0.5 s only"));
  EXPECT_THAT(fault({"coarsest", "none.csv"}, both),
              ::testing::AllOf(HasSubstr("coarsest"), HasSubstr("none.csv")));
}

TEST(ChartFront, HasTheRunsThatNoneIsCheaperAndBetterThan) {
  const std::vector<CostAndError> runs = {{1, 8}, {2, 4}, {4, 5}, {4, 1}, {5, 1}, {3, std::nan("")}, {2, 4}};
  EXPECT_THAT(on_front(runs), ElementsAre(true, true, false, true, false, false, true));
  const auto ratio = cost_over_front(runs);
  EXPECT_EQ(ratio[0], 1);
  EXPECT_EQ(ratio[2], 2);     // the run of cost 2 is better
  EXPECT_EQ(ratio[4], 1.25);  // the one of cost 4 is as good
  EXPECT_TRUE(std::isnan(ratio[5]));
}

StudyOptions options() {
  StudyOptions options;
  options.case_path = small_dam_break;
  return options;
}

TEST(StudyPlan, CombinesRowsOfAFileWithAGrid) {
  const ScratchFolder scratch;
  const std::string file = scratch.path() / "plan.csv";
  std::ofstream(file) << "# two settings\nsolid.model,gravity\nmodal,\nfem,\"[0, -5]\"\n";
  StudyOptions some = options();
  some.plan = file;
  some.over = {"time.window=none,1e-4"};
  some.scatter = 1;
  const StudyPlan plan = read_plan(some);
  EXPECT_THAT(plan.keys, ElementsAre("solid.model", "gravity", "time.window"));
  ASSERT_EQ(plan.runs.size(), 8U);
  EXPECT_THAT(plan.runs[0].settings, ElementsAre("solid.model=modal", "time.window=none"));
  EXPECT_FALSE(plan.runs[0].the_case.time().has_window());
  EXPECT_EQ(plan.runs[2].the_case.time().window(), 1e-4);
  EXPECT_EQ(plan.runs[4].the_case.gravity(1), -5);
  EXPECT_EQ(plan.runs[1].start, 1);
  EXPECT_NEAR(plan.runs[1].the_case.gravity(1) / -9.81 - 1, 1e-6, 1e-9);
}

TEST(StudyPlan, SaysEverythingThatIsWrongAtOnce) {
  StudyOptions some = options();
  some.over = {"solid.density=-1,1000", "time.window=1,2e-4", "solid.jelly=fem"};
  const std::string fault = fault_of([&] { read_plan(some); });
  EXPECT_THAT(fault, HasSubstr("solid.density"));
  EXPECT_THAT(fault, HasSubstr("solid.jelly"));
  some.over = {"time.window=2e-4,0.0002"};
  EXPECT_THAT(fault_of([&] { read_plan(some); }), HasSubstr("are the same case"));
  some.over = {"time.window=1e-4", "time.window=2e-4"};
  EXPECT_THAT(fault_of([&] { read_plan(some); }), HasSubstr("a key is given twice"));
  some.over = {};
  EXPECT_THAT(fault_of([&] { read_plan(some); }), HasSubstr("--plan FILE.csv is missing"));
  const ScratchFolder scratch;
  some.plan = scratch.path() / "plan.csv";
  std::ofstream(some.plan) << "solid.model,time.window\nfem\nmodal,1e-4,3\n";
  EXPECT_THAT(
      fault_of([&] { read_plan(some); }),
      ::testing::AllOf(HasSubstr("plan.csv:2: 1 values for 2 keys"), HasSubstr("plan.csv:3: 3 values")));
}

TEST(ChartTable, MarksTheFrontWithoutTheTruthAndWithoutFailures) {
  ChartTable table;
  table.keys = {"k"};
  table.quantities = {"peak(tip.x)"};
  table.units = {"m"};
  table.truths = {"the run k=3"};
  const auto add = [&](const std::string& k, const std::string& state, double cost, double error) {
    ChartRow row;
    row.values = {k};
    row.settings = {"k=" + k};
    row.state = state;
    row.core_seconds = cost;
    row.quantities = {{.value = 1 + error,
                       .truth = 1,
                       .error = error,
                       .lowest = error,
                       .highest = error,
                       .front = false,
                       .over_front = NAN}};
    table.rows.push_back(row);
  };
  add("1", "finished", 10, 0.1);
  add("2", "finished", 20, 0.2);
  add("3", "truth", 1, 0);
  add("4", "failed", 2, NAN);
  mark_front(table);
  const std::string csv = csv_of(table);
  EXPECT_THAT(csv, HasSubstr("1,finished,10.000,1.1,1,0.1,0.1,0.1,yes,1,\n"));
  EXPECT_THAT(csv, HasSubstr("2,finished,20.000,1.2,1,0.2,0.2,0.2,no,2,\n"));
  EXPECT_THAT(csv, HasSubstr("4,failed,2.000,,1,,,,no,,\n"));
  EXPECT_THAT(text_of(table), HasSubstr("the truth  k=3"));
}

}  // namespace
}  // namespace cosurge::testing
