// Words for whoever watches a run.
#pragma once

#include <fmt/format.h>

#include <cstdio>

namespace cosurge {

/// Writes to the standard output, at once. Whether anybody still reads it does not matter to a run.
template <typename... Args>
void say(fmt::format_string<Args...> message, Args&&... args) {
  std::fputs(fmt::format(message, std::forward<Args>(args)...).c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace cosurge
