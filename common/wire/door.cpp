#include "common/wire/door.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

constexpr std::size_t request_frames = 7;
enum Frame : std::size_t { protocol, number, domain, address, identity, mechanism, credentials };

std::vector<std::string> question(zmq::socket_t& socket) {
  std::vector<std::string> frames;
  zmq::message_t frame;
  while (socket.recv(frame, zmq::recv_flags::dontwait)) {
    frames.push_back(frame.to_string());
    if (!frame.more()) break;
  }
  return frames;
}

/// A public key as it is written; empty where the bytes are none.
std::string key_of(const std::string& bytes) {
  std::array<char, 41> text{};
  constexpr std::size_t size = 32;
  if (bytes.size() != size) return "";
  zmq_z85_encode(text.data(), reinterpret_cast<const std::uint8_t*>(bytes.data()), size);
  return text.data();
}

}  // namespace

Door::Door(zmq::context_t& context, std::vector<AllowedMachine> allowed)
    : allowed_(std::move(allowed)), socket_(context, zmq::socket_type::rep) {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.bind("inproc://zeromq.zap.01");
}

void Door::answer() {
  for (std::vector<std::string> asked = question(socket_); !asked.empty(); asked = question(socket_)) {
    asked.resize(std::max(asked.size(), request_frames));
    const std::string key = asked[mechanism] == "CURVE" ? key_of(asked[credentials]) : "";
    const auto found = std::find_if(allowed_.begin(), allowed_.end(),
                                    [&](const AllowedMachine& machine) { return machine.key == key; });
    const bool allowed = found != allowed_.end();
    if (!allowed)
      refused_ = fmt::format("{} was refused: its public key {} is not among those allowed",
                             printable(asked[address]), key);
    const std::array<std::string, 6> reply = {"1.0",
                                              asked[number],
                                              allowed ? "200" : "400",
                                              allowed ? "OK" : "key not allowed",
                                              allowed ? found->name : "",
                                              ""};
    for (std::size_t k = 0; k < reply.size(); ++k)
      socket_.send(zmq::buffer(reply[k]),
                   k + 1 < reply.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
  }
}

}  // namespace cosurge
