#include "coupler/result_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "common/error.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

/// Makes a folder and its parents. False if it exists: of several callers at once only one makes it.
bool make(const fs::path& folder) {
  std::error_code failed;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), failed);
  const bool made = !failed && !fs::exists(folder) && fs::create_directory(folder, failed);
  require(!failed, "{}: cannot be created: {}", folder.string(), failed.message());
  return made;
}

/// True also for a link to a missing file: writing to it would create a file elsewhere.
bool is_taken(const fs::path& path) { return fs::exists(fs::symlink_status(path)); }

bool holds_a_run(const fs::path& folder) {
  for (const char* name : {"results.h5", "results.xdmf", "summary.json", "checkpoint", "checkpoint.old"})
    for (const char* state : {"", ".new"})
      if (is_taken(folder / (std::string(name) + state))) return true;
  std::error_code unknown;  // an unreadable folder is rejected when files are written to it
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unknown))
    if (entry.path().filename().string().ends_with("_solver.log")) return true;
  return false;
}

}  // namespace

std::string case_name(const fs::path& case_path) {
  fs::path path = fs::absolute(case_path).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();  // "cases/mine/"
  return fs::is_directory(path) ? path.filename().string() : path.parent_path().filename().string();
}

ResultFolder::ResultFolder(const fs::path& case_path, const fs::path& out) {
  if (!out.empty()) {
    path_ = out.lexically_normal();
    if (path_.filename().empty()) path_ = path_.parent_path();  // "results/mine/"
    make(path_);
    require(fs::is_directory(path_), "{}: is not a folder; choose another --out", path_.string());
    require(lock(), "{}: another run has just taken it; choose another --out", path_.string());
    require(!holds_a_run(path_), "{}: holds results already; choose another --out", path_.string());
    return;
  }
  const std::string name = case_name(case_path);
  path_ = fs::path("results") / name;
  for (int number = 2; !make(path_) || !lock(); ++number)
    path_ = fs::path("results") / fmt::format("{}-{}", name, number);
}

ResultFolder::ResultFolder(const fs::path& existing) : path_(existing) {
  require(fs::is_directory(path_), "{}: contains no results", path_.string());
  require(lock(),
          "{}: a run is in progress in this folder; wait until it ends, or stop it (Ctrl-C or SIGTERM), then "
          "resume",
          path_.string());
}

ResultFolder ResultFolder::of_a_run(const fs::path& folder) { return ResultFolder(folder); }

bool ResultFolder::in_use(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool used = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return used;
}

ResultFolder::~ResultFolder() {
  if (locked_ >= 0) close(locked_);
}

/// If folders cannot be locked (some network drives), the process that created it owns it.
bool ResultFolder::lock() {
  locked_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (locked_ < 0 || flock(locked_, LOCK_EX | LOCK_NB) == 0) return true;
  if (errno != EWOULDBLOCK) return true;
  close(locked_);
  locked_ = -1;
  return false;
}

}  // namespace cosurge
