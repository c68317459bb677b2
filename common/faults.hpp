// Three kinds of wrong: the user can fix it (Error), the numbers failed (NumericalError), we are wrong
// (assert). And one end that is no fault: Interrupted.
#pragma once

#include <stdexcept>

namespace cosurge {

/// Something that the user can mend; the message says what is wrong and what is allowed.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The computation cannot go on; the message says where, when, why, and what to try.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user has ended the run: neither a fault nor the numbers' failure.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cosurge
