#include "common/wire/line.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <mutex>
#include <vector>

#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr int heartbeat_interval = 250;     // [ms]
constexpr int handshake_time = 3000;        // [ms] time limit for a TCP connection to show its key
constexpr double look_at_strangers = 0.01;  // [s] interval between checks of their data
constexpr int waiting_messages = 4;         // longest queue for a peer that sends unrequested messages
constexpr int connect_time = 2000;  // [ms] until a connection to a coupler with a full queue is retried
constexpr int watched_events = ZMQ_EVENT_LISTENING | ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_HANDSHAKE_SUCCEEDED |
                               ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL |
                               ZMQ_EVENT_HANDSHAKE_FAILED_AUTH | ZMQ_EVENT_DISCONNECTED;

bool is_tcp(const std::string& endpoint) { return endpoint.starts_with("tcp://"); }

void check(const std::string& endpoint) {
  constexpr std::size_t longest_path = 107;  // sizeof sockaddr_un::sun_path, less the closing zero
  const bool ipc = endpoint.starts_with("ipc://");
  require(ipc || is_tcp(endpoint), "endpoint {}: must begin with ipc:// or tcp://", endpoint);
  require(
      !ipc || endpoint.size() - std::strlen("ipc://") <= longest_path,
      "endpoint {}: the path is longer than the {} characters that a Unix socket can have; set TMPDIR to a "
      "shorter folder",
      endpoint, longest_path);
}

/// One context for all lines of a process, so that one thread serves them: it is still awake when a message
/// on one line causes a message on another.
std::shared_ptr<zmq::context_t> context_of_process() {
  static std::mutex mutex;
  static std::weak_ptr<zmq::context_t> shared;
  const std::lock_guard lock(mutex);
  auto context = shared.lock();
  if (!context) shared = context = std::make_shared<zmq::context_t>(1);
  return context;
}

/// Whether only this machine can reach an address of TCP.
bool is_loopback(const std::string& endpoint) {
  const std::string host = endpoint.substr(std::strlen("tcp://"));
  return host.starts_with("127.") || host.starts_with("localhost:") || host.starts_with("[::1]:") ||
         host.starts_with("lo:");
}

/// Keys of the side that connects.
CurveKeys own_keys(const std::string& endpoint) {
  if (const auto keys = machine_keys()) return *keys;
  require(is_loopback(endpoint),
          "endpoint {}: this machine has no keys; run cosurge keys, and add the line that it prints to the "
          "file that --allow of the coupler names",
          endpoint);
  return new_curve_keys();
}

}  // namespace

Line::Line(std::shared_ptr<zmq::context_t> context)
    : context_(std::move(context)), socket_(*context_, zmq::socket_type::pair) {
  set_linger(0);
}

Line::~Line() {
  if (closed_) *closed_ = true;
  // A monitor left open would hang the end of the context.
  if (monitor_) zmq_socket_monitor(socket_.handle(), nullptr, 0);
}

std::unique_ptr<Line> Line::listen(const std::string& endpoint, std::size_t message_limit,
                                   const std::vector<AllowedMachine>& allowed) {
  check(endpoint);
  require(!is_tcp(endpoint) || is_loopback(endpoint) || !allowed.empty(),
          "cannot listen at {} without keys: other machines can reach it; run cosurge keys on the machine of "
          "the solver and give a file with the line that it prints, --allow FILE; or use "
          "tcp://127.0.0.1:PORT and a tunnel (docs/across_machines.md)",
          endpoint);
  // A door answers for all sockets of its context.
  const bool has_door = is_tcp(endpoint) && !allowed.empty();
  std::unique_ptr<Line> line(new Line(has_door ? std::make_shared<zmq::context_t>(1) : context_of_process()));
  line->accepts_ = true;
  if (has_door) {
    line->door_.emplace(*line->context_, allowed);
    line->socket_.set(zmq::sockopt::zap_domain, "cosurge");
  }
  if (is_tcp(endpoint)) {
    const CurveKeys keys = new_curve_keys();
    line->server_key_ = keys.open;
    line->socket_.set(zmq::sockopt::curve_server, true);
    line->socket_.set(zmq::sockopt::curve_secretkey, keys.secret);
    line->socket_.set(zmq::sockopt::handshake_ivl, handshake_time);
  }
  // Over TCP anybody may send; otherwise a message that is slightly too large still gets an error message.
  const std::size_t most = is_tcp(endpoint) ? message_limit : 4 * message_limit;
  line->socket_.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(most));
  line->socket_.set(zmq::sockopt::rcvhwm, waiting_messages);
  line->watch();
  try {
    line->socket_.bind(endpoint);
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("cannot listen at {}: {}", endpoint, error.what()));
  }
  line->endpoint_ = line->socket_.get(zmq::sockopt::last_endpoint);
  line->read_news();  // read the port's number before any peer connects
  return line;
}

std::unique_ptr<Line> Line::connect(const Connection& connection) {
  check(connection.endpoint);
  std::unique_ptr<Line> line(new Line(context_of_process()));
  line->endpoint_ = connection.endpoint;
  if (is_tcp(connection.endpoint)) {
    require(connection.server_key.size() == 40,
            "endpoint {}: tcp:// needs the coupler's public key of 40 characters; start the coupler with a "
            "tcp:// address and use its connection file",
            connection.endpoint);
    const CurveKeys keys = own_keys(connection.endpoint);
    line->socket_.set(zmq::sockopt::curve_serverkey, connection.server_key);
    line->socket_.set(zmq::sockopt::curve_publickey, keys.open);
    line->socket_.set(zmq::sockopt::curve_secretkey, keys.secret);
  }
  line->socket_.set(zmq::sockopt::connect_timeout, connect_time);
  line->watch();
  try {
    line->socket_.connect(connection.endpoint);
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("cannot connect to {}: {}", connection.endpoint, error.what()));
  }
  return line;
}

