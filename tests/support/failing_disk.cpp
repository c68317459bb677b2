// A library that is preloaded into a program. It makes the N-th and all later writes to files whose path
// contains a word fail, or kills the program at the N-th.
//   FAILING_DISK_PATH     word in the path
//   FAILING_DISK_AT       N, from 1; 0: none, only count
//   FAILING_DISK_ERROR    number of the error; 0: SIGKILL
//   FAILING_DISK_COUNT    file that gets the number of writes at the end of the program
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>

namespace {

std::atomic<long> writes = 0;

const char* setting(const char* name, const char* otherwise) {
  const char* value = getenv(name);
  return value == nullptr ? otherwise : value;
}

bool is_meant(int file) {
  static const char* const word = setting("FAILING_DISK_PATH", "");
  if (*word == '\0') return false;
  char link[64];
  char path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return false;
  path[length] = '\0';
  return path[0] == '/' && strstr(path, word) != nullptr;
}

/// Whether this write fails; errno is set then.
bool fails(int file) {
  static const long at = atol(setting("FAILING_DISK_AT", "0"));
  static const int error = atoi(setting("FAILING_DISK_ERROR", "0"));
  if (!is_meant(file)) return false;
  const long count = ++writes;
  if (at == 0 || count < at) return false;
  if (error == 0) kill(getpid(), SIGKILL);
  errno = error;
  return true;
}

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

struct Report {
  ~Report() {
    const char* const path = setting("FAILING_DISK_COUNT", "");
    if (*path == '\0') return;
    if (FILE* file = fopen(path, "w")) {
      fprintf(file, "%ld\n", writes.load());
      fclose(file);
    }
  }
} report;

}  // namespace

extern "C" {

ssize_t write(int file, const void* bytes, size_t size) {
  static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
  return fails(file) ? -1 : real(file, bytes, size);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  static const auto real = next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
  return fails(file) ? -1 : real(file, bytes, size, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  static const auto real = next<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
  return fails(file) ? -1 : real(file, bytes, size, at);
}

int ftruncate(int file, off_t size) {
  static const auto real = next<int (*)(int, off_t)>("ftruncate");
  return fails(file) ? -1 : real(file, size);
}

int fsync(int file) {
  static const auto real = next<int (*)(int)>("fsync");
  return fails(file) ? -1 : real(file);
}

int fdatasync(int file) {
  static const auto real = next<int (*)(int)>("fdatasync");
  return fails(file) ? -1 : real(file);
}

}  // extern "C"
