#include "coupler/interruption.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstring>

namespace cosurge {
namespace {

std::atomic<int> noted = 0;  // number of the signal
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may set it");

void note(int signal) { noted = signal; }

}  // namespace

void note_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE}) std::signal(signal, note);
  if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool interrupted() { return noted != 0; }

std::optional<std::string> interruption() {
  if (!interrupted()) return std::nullopt;
  return fmt::format("signal {} ({})", noted.load(), strsignal(noted));
}

}  // namespace cosurge
