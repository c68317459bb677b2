#include "common/wire/connection.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "common/error.hpp"

namespace cosurge {
namespace {

Role role_of(const std::string& name) {
  require(name == "fluid" || name == "solid", "role is \"{}\", must be fluid or solid", name);
  return name == "fluid" ? Role::fluid : Role::solid;
}

}  // namespace

const char* role_name(Role role) { return role == Role::fluid ? "fluid" : "solid"; }

std::string new_token() {
  std::random_device random;
  std::string token;
  for (int word = 0; word < 4; ++word) token += fmt::format("{:08x}", random());
  return token;
}

void write_connection(const Connection& connection, const std::filesystem::path& path) {
  const nlohmann::ordered_json json = {{"role", role_name(connection.role)},
                                       {"endpoint", connection.endpoint},
                                       {"token", connection.token},
                                       {"server_key", connection.server_key}};
  const std::string text = json.dump(2) + "\n";
  std::error_code none;
  std::filesystem::remove(path, none);
  // The mode must hold from the first instant, which an ofstream cannot promise.
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  require(file >= 0, "{}: cannot write: {}", path.string(), std::strerror(errno));
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int error = errno;
  ::close(file);
  require(written, "{}: cannot write: {}", path.string(), std::strerror(error));
}

Connection read_connection(const std::filesystem::path& path) {
  std::ifstream file(path);
  require(file.good(), "{}: cannot read the connection file", path.string());
  try {
    const nlohmann::json json = nlohmann::json::parse(file);
    return {.role = role_of(json.at("role").get<std::string>()),
            .endpoint = json.at("endpoint").get<std::string>(),
            .token = json.at("token").get<std::string>(),
            .server_key = json.at("server_key").get<std::string>()};
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: not a connection file: {}", path.string(), error.what()));
  }
}

}  // namespace cosurge