std::pair<std::unique_ptr<Line>, std::unique_ptr<Line>> Line::pair() {
  const auto context = std::make_shared<zmq::context_t>(0);
  std::unique_ptr<Line> first(new Line(context));
  std::unique_ptr<Line> second(new Line(context));
  first->closed_ = second->peer_closed_ = std::make_shared<std::atomic<bool>>(false);
  second->closed_ = first->peer_closed_ = std::make_shared<std::atomic<bool>>(false);
  first->endpoint_ = second->endpoint_ = "inproc://wire";
  first->socket_.bind(first->endpoint_);
  second->socket_.connect(second->endpoint_);
  return {std::move(first), std::move(second)};
}

void Line::watch() {
  socket_.set(zmq::sockopt::heartbeat_ivl, heartbeat_interval);
  socket_.set(zmq::sockopt::heartbeat_timeout, static_cast<int>(silence * 1000));
  static std::atomic<int> count = 0;
  const std::string endpoint = fmt::format("inproc://monitor-{}", ++count);
  if (zmq_socket_monitor(socket_.handle(), endpoint.c_str(), watched_events) != 0) throw zmq::error_t();
  monitor_ = zmq::socket_t(*context_, zmq::socket_type::pair);
  monitor_.set(zmq::sockopt::linger, 0);
  // Where its queue is full, ZeroMQ's thread stops, and with it all lines.
  monitor_.set(zmq::sockopt::rcvhwm, 0);
  monitor_.connect(endpoint);
}

bool Line::take(zmq::message_t& message) {
  read_news();
  while (zmq_msg_recv(message.handle(), socket_.handle(), ZMQ_DONTWAIT) < 0) {
    if (zmq_errno() == EAGAIN) return false;
    if (zmq_errno() != EINTR) throw zmq::error_t();
  }
  if (accepts_ && peer_descriptor_ < 0) {
    // A stranger may have left from the same descriptor just before.
    read_news();
    peer_descriptor_ = zmq_msg_get(message.handle(), ZMQ_SRCFD);
    if (!gate_.knows(peer_descriptor_)) loss_ = "the connection was lost: the peer has ended";
    gate_.shut(peer_descriptor_);
  }
  return true;
}

bool Line::put(zmq::message_t&& message) {
  read_news();
  while (zmq_msg_send(message.handle(), socket_.handle(), ZMQ_DONTWAIT) < 0) {
    if (zmq_errno() == EAGAIN) return false;
    if (zmq_errno() != EINTR) throw zmq::error_t();
  }
  return true;
}

void Line::turn_away_strangers() {
  read_news();
  if (door_) door_->answer();
  gate_.cut_off();
}

void Line::sleep(double seconds) {
  turn_away_strangers();
  if (gate_.has_strangers()) seconds = std::min(seconds, look_at_strangers);
  std::vector<zmq_pollitem_t> items = {{socket_.handle(), 0, ZMQ_POLLIN, 0}};
  if (monitor_) items.push_back({monitor_.handle(), 0, ZMQ_POLLIN, 0});
  if (door_) items.push_back({door_->handle(), 0, ZMQ_POLLIN, 0});
  const int count =
      zmq_poll(items.data(), static_cast<int>(items.size()), static_cast<long>(seconds * 1000) + 1);
  if (count < 0 && zmq_errno() != EINTR) throw zmq::error_t();
}

std::optional<std::string> Line::loss() {
  read_news();
  if (!loss_ && peer_closed_ && *peer_closed_) loss_ = "it has closed the connection";
  return loss_;
}

/// Also before every message, so that news of strangers do not pile up.
void Line::read_news() {
  if (!monitor_) return;
  zmq::message_t head;
  zmq::message_t address;
  while (monitor_.recv(head, zmq::recv_flags::dontwait) && monitor_.recv(address, zmq::recv_flags::none)) {
    std::uint16_t event = 0;
    std::int32_t value = 0;
    std::memcpy(&event, head.data(), sizeof event);
    std::memcpy(&value, head.data<char>() + sizeof event, sizeof value);
    note(event, value);
  }
}

void Line::note(int event, int value) {
  if (event == ZMQ_EVENT_LISTENING) {
    if (is_tcp(endpoint_)) gate_ = Gate(value);
  } else if (event == ZMQ_EVENT_ACCEPTED) {
    gate_.came(value);
  } else if (event == ZMQ_EVENT_HANDSHAKE_SUCCEEDED) {
    connected_ = !accepts_;
  } else if (event != ZMQ_EVENT_DISCONNECTED) {
    trouble_ =
        event == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH
            ? "the coupler does not allow the key of this machine: add the line that cosurge keys prints "
              "here to the file that --allow of the coupler names"
            : "a handshake failed: one side has no key, or the key of another run";
    if (!accepts_) loss_ = trouble_;
  } else {
    gate_.left(value);
    if (accepts_ ? value == peer_descriptor_ : connected_)
      loss_ = fmt::format("the connection was lost: the peer has ended, or has sent no heartbeat for {} s",
                          silence);
  }
}

void Line::set_linger(int milliseconds) { socket_.set(zmq::sockopt::linger, milliseconds); }

}  // namespace cosurge
