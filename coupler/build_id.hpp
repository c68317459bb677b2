// Which build of Cosurge runs.
#pragma once

#include <string>

namespace cosurge {

/// The build ID of the library, or of the program if it contains the library, in hexadecimal: the linker
/// computes it from the contents, so that it differs where any source or compiler option differs. Empty if
/// there is none.
std::string build_id();

}  // namespace cosurge
