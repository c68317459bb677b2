// The kinds of errors: the user can correct it (Error), the computation failed (NumericalError), the program
// is wrong (assert). Interrupted is not an error.
#pragma once

#include <stdexcept>

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

/// The user has interrupted the run.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cosurge
