#include "coupler/interruption.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <ctime>

namespace cosurge {
namespace {

std::atomic<int> noted = 0;  // number of the signal
std::atomic<int> count = 0;
std::atomic<double> first = 0;  // [s] when the first one came
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<double>::is_always_lock_free,
              "a signal handler may set them");

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void note(int signal) {
  if (noted == 0) first = now();
  noted = signal;
  ++count;
}

}  // namespace

void note_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE}) std::signal(signal, note);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may grow no further is reported by the failing write
  if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool interrupted() { return noted != 0; }

bool overdue() {
  constexpr double time_for_a_window = 1;  // [s] to end the current one, so that none of it is lost
  return interrupted() && (count > 1 || now() - first > time_for_a_window);
}

std::optional<std::string> interruption() {
  if (!interrupted()) return std::nullopt;
  return fmt::format("signal {} ({})", noted.load(), strsignal(noted));
}

}  // namespace cosurge
