#include "common/wire/keys.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <zmq.hpp>

#include "common/error.hpp"
#include "common/text_file.hpp"
#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t length = 40;
using Text = std::array<char, length + 1>;  // with the closing zero

/// Whether a text is 32 bytes in Z85.
bool is_key(const std::string& text) {
  std::array<std::uint8_t, 32> bytes{};
  return text.size() == length && zmq_z85_decode(bytes.data(), text.c_str()) != nullptr;
}

/// Checks what others than the owner may do with a file. `bits`: that they must not have.
void require_private(const fs::path& file, mode_t bits, const char* what, const char* remedy) {
  struct stat about {};
  const bool known = stat(file.c_str(), &about) == 0;
  require(known && (about.st_mode & bits) == 0, "{}: {}; chmod {} {}", file.string(), what, remedy,
          file.string());
}

}  // namespace

CurveKeys new_curve_keys() {
  Text open{}, secret{};
  require(zmq_has("curve") == 1 && zmq_curve_keypair(open.data(), secret.data()) == 0,
          "this ZeroMQ was built without CURVE encryption, which tcp:// needs");
  return {.open = open.data(), .secret = secret.data()};
}

fs::path secret_key_file() {
  const char* settings = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  const bool given = settings != nullptr && *settings == '/';
  require(given || (home != nullptr && *home == '/'),
          "no folder for the key of this machine: neither XDG_CONFIG_HOME nor HOME is set");
  return (given ? fs::path(settings) : fs::path(home) / ".config") / "cosurge" / "secret_key";
}

std::optional<CurveKeys> machine_keys() {
  const fs::path file = secret_key_file();
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  require_private(file, S_IRWXG | S_IRWXO, "others may read the secret key of this machine", "600");
  std::string secret = file_contents(file);
  if (secret.ends_with('\n')) secret.pop_back();
  Text open{};
  require(is_key(secret) && zmq_curve_public(open.data(), secret.c_str()) == 0,
          "{}: is not a secret key of {} characters; remove it, and run cosurge keys", file.string(), length);
  return CurveKeys{.open = open.data(), .secret = secret};
}

CurveKeys make_machine_keys() {
  const fs::path path = secret_key_file();
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  require(!failed, "{}: cannot be created: {}", path.parent_path().string(), failed.message());
  CurveKeys keys = new_curve_keys();
  const std::string text = keys.secret + "\n";
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  require(file >= 0, "{}: cannot be written: {}", path.string(), std::strerror(errno));
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int error = errno;
  ::close(file);
  if (!written) fs::remove(path, failed);
  require(written, "{}: cannot be written: {}", path.string(), std::strerror(error));
  return keys;
}

std::vector<AllowedMachine> read_allowed_machines(const fs::path& file) {
  const std::vector<std::string> lines = lines_of(without_byte_order_mark(file_contents(file), file));
  require_private(file, S_IWOTH, "anybody on this machine may add a key to it", "o-w");
  std::vector<AllowedMachine> machines;
  std::vector<std::string> errors;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::istringstream words(lines[k]);
    std::string name, key, more;
    if (!(words >> name) || name.front() == '#') continue;
    words >> key >> more;
    const bool right = is_key(key) && more.empty();
    if (!right)
      errors.push_back(fmt::format(
          "{}:{}: must have a name and a public key of {} characters, as cosurge keys prints them: {}",
          file.string(), k + 1, length, clipped(printable(lines[k]))));
    machines.push_back({.name = name, .key = key});
  }
  require(errors.empty(), "{}", fmt::join(errors, "\n"));
  require(!machines.empty(),
          "{}: has no machine in it: nobody could connect; add the line that cosurge keys prints on the "
          "machine of the solver",
          file.string());
  return machines;
}

}  // namespace cosurge
