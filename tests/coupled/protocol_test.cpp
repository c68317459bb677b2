// The protocol between real processes, and faults of one of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>
#include <thread>

#include "coupler/launcher.hpp"
#include "coupler/program_path.hpp"
#include "coupler/run_folder.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

double seconds_since(steady_clock::time_point start) {
  return std::chrono::duration<double>(steady_clock::now() - start).count();
}

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// True where this process has no child, running or not reaped.
bool is_childless() { return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

class Processes : public ::testing::Test {
 protected:
  Wiring wiring() const {
    return {.folder = run.path(), .listen = {}, .patience = 30, .message_limit = 1000000};
  }

  Solver start(const std::string& program, const std::vector<std::string>& arguments = {}) const {
    const Command command{.program = program_path(program), .arguments = arguments, .log = log};
    return Solver::process(Role::fluid, wiring(), command, 1);
  }

  const RunFolder run;
  const testing::ScratchFolder scratch;
  const std::filesystem::path log = scratch.path() / "solver.log";
};

/// A run of some windows.
void advance_a_little(RemoteParticipant& participant) {
  Fluid& fluid = dynamic_cast<RemoteFluid&>(participant);
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  fluid.initialize(testing::piston_case(), interface, load);
  motion = InterfaceMotion::at_rest(2, interface.points());
  for (std::uint64_t n = 0; n < 5; ++n) {
    fluid.advance({.index = n, .start = static_cast<double>(n) * 1e-3, .size = 1e-3}, motion, load);
  }
}

TEST_F(Processes, RunToTheirEndAndLeaveNothingBehind) {
  {
    Solver solver = start("mock_fluid");
    RemoteParticipant& fluid = solver.join(2, {"save", "frame"});
    advance_a_little(fluid);
    fluid.finalize();
    EXPECT_TRUE(solver.stop("", milliseconds(5000))) << text_of(log);
  }
  EXPECT_EQ(text_of(log), "");
  EXPECT_TRUE(is_childless());
}

TEST_F(Processes, RunOverTcpWithKeys) {
  Wiring over_tcp = wiring();
  over_tcp.listen = "tcp://127.0.0.1:*";
  Solver solver = Solver::process(Role::fluid, over_tcp,
                                  {.program = program_path("mock_fluid"), .arguments = {}, .log = log}, 1);
  advance_a_little(solver.join(2, {}));
  solver.participant().finalize();
  EXPECT_TRUE(solver.stop("", milliseconds(5000))) << text_of(log);
}

TEST_F(Processes, ThatTheCouplerEndsSayWhy) {
  Solver solver = start("mock_fluid");
  advance_a_little(solver.join(2, {}));
  EXPECT_FALSE(solver.stop("solid_solver has failed", milliseconds(5000)));
  EXPECT_THAT(text_of(log), HasSubstr("mock_fluid: the coupler ended the run: solid_solver has failed"));
}

struct Fault {
  std::string name;
  int at;              // number of the request whose answer is wrong
  std::string error;   // part of the coupler's message
  std::string in_log;  // part of the solver's message
};

class Faults : public Processes, public ::testing::WithParamInterface<Fault> {};

TEST_P(Faults, EndTheRunWithinSecondsAndNameWhoAndWhat) {
  const Fault& fault = GetParam();
  const auto begin = steady_clock::now();
  {
    Solver solver = start("mock_solver", {"--fault", fault.name, "--at", std::to_string(fault.at)});
    std::string error = "none";
    try {
      advance_a_little(solver.join(2, {}));
    } catch (const std::exception& thrown) {
      error = thrown.what();
    }
    EXPECT_THAT(error, HasSubstr(fault.error));
    EXPECT_FALSE(solver.stop("", milliseconds(1000)));
  }
  EXPECT_LT(seconds_since(begin),
            10);  // three for a frozen peer, three to end it, and room for a busy machine
  EXPECT_THAT(text_of(log), HasSubstr(fault.in_log));
  EXPECT_TRUE(is_childless());
}

INSTANTIATE_TEST_SUITE_P(
    Protocol, Faults,
    ::testing::Values(
        Fault{"wrong-version", 0, "mock_fluid 0.1.0: refused: it uses protocol 3, the coupler uses 2",
              "the coupler refused this solver: it uses protocol 3"},
        Fault{"wrong-role", 0, "mock_fluid 0.1.0: refused: it is a solid solver, a fluid solver is expected",
              "the coupler refused this solver: it is a solid solver"},
        Fault{"wrong-token", 0, "mock_fluid 0.1.0: refused: it has the token of another run",
              "the coupler refused this solver: it has the token"},
        Fault{"garbage", 0, "the fluid solver: refused: a message of 4 bytes cannot be decoded",
              "cannot be decoded"},
        Fault{"exit", 0, "the fluid solver: it ended with exit code 7 (its hello was awaited for", ""},
        Fault{"exit", 2, "mock_fluid 0.1.0: it ended with exit code 7 (its answer to initialize was awaited",
              ""},
        Fault{"kill", 5,
              "mock_fluid 0.1.0: it was killed by signal 9 (Killed) (its answer to advance, window 2", ""},
        Fault{
            "stop", 4,
            "mock_fluid 0.1.0: the connection was lost: the peer has ended, or has sent no heartbeat for 3 s",
            ""},
        Fault{"wrong-length", 3,
              "mock_fluid 0.1.0: force has 9 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]",
              "the coupler ended the run: mock_fluid 0.1.0: force has 9 numbers"},
        Fault{"nan", 5, "mock_fluid 0.1.0: force of point 1 is nan [advance, window 2 (t = 0.002 s)]",
              "force of point 1 is nan"},
        Fault{"out-of-order", 3,
              "mock_fluid 0.1.0: it answers with saved instead of advanced [advance, window 0",
              "it answers with saved"},
        Fault{"wrong-sequence", 3,
              "mock_fluid 0.1.0: its answer has number 8 instead of 3 [advance, window 0",
              "its answer has number 8"},
        Fault{"garbage", 3, "mock_fluid 0.1.0: a message of 4 bytes cannot be decoded", "cannot be decoded"},
        Fault{"oversized", 3, "exceeds the limit of 1000000 [advance, window 0", "exceeds the limit"},
        Fault{"giant", 3, "(its answer to advance, window 0", "the connection was lost"},
        Fault{"long-hello", 0, "refused: a message of 100", "exceeds the limit of 65536"},
        Fault{"long-done", 1, "exceeds the limit of 65536 [welcome]", "exceeds the limit"},
        Fault{"many-notes", 3, "mock_fluid 0.1.0: 200 notes on one window, must be <= 100 [advance, window 0",
              "200 notes"},
        Fault{"many-columns", 2, "mock_fluid 0.1.0: 20001 columns, must be <= 10000 [initialize]",
              "20001 columns"},
        Fault{"column-name", 2, "the name of a column is \"../time\": it must have 1 to 100 characters",
              "the name of a column"},
        Fault{"throw", 0, "mock_fluid 0.1.0: the mock has diverged [advance, window 0 (t = 0 s)]",
              "mock_solver: the mock has diverged [advance, window 0"}),
    [](const auto& test) {
      std::string name = fmt::format("{}_at_{}", test.param.name, test.param.at);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST_F(Processes, ThatAreSlowAreNotTakenForDead) {
  // The mock sleeps longer than the limit without a sign of life.
  Solver solver = start("mock_solver", {"--fault", "sleep", "--at", "4"});
  EXPECT_NO_THROW(advance_a_little(solver.join(2, {})));
  EXPECT_GE(solver.participant().cost().waiting, 4);
}

TEST_F(Processes, ThatCannotBeStartedAreNamed) {
  EXPECT_THAT([&] { program_path("no_such_solver"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("no_such_solver is missing: it is neither in "),
                                         HasSubstr("libexec/cosurge"))));
  EXPECT_THAT([&] { SolverProcess({.program = "/nowhere/no_such_solver", .arguments = {}, .log = log}); },
              ThrowsMessage<Error>(HasSubstr("/nowhere/no_such_solver: No such file")));
  EXPECT_TRUE(is_childless());
}

TEST_F(Processes, AreToldOfAWrongCommandLineAndOfTheWrongConnectionFile) {
  SolverProcess wrong({.program = program_path("mock_fluid"), .arguments = {"--conect", "x"}, .log = log});
  EXPECT_FALSE(wrong.stop(milliseconds(5000)));
  EXPECT_THAT(wrong.ended().value_or(""), HasSubstr("exit code 2"));
  const Solver solid = Solver::by_hand(Role::solid, wiring(), "solid_solver");
  SolverProcess fluid({.program = program_path("mock_fluid"),
                       .arguments = {"--connect", (run.path() / "solid.connection").string()},
                       .log = log});
  EXPECT_FALSE(fluid.stop(milliseconds(5000)));
  EXPECT_THAT(text_of(log), HasSubstr("is for a solid solver, mock_fluid is a fluid solver"));
}

/// Another process that is the coupler of one run. It ends when the test kills it.
class OtherCoupler {
 public:
  /// `coupler` runs in the new process and returns the result for the test.
  template <typename Coupler>
  explicit OtherCoupler(Coupler&& coupler) {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ == 0) {
      const auto own = coupler([&](int told) { (void)!write(pipe[1], &told, sizeof told); });
      pause();
      _exit(0);
    }
    if (read(pipe[0], &number, sizeof number) != sizeof number)
      throw std::runtime_error("the other coupler failed");
    close(pipe[0]);
    close(pipe[1]);
  }

  ~OtherCoupler() { end(SIGKILL); }

  void signal(int number_of_signal) const { kill(pid_, number_of_signal); }

  void end(int number_of_signal) {
    if (pid_ < 0) return;
    kill(pid_, number_of_signal);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

  int number = 0;  // the number that it sent

 private:
  pid_t pid_ = -1;
};

TEST_F(Processes, AreEndedBySystemWhenTheCouplerThatStartedThemIsKilled) {
  prctl(PR_SET_CHILD_SUBREAPER,
        1);  // so that the orphan becomes this process's child, and its end can be seen
  OtherCoupler coupler([&](auto&& tell) {
    auto solver = std::make_unique<Solver>(start("mock_fluid"));
    advance_a_little(solver->join(2, {}));
    tell(0);
    return solver;
  });
  const auto begin = steady_clock::now();
  coupler.end(SIGKILL);
  int status = 0;
  while (waitpid(-1, &status, WNOHANG) == 0 && seconds_since(begin) < 5)
    std::this_thread::sleep_for(milliseconds(10));
  EXPECT_LT(seconds_since(begin), 5);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;  // also where it is stopped
  EXPECT_TRUE(is_childless());
}

/// A solver started by hand, whose coupler gets a signal.
class ByHand : public Processes, public ::testing::WithParamInterface<int> {};

TEST_P(ByHand, SolversEndInWordsWithinSecondsWhenTheCouplerDiesOrFreezes) {
  OtherCoupler coupler([&](auto&& tell) {
    auto solver = std::make_unique<Solver>(Solver::by_hand(Role::fluid, wiring(), "mock_fluid"));
    tell(0);
    advance_a_little(solver->join(2, {}));
    std::ofstream(scratch.path() / "ready") << "ready";
    return solver;
  });
  SolverProcess solver({.program = program_path("mock_fluid"),
                        .arguments = {"--connect", (run.path() / "fluid.connection").string()},
                        .log = log});
  const auto begin = steady_clock::now();
  while (!exists(scratch.path() / "ready") && seconds_since(begin) < 10)
    std::this_thread::sleep_for(milliseconds(5));
  ASSERT_TRUE(exists(scratch.path() / "ready")) << text_of(log);
  const auto end = steady_clock::now();
  coupler.signal(GetParam());
  EXPECT_FALSE(solver.stop(milliseconds(8000)));
  EXPECT_LT(seconds_since(end), 8);  // three without a sign of life, and room for a busy machine
  EXPECT_THAT(solver.ended().value_or("runs"), HasSubstr("exit code 1"));
  EXPECT_THAT(text_of(log), HasSubstr("mock_fluid: the coupler at ipc://"));
  EXPECT_THAT(text_of(log), HasSubstr("the connection was lost"));
}

INSTANTIATE_TEST_SUITE_P(Protocol, ByHand, ::testing::Values(SIGKILL, SIGSTOP),
                         [](const auto& test) { return test.param == SIGKILL ? "killed" : "frozen"; });

TEST_F(Processes, ThatNeverComeAreGivenUp) {
  Wiring impatient = wiring();
  impatient.patience = 0.5;
  Solver solver = Solver::by_hand(Role::fluid, impatient, "fluid_solver");
  EXPECT_THAT(solver.how_to_start(), HasSubstr("fluid_solver --connect " + run.path().string()));
  EXPECT_THAT([&] { solver.join(2, {}); },
              ThrowsMessage<PeerLost>(HasSubstr("the fluid solver: no message within 0.5 s")));
}

TEST(RunFolder, IsForItsOwnerOnlyAndGoesWithTheRun) {
  std::filesystem::path path;
  {
    const RunFolder run;
    path = run.path();
    EXPECT_EQ(status(path).permissions(), std::filesystem::perms::owner_all);
  }
  EXPECT_FALSE(exists(path));
}

}  // namespace
}  // namespace cosurge
