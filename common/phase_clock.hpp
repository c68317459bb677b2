// Wall time by phase of a step, and CPU time of the process.
#pragma once

#include <array>
#include <chrono>
#include <ctime>

namespace cosurge {

/// Adds up the wall time of the phases of a step. Phases follow each other: `enter(k)` ends the one before.
template <std::size_t phases>
class PhaseClock {
 public:
  void enter(std::size_t phase) {
    leave();
    current_ = phase;
    running_ = true;
  }

  void leave() {
    const auto now = std::chrono::steady_clock::now();
    if (running_) seconds_[current_] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    running_ = false;
  }

  const std::array<double, phases>& seconds() const { return seconds_; }

 private:
  std::array<double, phases> seconds_{};
  std::size_t current_ = 0;
  bool running_ = false;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

/// CPU time of this process, all threads [s].
inline double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace cosurge
