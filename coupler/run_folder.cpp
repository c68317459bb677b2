#include "coupler/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "common/error.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "cosurge-run-";

/// Locks a folder of this user and returns its descriptor; -1 if it is not such a folder or is locked. Where
/// the file system has no locks, -1 if one is `needed`, else the descriptor without one.
int lock(const fs::path& folder, bool needed) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat found {};
  const bool ours = ::fstat(descriptor, &found) == 0 && found.st_uid == ::geteuid() && found.st_nlink > 0;
  if (ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  if (ours && !needed && errno != EWOULDBLOCK) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Removes folders of runs that were killed. The process that removes one holds its lock.
void remove_abandoned(const fs::path& parent) {
  std::error_code failed;
  for (fs::directory_iterator entry(parent, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (!entry->path().filename().native().starts_with(prefix)) continue;
    const int descriptor = lock(entry->path(), true);
    if (descriptor < 0) continue;
    std::error_code none;
    fs::remove_all(entry->path(), none);
    ::close(descriptor);
  }
}

}  // namespace

RunFolder::RunFolder() {
  // The path of a socket is limited to 107 characters; if TMPDIR is too long, another folder is used.
  constexpr std::size_t longest = 60;
  fs::path parent = fs::temp_directory_path();
  if (parent.native().size() > longest) parent = "/tmp";
  remove_abandoned(parent);
  constexpr int tries = 100;  // another run may remove a new folder as abandoned before it is locked
  for (int k = 0; k < tries && locked_ < 0; ++k) {
    std::string name = (parent / (std::string(prefix) + "XXXXXX")).string();
    const bool made = ::mkdtemp(name.data()) != nullptr;
    const int error = made ? 0 : errno;
    require(made, "cannot create a folder in {}: {}", parent.string(), std::strerror(error));
    path_ = name;
    locked_ = lock(path_, false);
  }
  require(locked_ >= 0, "{}: cannot be locked", path_.string());
}

RunFolder::~RunFolder() {
  std::error_code none;
  fs::remove_all(path_, none);
  ::close(locked_);
}

}  // namespace cosurge
