// Several structures with solvers of their own in one water.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine

const std::string hull_case = COSURGE_SOURCE_DIR "/cases/rigid_hull";

class SeveralSolids : public ::testing::Test {
 protected:
  void SetUp() override { H5::Exception::dontPrint(); }

  Program start(const std::string& name, const std::string& the_case,
                const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {cosurge_program, "run",       the_case, "--out",
                                        folder(name),    "--threads", "1"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Program(command, scratch_.path() / (name + ".log"));
  }

  Datasets run(const std::string& name, const std::string& the_case,
               const std::vector<std::string>& arguments) {
    Program program = start(name, the_case, arguments);
    EXPECT_EQ(program.wait(patience), 0) << program.output();
    return physics(read_results(folder(name)));
  }

  static void expect_same_bits(const Datasets& a, const Datasets& b) {
    ASSERT_GT(a.size(), 20U);
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, values] : a) {
      ASSERT_TRUE(b.contains(name)) << name;
      ASSERT_EQ(values.size(), b.at(name).size()) << name;
      EXPECT_EQ(std::memcmp(values.data(), b.at(name).data(), sizeof(double) * values.size()), 0) << name;
    }
  }

  fs::path folder(const std::string& name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;
};

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

TEST_F(SeveralSolids, GiveTheSameBitsInOneProcessAndInFour) {
  const std::vector<std::string> words = {"--set", "time.end=0.15", "fluid.spacing=0.005"};
  std::vector<std::string> threads = words;
  threads.insert(threads.begin(), "--in-process");
  const Datasets apart = run("apart", hull_case, words), together = run("together", hull_case, threads);
  expect_same_bits(apart, together);
  for (const std::string log : {"hull_solver.log", "panel_solver.log", "fluid_solver.log"})
    EXPECT_TRUE(fs::exists(folder("apart") / log)) << log;
  const nlohmann::json structures = read_summary(folder("apart"))["participants"]["solid"]["structures"];
  EXPECT_GE(structures["panel"]["steps"].get<std::uint64_t>(), apart.at("/history/time").size());
  EXPECT_GT(structures["panel"]["seconds"]["cpu"].get<double>(), 0);
  // The hull moves as prescribed, 2 x 30 mm in half a period of 0.5 s.
  const double t = apart.at("/history/time").back(), y = -0.03 * (1 - std::cos(4 * std::acos(-1.0) * t));
  EXPECT_NEAR(apart.at("/history/solid/side_y").back(), y, 1e-12);
  // The panel bends besides, by more than the rounding and by less than its span.
  double bent = 0;
  for (std::size_t k = 0; k < apart.at("/history/time").size(); ++k)
    bent = std::max(bent,
                    std::abs(apart.at("/history/solid/middle_y")[k] - apart.at("/history/solid/side_y")[k]));
  EXPECT_GT(bent, 1e-4);
  EXPECT_LT(bent, 0.18);
  EXPECT_GT(largest(apart.at("/history/solid/panel/elastic_energy")), 0);
  EXPECT_EQ(largest(apart.at("/history/solid/hull/elastic_energy")), 0);
  EXPECT_NEAR(apart.at("/history/solid/interface_work").back(),
              apart.at("/history/coupling/work_points").back(),
              1e-9 * largest(apart.at("/history/coupling/work_points")));
}

