#include "common/wire/channel.hpp"

#include <google/protobuf/message.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "common/wire/line.hpp"
#include "common/wire/message_parts.hpp"

namespace cosurge {
namespace {

constexpr double look_around = 0.1;  // [s] between checks whether the peer has ended
constexpr double last_words = 1;     // [s] wait for a lost peer's last message and the cause of its end
constexpr int farewell = 2000;       // [ms] to deliver a last message

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Channel::Channel(std::unique_ptr<Line> line, Options options)
    : line_(std::move(line)), options_(std::move(options)) {}

Channel::Channel(Channel&& other) noexcept = default;

Channel::~Channel() = default;

Channel Channel::listen(const std::string& endpoint, Options options) {
  auto line = Line::listen(endpoint, options.message_limit, options.allowed);
  return {std::move(line), std::move(options)};
}

Channel Channel::connect(const Connection& connection, Options options) {
  return {Line::connect(connection), std::move(options)};
}

std::pair<Channel, Channel> Channel::pair(Options first, Options second) {
  auto lines = Line::pair();
  return {Channel(std::move(lines.first), std::move(first)),
          Channel(std::move(lines.second), std::move(second))};
}

const std::string& Channel::endpoint() const { return line_->endpoint(); }

const std::string& Channel::server_key() const { return line_->server_key(); }

void Channel::turn_away_strangers() { line_->turn_away_strangers(); }

void Channel::send(const google::protobuf::MessageLite& message) {
  const std::size_t size = message.ByteSizeLong();
  require(size <= options_.message_limit, "a message of {} bytes to {} exceeds the limit of {}", size, peer(),
          options_.message_limit);
  zmq::message_t bytes(size);
  // Serialised in debug builds too if a required field is missing: the receiver reports it.
  message.SerializePartialToArray(bytes.data(), static_cast<int>(size));
  put(std::move(bytes));
}

void Channel::send_last(const google::protobuf::MessageLite& message) {
  line_->set_linger(farewell);
  send(message);
}

void Channel::send_bytes(std::string_view bytes) { put(zmq::message_t(bytes.data(), bytes.size())); }

void Channel::put(zmq::message_t&& bytes) {
  const std::size_t size = bytes.size();
  // ZeroMQ may keep a message for a lost peer, and closing would wait for its delivery.
  if (lost_ || !line_->put(std::move(bytes))) {
    zmq::message_t unread;
    const auto cause = lost_ ? std::nullopt : cause_of_end(unread);
    throw PeerLost(
        fmt::format("{}: {}", peer(), cause.value_or("no peer is connected to receive a message")));
  }
  ++traffic_.messages;
  traffic_.bytes_sent += size;
}

void Channel::receive(google::protobuf::Message& message, const std::string& awaited, std::size_t limit) {
  zmq::message_t bytes;
  if (!line_->take(bytes)) bytes = wait_for_message(awaited);
  suffer_mishap(bytes);
  ++traffic_.messages;
  traffic_.bytes_received += bytes.size();
  limit = std::min(limit, options_.message_limit);
  require(bytes.size() <= limit, "a message of {} bytes exceeds the limit of {}", bytes.size(), limit);
  require_few_parts({bytes.data<char>(), bytes.size()}, *message.GetDescriptor());
  require(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())),
          "a message of {} bytes cannot be decoded: it is damaged, truncated or from another program",
          bytes.size());
}

zmq::message_t Channel::wait_for_message(const std::string& awaited) {
  constexpr double longest_count = 1;  // [s] a look lasts longer only while this process is suspended
  zmq::message_t bytes;
  double waited = 0;
  while (waited < options_.patience) {
    const Clock::time_point start = Clock::now();
    line_->sleep(std::min(look_around, options_.patience - waited));
    const bool arrived = line_->take(bytes);
    const double slept = std::min(seconds_since(start), longest_count);
    waited += slept;
    traffic_.waiting += slept;
    if (arrived) return bytes;
    if (cancelled_ && cancelled_())
      throw Interrupted(
          fmt::format("stopped waiting for {} ({} was awaited for {:.1f} s)", peer(), awaited, waited));
    const auto cause = cause_of_end(bytes);
    if (bytes.size() > 0) return bytes;
    lost_ = cause.has_value();
    if (cause)
      throw PeerLost(fmt::format("{}: {} ({} was awaited for {:.1f} s)", peer(), *cause, awaited, waited));
  }
  const std::string& trouble = line_->trouble();
  throw PeerLost(
      fmt::format("{}: no message within {:.4g} s, the limit set by --patience; {} was awaited{}{}", peer(),
                  options_.patience, awaited, trouble.empty() ? "" : "; ", trouble));
}

void Channel::suffer_mishap(zmq::message_t& message) {
  const Mishap mishap = std::exchange(mishap_, {});
  const Clock::time_point start = Clock::now();
  while (seconds_since(start) < mishap.delay && !(cancelled_ && cancelled_()))
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  if (!mishap.damage) return;
  for (auto *byte = message.data<char>(), *end = byte + message.size(); byte != end; ++byte)
    *byte = static_cast<char>(~*byte);
}

std::optional<std::string> Channel::cause_of_end(zmq::message_t& last_message) {
  std::optional<std::string> loss = line_->loss();
  std::optional<std::string> ended = peer_ended_ ? peer_ended_() : std::nullopt;
  if (!loss && !ended) return std::nullopt;
  // The end of a process, the loss of its connection and its last message may show in any order.
  const Clock::time_point start = Clock::now();
  while (!line_->take(last_message)) {
    if (seconds_since(start) > last_words || (loss && (ended || !peer_ended_))) return ended ? ended : loss;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!loss) loss = line_->loss();
    if (!ended && peer_ended_) ended = peer_ended_();
  }
  return std::nullopt;
}

}  // namespace cosurge
