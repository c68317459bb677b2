// Messages to the user of a run.
#pragma once

#include <fmt/format.h>

#include <cstdio>

#include "common/wire/wire_words.hpp"

namespace cosurge {

/// Writes to the standard output, at once, without control characters: words of cases and solvers may be in
/// it. Whether anybody still reads it does not matter to a run.
template <typename... Args>
void say(fmt::format_string<Args...> message, Args&&... args) {
  std::fputs(printable(fmt::format(message, std::forward<Args>(args)...)).c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace cosurge
