// Which build of Cosurge runs.
#pragma once

#include <string>

namespace cosurge {

/// The number that the linker has made from the contents of this program, in hexadecimal: another one where
/// any source or compiler option differs. Empty where the program has none.
std::string build_id();

}  // namespace cosurge
