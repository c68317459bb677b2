// Which build of Cosurge runs.
#pragma once

#include <string>

namespace cosurge {

/// The number that the linker has made from the contents of what computes (the library where it is shared,
/// else this program), in hexadecimal: another one where any source or compiler option differs. Empty where
/// it has none.
std::string build_id();

}  // namespace cosurge
