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

/// Owns the child from its start to its end: no process is left behind, not even when this one is killed. The
/// child waits passively in OpenMP, reads nothing, and ignores the interrupt from the keyboard, which is the
/// coupler's.
class SolverProcess {
 public:
  /// Must be called by a thread that outlives the child: the system ends the child with the thread that
  /// started it.
  /// @throws Error where the program cannot be started.
  explicit SolverProcess(const Command& command);

  /// stop() with little grace.
  ~SolverProcess();

  SolverProcess(const SolverProcess&) = delete;
  SolverProcess& operator=(const SolverProcess&) = delete;

  pid_t pid() const { return pid_; }

  /// How the child has ended, in words, with the last line of its log where it failed; nothing while it runs.
  std::optional<std::string> ended();

  /// Waits `grace` for the child to end by itself, then asks it to (SIGTERM), then ends it (SIGKILL).
  /// True where it has ended by itself and without an error.
  bool stop(std::chrono::milliseconds grace);

  /// Waits `grace` for the child to end by itself, then ends it (SIGKILL), also where it is stopped.
  void kill(std::chrono::milliseconds grace);

 private:
  bool reap_within(std::chrono::milliseconds time);

  pid_t pid_ = -1;
  std::filesystem::path log_;
  std::uintmax_t log_begin_ = 0;  // where this child's output begins in it
  std::optional<int> status_;     // as of waitpid
};

}  // namespace cosurge
