// Cosurge's own program, and a case that it goes through in seconds.
#pragma once

#include <string>

namespace cosurge::testing {

inline const std::string cosurge_program = COSURGE_PROGRAMS "/cosurge";
inline const std::string small_dam_break = COSURGE_SOURCE_DIR "/tests/cases/small_dam_break";

}  // namespace cosurge::testing
