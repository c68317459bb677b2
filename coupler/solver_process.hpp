// A solver program as a child of this process.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cosurge {

/// How to start a solver program.
struct Command {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::filesystem::path log;  ///< the program's output is appended to it
};

/// Owns the child from its start to its end: no process is left behind, not even if this one is killed. In
/// the child, OpenMP threads wait passively, the standard input is empty, and the interrupt signal of the
/// keyboard is ignored, because the coupler handles it.
class SolverProcess {
 public:
  /// Must be called by a thread that outlives the child: the system ends the child with the thread that
  /// started it.
  /// @throws Error where the program cannot be started.
  explicit SolverProcess(const Command& command);

  /// Calls stop() with a short grace time.
  ~SolverProcess();

  SolverProcess(const SolverProcess&) = delete;
  SolverProcess& operator=(const SolverProcess&) = delete;

  pid_t pid() const { return pid_; }

  /// How the child has ended, in words, with the last line of its log if it failed; empty while it runs.
  std::optional<std::string> ended();

  /// Waits `grace` for the child to end by itself, then asks it to end (SIGTERM), then kills it (SIGKILL).
  /// Returns true if it ended by itself and without an error.
  bool stop(std::chrono::milliseconds grace);

  /// Waits `grace` for the child to end by itself, then kills it (SIGKILL), even if it is stopped.
  void kill(std::chrono::milliseconds grace);

 private:
  bool reap_within(std::chrono::milliseconds time);

  pid_t pid_ = -1;
  std::filesystem::path log_;
  std::uintmax_t log_begin_ = 0;  // position in the log where this child's output begins
  std::optional<int> status_;     // exit status as waitpid returns it; empty while the child runs
};

}  // namespace cosurge
