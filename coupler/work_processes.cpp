#include "coupler/work_processes.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <map>
#include <thread>

#include "common/error.hpp"
#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

pid_t start(std::size_t k, const std::function<void(std::size_t)>& work) {
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) throw Error(fmt::format("cannot start a process for another cell: {}", std::strerror(errno)));
  if (pid > 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it died before the line above
  int status = 1;
  try {
    work(k);
    status = 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", printable(error.what()));
  }
  _exit(status);
}

std::string fault_of(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("its process was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == 0) return "";
  return fmt::format("its process ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

void in_processes(std::size_t count, int most, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& ended) {
  constexpr std::chrono::milliseconds look_around{10};
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  while (next < count || !running.empty()) {
    while (next < count && static_cast<int>(running.size()) < most) {
      const pid_t pid = start(next, work);
      running[pid] = next++;
    }
    // Waits for each by its process id, because this process may have other children.
    for (auto one = running.begin(); one != running.end();) {
      int status = 0;
      const pid_t pid = waitpid(one->first, &status, WNOHANG);
      if (pid == 0 || (pid < 0 && errno == EINTR)) {
        ++one;
        continue;
      }
      ended(one->second, pid < 0 ? "its process was lost" : fault_of(status));
      one = running.erase(one);
    }
    std::this_thread::sleep_for(look_around);
  }
}

}  // namespace cosurge
