// CURVE keys: the pair of this machine, and the public keys of machines that may connect.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cosurge {

/// Both keys as ZeroMQ writes them (Z85): 40 characters.
struct CurveKeys {
  std::string open;
  std::string secret;
};

/// A pair for one connection. @throws Error where ZeroMQ was built without CURVE.
CurveKeys new_curve_keys();

/// The file with the secret key of this machine and user: cosurge/secret_key in $XDG_CONFIG_HOME, or in
/// .config of the home folder.
std::filesystem::path secret_key_file();

/// The pair of this machine; nothing where none was made.
/// @throws Error where the file is damaged, or others may read it.
std::optional<CurveKeys> machine_keys();

/// Makes the pair of this machine and writes the secret key to its file, which only its owner can read.
/// @throws Error where the file exists or cannot be written.
CurveKeys make_machine_keys();

/// A machine that may connect.
struct AllowedMachine {
  std::string name;
  std::string key;  ///< public
};

/// Reads a list of machines: a line NAME KEY each, as `cosurge keys` prints it; empty lines and lines that
/// begin with # are skipped.
/// @throws Error with all wrong lines; or where there is no machine in it, or others may write to it.
std::vector<AllowedMachine> read_allowed_machines(const std::filesystem::path& file);

}  // namespace cosurge
