#include "coupler/solver_process.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <thread>

#include "common/error.hpp"
#include "common/threads.hpp"

namespace cosurge {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds grace_of_destructor{500};
constexpr milliseconds grace_after_term{1000};

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> list;
  for (std::string& text : strings) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> passive_environment() {
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!std::string_view(*entry).starts_with("OMP_WAIT_POLICY=")) environment.emplace_back(*entry);
  }
  environment.emplace_back("OMP_WAIT_POLICY=passive");
  if (std::getenv("GOMP_SPINCOUNT") == nullptr)
    environment.push_back(std::string("GOMP_SPINCOUNT=") + short_spin);
  return environment;
}

struct Start {
  const char* program;
  char** arguments;
  char** environment;
  int input;
  int log;
  int report;  // receives the error number of a failed exec; closed by a successful one
  pid_t parent;
};

/// Runs between fork and exec. No function that takes a lock is allowed here, because another thread may have
/// held it.
[[noreturn]] void become(const Start& start) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);         // a stopped process would keep any other signal waiting
  if (getppid() != start.parent) _exit(1);  // it died before the line above
  // Signals to the terminal's whole group: the coupler ends the solvers in order.
  for (const int number : {SIGINT, SIGHUP, SIGUSR1, SIGUSR2}) signal(number, SIG_IGN);
  dup2(start.input, STDIN_FILENO);
  dup2(start.log, STDOUT_FILENO);
  dup2(start.log, STDERR_FILENO);
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  execve(start.program, start.arguments, start.environment);
  const int error = errno;
  const auto written = write(start.report, &error, sizeof error);
  _exit(written < 0 ? 2 : 1);
}

/// Throws for a failed system call: `error` is its errno.
void require_call(bool ok, int error, const std::string& subject, const char* what) {
  require(ok, "{}: {}: {}", subject, what, std::strerror(error));
}

/// The last line of a log after `begin`; empty if there is none.
std::string last_line(const std::filesystem::path& log, std::uintmax_t begin) {
  std::ifstream file(log);
  file.seekg(static_cast<std::streamoff>(begin));
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace

SolverProcess::SolverProcess(const Command& command) : log_(command.log) {
  std::vector<std::string> words = {command.program.string()};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> settings = passive_environment();
  std::vector<char*> arguments = pointers(words);
  std::vector<char*> environment = pointers(settings);
  // Appends, so that a resumed run keeps the earlier output. Links are not followed.
  const int log = open(command.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0644);
  require_call(log >= 0, errno, command.log.native(), "cannot be written");
  log_begin_ = std::filesystem::file_size(log_);
  const std::string nothing = "/dev/null";
  const int input = open(nothing.c_str(), O_RDONLY | O_CLOEXEC);
  require_call(input >= 0, errno, nothing, "cannot be read");
  std::array<int, 2> report{};
  const bool piped = pipe2(report.data(), O_CLOEXEC) == 0;
  require_call(piped, errno, words[0], "cannot be started: no pipe");
  const Start start{words[0].c_str(), arguments.data(), environment.data(), input, log, report[1], getpid()};

  pid_ = fork();
  if (pid_ == 0) become(start);
  int error = pid_ < 0 ? errno : 0;
  close(log);
  close(input);
  close(report[1]);
  const bool failed = pid_ < 0 || read(report[0], &error, sizeof error) == sizeof error;
  close(report[0]);
  if (!failed) return;
  if (pid_ > 0) waitpid(pid_, nullptr, 0);
  throw Error(fmt::format("cannot start {}: {}", words[0], std::strerror(error)));
}

SolverProcess::~SolverProcess() { stop(grace_of_destructor); }

std::optional<std::string> SolverProcess::ended() {
  if (!reap_within(milliseconds(0))) return std::nullopt;
  std::string words;
  if (WIFSIGNALED(*status_)) {
    const int number = WTERMSIG(*status_);
    words = fmt::format("it was killed by signal {} ({})", number, strsignal(number));
  } else {
    words = fmt::format("it ended with exit code {}", WEXITSTATUS(*status_));
  }
  const std::string line = *status_ == 0 ? "" : last_line(log_, log_begin_);
  return line.empty() ? words : fmt::format("{}; the last line of {}: {}", words, log_.string(), line);
}

bool SolverProcess::stop(milliseconds grace) {
  if (reap_within(grace)) return *status_ == 0;
  ::kill(pid_, SIGTERM);
  kill(grace_after_term);
  return false;
}

void SolverProcess::kill(milliseconds grace) {
  if (reap_within(grace)) return;
  ::kill(pid_, SIGKILL);
  while (!reap_within(milliseconds(1000))) continue;
}

bool SolverProcess::reap_within(milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (!status_) {
    int status = 0;
    const pid_t reaped = waitpid(pid_, &status, WNOHANG);
    if (reaped == pid_) status_ = status;
    if (reaped < 0 && errno != EINTR) status_ = 1 << 8;  // another wait took the exit code: unknown, not 0
    if (status_ || std::chrono::steady_clock::now() >= end) break;
    std::this_thread::sleep_for(milliseconds(5));
  }
  return status_.has_value();
}

}  // namespace cosurge
