// Memory and files of the test's own process.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace cosurge::testing {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// Whether the memory of the program can be measured: not with sanitizers, which keep freed memory and a
/// shadow of all memory.
constexpr bool memory_can_be_measured = false;
#else
constexpr bool memory_can_be_measured = true;
#endif

/// Memory that this process has now [kB].
inline double own_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double value = 0;
    if (word == "VmRSS:" && status >> value) return value;
  }
  return 0;
}

/// Number of its open files.
inline std::size_t open_files() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    count += !entry.path().empty();
  return count;
}

}  // namespace cosurge::testing
