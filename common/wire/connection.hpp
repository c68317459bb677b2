// Where a solver finds its coupler, and the file that tells it.
#pragma once

#include <filesystem>
#include <string>

#include "common/participant.hpp"

namespace cosurge {

/// The end of a wire that waits for one solver of one run.
struct Connection {
  Role role = Role::fluid;
  std::string endpoint{};    ///< ipc:///path or tcp://host:port
  std::string token{};       ///< secret of the run
  std::string server_key{};  ///< CURVE public key of the coupler (Z85), for tcp only
};

/// "fluid" or "solid".
const char* role_name(Role role);

/// 128 random bits in hexadecimal.
std::string new_token();

/// Writes a JSON file that only its owner can read; an older one is replaced.
/// @throws Error where the file cannot be written.
void write_connection(const Connection& connection, const std::filesystem::path& path);

/// @throws Error where the file cannot be read or is not complete.
Connection read_connection(const std::filesystem::path& path);

}  // namespace cosurge
