// What a run says while it goes: on terminals of different widths, in pipes, to scripts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double patience = 300;  // s: a few are enough on an idle machine
constexpr const char* short_run = "time.end=0.04";

/// Everything that a run writes to a terminal of this many columns. `told`: COLUMNS, empty for none.
std::string on_a_terminal(unsigned short columns, const std::string& out, const std::string& told = "") {
  winsize size{};
  size.ws_col = columns;
  size.ws_row = 24;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    told.empty() ? unsetenv("COLUMNS") : setenv("COLUMNS", told.c_str(), 1);
    execl(cosurge_program.c_str(), "cosurge", "run", small_dam_break.c_str(), "--set", short_run, "--out",
          out.c_str(), nullptr);
    _exit(127);
  }
  std::string text;
  char part[4096];
  for (ssize_t n = 0; (n = read(terminal, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(n));
  int status = -1;
  waitpid(child, &status, 0);
  close(terminal);
  EXPECT_EQ(status, 0) << text;
  return text;
}

/// The states of the progress line, without the characters that clear it.
std::vector<std::string> states_of(const std::string& text) {
  constexpr const char* clear = "\r\x1b[K";
  std::vector<std::string> states;
  for (auto at = text.find(clear); at != std::string::npos; at = text.find(clear, at)) {
    at += 4;
    states.push_back(text.substr(at, text.find_first_of("\r\n", at) - at));
  }
  return states;
}

class ProgressOnATerminal : public ::testing::TestWithParam<unsigned short> {};

TEST_P(ProgressOnATerminal, IsOneLineThatFits) {
  const ScratchFolder scratch;
  const auto states = states_of(on_a_terminal(GetParam(), (scratch.path() / "run").string()));
  ASSERT_FALSE(states.empty());
  for (const std::string& state : states) {
    EXPECT_LT(state.size(), GetParam()) << state;
    EXPECT_THAT(state, AllOf(StartsWith("t "), HasSubstr("  tip "), HasSubstr(" left")));
  }
  EXPECT_THAT(states.back(), AllOf(StartsWith("t 0.0400/0.04 s"), HasSubstr("0:00 left")));
}

INSTANTIATE_TEST_SUITE_P(Columns, ProgressOnATerminal, ::testing::Values(60, 80, 120, 200));

TEST(ProgressTerminal, KeepsToColumnsWhereTheyAreFewer) {
  const ScratchFolder scratch;
  for (const std::string& state : states_of(on_a_terminal(200, (scratch.path() / "run").string(), "40")))
    EXPECT_LT(state.size(), 40U) << state;
}

class ProgressOfARun : public ::testing::Test {
 protected:
  /// Runs with an option and returns what it wrote: standard output, then standard error.
  std::pair<std::string, std::string> run(const std::string& option, int status = 0,
                                          const std::string& set = short_run) {
    const auto out = scratch_.path() / "out.txt", err = scratch_.path() / "err.txt";
    Program program(
        {"/bin/bash", "-c",
         fmt::format("{} run {} --set {} --out {} {} > {} 2> {}", cosurge_program, small_dam_break, set,
                     (scratch_.path() / "run").string(), option, out.string(), err.string())},
        scratch_.path() / "log");
    EXPECT_EQ(program.wait(patience), status);
    return {text_of(out), text_of(err)};
  }

  static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  ScratchFolder scratch_;
};

TEST_F(ProgressOfARun, HasNoControlCharactersInAPipe) {
  const auto [out, err] = run("");
  EXPECT_THAT(out, AllOf(HasSubstr("\nt 0.0400/0.04 s  tip "), Not(HasSubstr("\x1b")), Not(HasSubstr("\r"))));
  EXPECT_THAT(err, IsEmpty());
}

TEST_F(ProgressOfARun, SaysNothingOfAQuietRunThatFinishes) {
  const auto [out, err] = run("--quiet");
  EXPECT_THAT(out, IsEmpty());
  EXPECT_THAT(err, IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(scratch_.path() / "run/summary.json"));
}

TEST_F(ProgressOfARun, SaysWhyAQuietRunFails) {
  const auto [out, err] = run("--quiet --solid /nowhere/solver", 1);
  EXPECT_THAT(out + err, HasSubstr("/nowhere/solver"));
}

TEST_F(ProgressOfARun, IsJsonForScripts) {
  const auto [out, err] = run("--json-progress");
  std::vector<nlohmann::json> lines;
  std::istringstream text(out);
  for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
  ASSERT_GE(lines.size(), 2U);
  const auto& state = lines[lines.size() - 2];
  EXPECT_EQ(state["event"], "progress");
  EXPECT_EQ(state["time"], 0.04);
  EXPECT_EQ(state["window"], 200);
  EXPECT_EQ(state["seconds_left"], 0);
  EXPECT_TRUE(state["probes"].contains("solid/tip_x")) << state;
  EXPECT_TRUE(state["probes"].contains("fluid/foot")) << state;
  EXPECT_EQ(lines.back()["event"], "end");
  EXPECT_EQ(lines.back()["status"], "finished");
  EXPECT_EQ(lines.back()["windows"], 200);
  EXPECT_THAT(err, AllOf(HasSubstr("Small dam break"), HasSubstr("finished at t = 0.04 s")));
}

}  // namespace
}  // namespace cosurge::testing
