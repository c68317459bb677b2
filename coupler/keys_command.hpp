// cosurge keys: the keys of this machine, for runs across machines.
#pragma once

#include <string>

namespace cosurge {

/// Makes the keys of this machine unless it has some. The text says where the secret key lies, and has a line
/// "NAME KEY" with the public key: the whole text can be appended to a file for --allow.
/// @throws Error where the keys cannot be written or read.
std::string keys_command();

}  // namespace cosurge
