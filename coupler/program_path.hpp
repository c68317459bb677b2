// Where Cosurge's own programs are.
#pragma once

#include <filesystem>
#include <string>

namespace cosurge {

/// Path of a program of Cosurge: in the folder of the running program, as in a build, or in libexec/cosurge
/// of the installation that this library is in, wherever that was moved to.
/// @throws Error with both places where it is in neither.
std::filesystem::path program_path(const std::string& name);

}  // namespace cosurge
