// Messages to the user of a run.
#pragma once

#include <fmt/format.h>

#include <cstdio>

#include "common/wire/wire_words.hpp"

namespace cosurge {

/// Writes to the standard output without buffering. Control characters are removed, because the text may
/// contain words of cases and solvers. Errors are ignored: the run continues if nobody reads its output.
template <typename... Args>
void say(fmt::format_string<Args...> message, Args&&... args) {
  std::fputs(printable(fmt::format(message, std::forward<Args>(args)...)).c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace cosurge
