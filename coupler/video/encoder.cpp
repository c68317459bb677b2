#include "coupler/video/encoder.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>

#include "common/error.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr const char* missing = "ffmpeg is not installed: on Debian, apt install ffmpeg";

/// Starts ffmpeg with a pipe as its input; its output goes to `log`. Returns an error number, 0 for none.
int start(const std::vector<std::string>& words, const fs::path& log, int input, pid_t& pid) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int error = posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

void Encoder::require_ffmpeg() {
  std::istringstream folders(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return;
  throw Error(missing);
}

Encoder::Encoder(const fs::path& file, int width, int height, double pictures_a_second)
    : file_(file), unfinished_(file.string() + ".part"), log_(file.string() + ".log") {
  std::signal(SIGPIPE, SIG_IGN);  // if ffmpeg has ended, the next write fails and reports it
  int pipe[2];
  require(::pipe2(pipe, O_CLOEXEC) == 0, "--video: {}", std::strerror(errno));
  const int error = start({"ffmpeg",
                           "-hide_banner",
                           "-loglevel",
                           "error",
                           "-y",
                           "-f",
                           "rawvideo",
                           "-pix_fmt",
                           "bgr0",
                           "-s",
                           fmt::format("{}x{}", width, height),
                           "-r",
                           fmt::format("{:.6g}", pictures_a_second),
                           "-i",
                           "-",
                           "-an",
                           "-c:v",
                           "libx264",
                           "-crf",
                           "20",
                           "-pix_fmt",
                           "yuv420p",
                           "-r",
                           "30",
                           "-movflags",
                           "+faststart",
                           "-f",
                           "mp4",
                           unfinished_.string()},
                          log_, pipe[0], ffmpeg_);
  ::close(pipe[0]);
  input_ = pipe[1];
  if (error != 0) ffmpeg_ = -1;
  require(error != ENOENT, missing);
  require(error == 0, "ffmpeg cannot be started: {}", std::strerror(error));
}

Encoder::~Encoder() {
  close();
  std::error_code none;
  fs::remove(unfinished_, none);
  fs::remove(log_, none);
}

void Encoder::add(const Canvas& picture) {
  const auto bytes = picture.pixels();
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(input_, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) close();
    require(n >= 0, "{}: ffmpeg failed: {}", file_.string(), last_words());
    done += static_cast<std::size_t>(n);
  }
}

void Encoder::finish() {
  require(close(), "{}: ffmpeg failed: {}", file_.string(), last_words());
  fs::rename(unfinished_, file_);
}

bool Encoder::close() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
  if (ffmpeg_ < 0) return false;
  int status = -1;
  while (::waitpid(ffmpeg_, &status, 0) < 0 && errno == EINTR) {
  }
  ffmpeg_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string Encoder::last_words() const {
  std::ostringstream text;
  text << std::ifstream(log_).rdbuf();
  std::string words = text.str();
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words.empty() ? "it gives no reason" : words;
}

}  // namespace cosurge
