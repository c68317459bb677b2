// Three kinds of wrong: the user can fix it (Error), the numbers failed (NumericalError), we are wrong
// (assert). Interrupted is not an error.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace cosurge {

/// An error that the user can correct; the message says what is wrong and what is allowed.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The computation cannot continue; the message gives place, time, reason and remedy.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user has ended the run: neither a fault nor the numbers' failure.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws Error with the formatted message unless `ok`.
template <typename... Args>
void require(bool ok, fmt::format_string<Args...> message, Args&&... args) {
  if (!ok) throw Error(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace cosurge
