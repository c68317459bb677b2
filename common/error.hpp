// An error that the user can correct, checked with its message.
#pragma once

#include <fmt/format.h>

#include <string>

#include "common/faults.hpp"

namespace cosurge {

/// Throws Error with the formatted message unless `ok`.
template <typename... Args>
void require(bool ok, fmt::format_string<Args...> message, Args&&... args) {
  if (!ok) throw Error(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace cosurge
