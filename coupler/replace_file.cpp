#include "coupler/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "common/error.hpp"

namespace cosurge {
namespace {

/// Writes all of `text`. Returns false if the system rejects it; errno has the reason.
bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Flushes to the disk; otherwise a machine that fails may keep the new name and lose the text. EINVAL: not a
/// file on a disk.
bool reaches_disk(int file) { return ::fsync(file) == 0 || errno == EINVAL; }

}  // namespace

void replace_file(const std::filesystem::path& path, std::initializer_list<std::string_view> parts) {
  const std::filesystem::path fresh = path.string() + ".new";
  const auto reason = [](int cause) { return std::generic_category().message(cause); };
  // Removes an incomplete earlier file; created anew, it cannot be a link to another file.
  ::unlink(fresh.c_str());
  const int file = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const int refused = errno;
  require(file >= 0, "{}: cannot be written: {}", fresh.string(), reason(refused));
  bool written = true;
  for (const std::string_view part : parts) written = written && write_all(file, part);
  written = written && reaches_disk(file);
  const int cause = errno;
  ::close(file);
  std::error_code renamed;
  if (!written) std::filesystem::remove(fresh, renamed);  // frees its space on a full disk
  require(written, "{}: cannot be written: {}", fresh.string(), reason(cause));
  std::filesystem::rename(fresh, path, renamed);
  require(!renamed, "{}: cannot be replaced: {}", path.string(), renamed.message());
}

}  // namespace cosurge
