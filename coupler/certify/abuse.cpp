#include "coupler/certify/abuse.hpp"

#include <thread>

#include "common/version.hpp"
#include "common/wire/convert.hpp"

namespace cosurge::certify {

Abuse::Abuse(const CertifyOptions& options)
    : channel_(Channel::listen(fmt::format("ipc://{}/wire", folder_.path().string()),
                               {.peer = "the program", .patience = options.patience})),
      token_(new_token()),
      process_(start(options)) {
  channel_.set_peer_ended([this] { return process_.ended(); });
  channel_.receive(reply_, "its hello");
  require(reply_.has_hello(), "its first message is not a Hello");
}

const v1::Reply& Abuse::ask(v1::Request request) {
  request.set_sequence(++sequence_);
  channel_.send(request);
  channel_.receive(reply_, "its answer");
  return reply_;
}

void Abuse::welcome() {
  v1::Request request;
  request.mutable_welcome()->set_protocol(protocol_version);
  request.mutable_welcome()->set_program("cosurge");
  request.mutable_welcome()->set_version(version);
  request.mutable_welcome()->set_token(token_);
  require(ask(request).has_done(), "does not answer Welcome with Done");
}

v1::Request Abuse::initialize(const CertifyOptions& options) const {
  v1::Request request;
  const v1::Case c = scene_for(options, folder_.path());
  *request.mutable_initialize()->mutable_the_case() = c;
  if (options.role == Role::solid) {
    const Interface points = points_of_plate(c);
    encode(points, *request.mutable_initialize()->mutable_interface());
    encode(InterfaceLoad::zero(2, points.points()), *request.mutable_initialize()->mutable_load());
  }
  return request;
}

v1::Request Abuse::advance(const CertifyOptions& options) const {
  v1::Request request;
  encode(Window{.index = 0, .start = 0, .size = size}, *request.mutable_advance()->mutable_window());
  const int numbers = options.role == Role::solid ? 2 * 3 * 20 : reply_.initialized().load().force_size();
  if (options.role == Role::solid) {
    request.mutable_advance()->mutable_load()->mutable_force()->Resize(numbers, 0.0);
    request.mutable_advance()->mutable_load()->mutable_pressure()->Resize(numbers / 2, 0.0);
  } else {
    request.mutable_advance()->mutable_motion()->mutable_displacement()->Resize(numbers, 0.0);
    request.mutable_advance()->mutable_motion()->mutable_velocity()->Resize(numbers, 0.0);
  }
  return request;
}

google::protobuf::RepeatedField<double>& Abuse::numbers_of(v1::Request& request) {
  v1::Advance& advance = *request.mutable_advance();
  return advance.has_load() ? *advance.mutable_load()->mutable_force()
                            : *advance.mutable_motion()->mutable_velocity();
}

void Abuse::send(v1::Request request, int skip) {
  request.set_sequence(sequence_ += 1 + static_cast<std::uint64_t>(skip));
  channel_.send(request);
}

void Abuse::expect_failure(bool says_so) {
  try {
    channel_.receive(reply_, "its Failure");
    require(reply_.has_failure(), "continues without reporting the error");
    require(!reply_.failure().what().empty(), "sends a Failure without a message");
  } catch (const PeerLost&) {
    require(!says_so, "ends without sending a Failure");
  }
  const auto start = std::chrono::steady_clock::now();
  while (!process_.ended() && std::chrono::steady_clock::now() - start < to_end)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  require(process_.ended().has_value(), "still runs {} s later", to_end.count());
  require(!process_.stop(std::chrono::milliseconds(0)), "ends with exit code 0");
}

SolverProcess Abuse::start(const CertifyOptions& options) const {
  const auto file = folder_.path() / "connection";
  write_connection({.role = options.role, .endpoint = channel_.endpoint(), .token = token_, .server_key = {}},
                   file);
  std::vector<std::string> arguments(options.command.begin() + 1, options.command.end());
  arguments.insert(arguments.end(), {"--connect", file.string(), "--threads", "1"});
  return SolverProcess(
      {.program = options.command.front(), .arguments = arguments, .log = folder_.path() / "log"});
}

}  // namespace cosurge::certify