TEST_F(SeveralSolids, GoOnWithTheSameBitsAfterAnInterruption) {
  const std::vector<std::string> words = {"--in-process", "--set", "time.end=0.15"};
  const Datasets whole = run("whole", hull_case, words);
  Program cut = start("cut", hull_case, words);
  const auto frames = [&] {
    try {
      return read_results(folder("cut")).at("/frames/time").size();
    } catch (const H5::Exception&) {
      return std::size_t{0};
    } catch (const std::out_of_range&) {
      return std::size_t{0};
    }
  };
  while (frames() < 3 && cut.running()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  kill(cut.pid(), SIGINT);
  ASSERT_EQ(cut.wait(patience), 130) << cut.output();
  Program resumed({cosurge_program, "resume", folder("cut"), "--threads", "1"},
                  scratch_.path() / "resumed.log");
  ASSERT_EQ(resumed.wait(patience), 0) << resumed.output();
  expect_same_bits(whole, physics(read_results(folder("cut"))));
}

/// The command line of a process, with a zero behind each word.
std::string command_line(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/cmdline", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(SeveralSolids, OneThatIsKilledIsNamed) {
  Program program = start("killed", hull_case, {"--set", "time.end=100"});
  ASSERT_TRUE(program.says("results:", patience)) << program.output();
  while (!fs::exists(folder("killed") / "checkpoint") && program.running())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  pid_t panel = 0;
  for (const auto& [pid, name] : children_of(program.pid()))
    if (command_line(pid).find("/panel.connection") != std::string::npos) panel = pid;
  ASSERT_GT(panel, 0);
  kill(panel, SIGKILL);
  EXPECT_EQ(program.wait(patience), 1) << program.output();
  EXPECT_THAT(program.output(), AllOf(HasSubstr("panel: solid_solver "), HasSubstr("killed by signal 9"),
                                      HasSubstr("to resume: ")));
  EXPECT_TRUE(children_of(program.pid()).empty());
}

TEST_F(SeveralSolids, OfOneModelMoveAsTheBodiesOfOneStructure) {
  const std::string head =
      "title = \"two plates\"\ngravity = [0.0, -9.81]\n[time]\nend = 0.12\n[fluid]\nspacing = 0.01\n"
      "tank = { min = [0.0, 0.0], max = [0.8, 0.4] }\nwater = [{ min = [0.0, 0.0], max = [0.2, 0.3] }]\n"
      "[output]\nframe_interval = 0.02\nprobe = [\n"
      "{ name = \"a\", quantity = \"displacement\", position = [0.3, 0.12] },\n"
      "{ name = \"b\", quantity = \"displacement\", position = [0.5, 0.12] } ]\n";
  const auto body = [](const std::string& left, const std::string& right) {
    return "body = [{ box = { min = [" + left + ", 0.0], max = [" + right + ", 0.12] }, clamp = [{ min = [" +
           left + ", -0.03], max = [" + right + ", 0.0] }] }]\n";
  };
  const std::string material = "model = \"fem\"\ndensity = 1500.0\nyoung_modulus = 1.0e6\n";
  const std::string first = body("0.3", "0.34"), second = body("0.5", "0.54");
  const auto inner = [](const std::string& text) { return text.substr(8, text.size() - 10); };
  const auto write = [&](const std::string& name, const std::string& text) {
    fs::create_directories(folder(name));
    std::ofstream(folder(name) / "case.toml") << text;
    return folder(name).string();
  };
  const std::string one = write("one_case", head + "[solid]\n" + material + "body = [" + inner(first) + ", " +
                                                inner(second) + "]\n"),
                    two = write("two_case", head + "[[solid]]\nname = \"left\"\n" + material + first +
                                                "[[solid]]\nname = \"right\"\n" + material + second);
  const Datasets a = run("one", one, {"--in-process"}), b = run("two", two, {"--in-process"});
  ASSERT_GT(largest(a.at("/history/solid/a_x")), 1e-4);
  for (const std::string name :
       {"time", "solid/a_x", "solid/a_y", "solid/b_x", "coupling/force_x", "fluid/front"}) {
    const std::vector<double>&of_one = a.at("/history/" + name), &of_two = b.at("/history/" + name);
    ASSERT_EQ(of_one.size(), of_two.size()) << name;
    EXPECT_EQ(std::memcmp(of_one.data(), of_two.data(), sizeof(double) * of_one.size()), 0) << name;
  }
}

TEST_F(SeveralSolids, AreChosenByName) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--solid", "solid_solver"},
       "--solid solid_solver: the case has several structures: must be NAME=PROGRAM, NAME one of hull, "
       "panel"},
      {{"--solid", "keel=solid_solver"}, "--solid keel=solid_solver: the case has several structures"},
      {{"--by-hand", "solid"}, "--by-hand solid: must be one of fluid, hull, panel"}};
  for (const auto& [arguments, message] : wrong) {
    Program program = start("wrong", hull_case, arguments);
    EXPECT_EQ(program.wait(patience), 1) << program.output();
    EXPECT_THAT(program.output(), HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder("wrong")));
  }
  const std::string program = COSURGE_PROGRAMS "/solid_solver";
  run("named", hull_case, {"--solid", "panel=" + program, "--set", "time.end=0.01"});
}

TEST_F(SeveralSolids, AreCheckedAdvisedReportedAndTabulated) {
  Program check({cosurge_program, "check", hull_case, "--picture", folder("hull.html")},
                scratch_.path() / "check.log");
  EXPECT_EQ(check.wait(patience), 0) << check.output();
  EXPECT_TRUE(fs::exists(folder("hull.html")));
  Program advise({cosurge_program, "advise", hull_case}, scratch_.path() / "advise.log");
  EXPECT_EQ(advise.wait(patience), 0) << advise.output();
  EXPECT_THAT(advise.output(), AllOf(HasSubstr("as if it stood alone in the water"),
                                     HasSubstr("structure hull"), HasSubstr("structure panel")));
  run("reported", hull_case, {"--in-process", "--set", "time.end=0.02"});
  for (const std::string command : {"report", "csv", "status"}) {
    Program program({cosurge_program, command, folder("reported")}, scratch_.path() / (command + ".log"));
    EXPECT_EQ(program.wait(patience), 0) << command << ": " << program.output();
    if (command == "csv") {
      EXPECT_THAT(program.output(), HasSubstr("solid/panel/elastic_energy"));
    }
  }
}

}  // namespace
}  // namespace cosurge::testing
