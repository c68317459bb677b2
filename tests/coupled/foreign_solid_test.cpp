// External solvers: cases/foreign_solid, and the checks of cosurge certify for it and for Cosurge's own
// solvers.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;

const std::string case_folder = COSURGE_SOURCE_DIR "/cases/foreign_solid";
const std::string plate = case_folder + "/plate.py";
constexpr double patience = 240;  // [s]; tens of times the duration of these runs on an idle machine

/// Exit status and output of cosurge certify.
std::pair<int, std::string> certify(const std::vector<std::string>& arguments) {
  const ScratchFolder scratch;
  std::vector<std::string> command = {cosurge_program, "certify"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Program program(command, scratch.path() / "log");
  const int status = program.wait(patience);
  return {status, program.output()};
}

class OwnModel : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Certificate, OwnModel,
                         ::testing::Values("rigid", "mps", "hamiltonian", "fem", "modal"),
                         [](const auto& model) { return std::string(model.param); });

TEST_P(OwnModel, IsCertified) {
  const auto [status, output] = certify(
      {"--set", std::string("solid.model=") + GetParam(), "--", fs::path(COSURGE_PROGRAMS) / "solid_solver"});
  EXPECT_EQ(status, 0) << output;
}

TEST(Certificate, ABodyOnSpringsHasIt) {
  const auto [status, output] = certify({"--set", "solid.model=sprung", "--set",
                                         R"(solid.sprung.spring=[{ motion = "x", stiffness = 1e3 }])", "--",
                                         fs::path(COSURGE_PROGRAMS) / "solid_solver"});
  EXPECT_EQ(status, 0) << output;
}

TEST(Certificate, OurFluidHasIt) {
  const auto [status, output] =
      certify({"--role", "fluid", "--", fs::path(COSURGE_PROGRAMS) / "fluid_solver"});
  EXPECT_EQ(status, 0) << output;
}

TEST(Certificate, TheForeignPlateHasIt) {
  const auto [status, output] = certify({"--", plate});
  EXPECT_EQ(status, 0) << output;
}

/// The foreign plate with a mistake in it.
struct Mistake {
  const char* name;
  const char* right;
  const char* wrong;
  const char* found;
};

class Mistaken : public ::testing::TestWithParam<Mistake> {};
INSTANTIATE_TEST_SUITE_P(
    Certificate, Mistaken,
    ::testing::Values(Mistake{"LoadNotByTheTranspose", "self.H.T @ force", "np.abs(self.H).T @ force",
                              "FAILED  has a symmetric response to point loads"},
                      Mistake{"LoadTooLarge", "self.H.T @ force", "1.01 * self.H.T @ force",
                              "FAILED  reports the mean velocity, and the work"},
                      Mistake{"VelocityOfTheEnd", "velocity=self.H @ (new - q) / window.size",
                              "velocity=self.H @ velocity",
                              "FAILED  reports the mean velocity, and the work"},
                      Mistake{"AttemptForgotten", "self.start if window.attempt > 1 else self.state",
                              "self.state", "FAILED  repeats a window from its start"},
                      Mistake{"StateIncomplete", "plate.state = np.frombuffer(request.restore.state)",
                              "plate.state = np.frombuffer(request.restore.state) * 0",
                              "FAILED  continues from a saved state"},
                      Mistake{"NanTaken", "or not np.isfinite(force).all()", "", "FAILED  rejects NaN"},
                      Mistake{"AnyOrderTaken", "if request.sequence != number:", "if False:",
                              "FAILED  rejects a request with a wrong sequence number"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST_P(Mistaken, IsFoundByItsCheck) {
  const ScratchFolder scratch;
  std::ostringstream text;
  text << std::ifstream(plate).rdbuf();
  std::string code = text.str();
  const auto replace = [&](const std::string& from, const std::string& to) {
    const auto at = code.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    code.replace(at, from.size(), to);
  };
  replace(GetParam().right, GetParam().wrong);
  replace("pathlib.Path(__file__).resolve().parents[2]", "pathlib.Path('" COSURGE_SOURCE_DIR "')");
  const fs::path wrong = scratch.path() / "plate.py";
  std::ofstream(wrong) << code;
  fs::permissions(wrong, fs::perms::owner_all);
  const auto [status, output] = certify({"--", wrong});
  EXPECT_EQ(status, 1) << output;
  EXPECT_NE(output.find(GetParam().found), std::string::npos) << output;
}

Program run_with_plate(const fs::path& folder, const std::string& end) {
  return Program({cosurge_program, "run", case_folder, "--solid", plate, "--threads", "1", "--out",
                  folder / "out", "--set", "time.end=" + end},
                 folder / "log");
}

TEST(ForeignSolid, MovesInTheDamBreakAndWorksAsItsPointsDo) {
  const ScratchFolder scratch;
  Program program = run_with_plate(scratch.path(), "0.2");
  ASSERT_EQ(program.wait(patience), 0) << program.output();
  const Datasets results = read_results(scratch.path() / "out");
  double tip = 0;
  for (const double x : results.at("/history/solid/tip_x")) tip = std::max(tip, x);
  // E = 20 MPa: a uniform pressure rho g H would bend the plate by 4.6 mm.
  EXPECT_GT(tip, 0.002);
  EXPECT_LT(tip, 0.010);
  const double solid = results.at("/history/solid/interface_work").back();
  const double points = results.at("/history/coupling/work_points").back();
  EXPECT_GT(points, 1e-4);
  EXPECT_NEAR(solid / points, 1, 1e-9);  // rounding
}

TEST(ForeignSolid, ThatIsKilledIsReportedLikeAnyOther) {
  const ScratchFolder scratch;
  Program program = run_with_plate(scratch.path(), "0.4");
  ASSERT_TRUE(program.says("t 0.", patience)) << program.output();
  for (const auto& [pid, name] : children_of(program.pid()))
    if (name == "plate.py") kill(pid, SIGKILL);
  EXPECT_EQ(program.wait(20), 1) << program.output();
  EXPECT_NE(program.output().find("plate.py 1: it was killed by signal 9"), std::string::npos)
      << program.output();
  EXPECT_TRUE(fs::exists(scratch.path() / "out" / "results.h5"));
}

}  // namespace
}  // namespace cosurge::testing
