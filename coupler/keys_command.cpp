#include "coupler/keys_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

#include "common/wire/keys.hpp"

namespace cosurge {
namespace {

std::string name_of_machine() {
  std::array<char, 256> name{};
  const bool known = gethostname(name.data(), name.size() - 1) == 0 && name[0] != '\0' && name[0] != '#';
  return known ? name.data() : "machine";
}

}  // namespace

std::string keys_command() {
  const std::optional<CurveKeys> before = machine_keys();
  const CurveKeys keys = before ? *before : make_machine_keys();
  return fmt::format(
      "# The public key of this machine{}, for the file that --allow of cosurge run names.\n"
      "# The secret key, which must stay here: {}\n{} {}\n",
      before ? "" : ", made now", secret_key_file().string(), name_of_machine(), keys.open);
}

}  // namespace cosurge
