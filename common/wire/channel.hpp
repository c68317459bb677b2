// One Protobuf message at a time, each way, between the coupler and one solver: a ZeroMQ PAIR socket that
// notices when the other side dies or freezes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/error.hpp"
#include "common/wire/connection.hpp"
#include "common/wire/keys.hpp"

namespace google::protobuf {
class Message;
class MessageLite;
}  // namespace google::protobuf
namespace zmq {
class message_t;
}

namespace cosurge {

class Line;

/// The other side died, froze, went away or kept silent for too long; the message says who, why, and what was
/// awaited.
class PeerLost : public Error {
 public:
  using Error::Error;
};

/// One end of the wire. It belongs to one thread at a time. Closing it never waits longer than two seconds.
class Channel {
 public:
  struct Options {
    std::string peer = "the other side";  ///< for error messages
    double patience = 600;                ///< longest wait for one message [s]
    /// [bytes]; a larger message would not pass between two heartbeats (line.hpp)
    std::size_t message_limit = std::size_t{1} << 28;
    std::vector<AllowedMachine> allowed = {};  ///< that may connect over TCP; empty: only from this machine
  };

  /// Messages and bytes so far.
  struct Traffic {
    std::uint64_t messages = 0;
    std::uint64_t bytes_sent = 0;
    std::uint64_t bytes_received = 0;
    double waiting = 0;  ///< [s] asleep in receive()
  };

  /// What happens to a message on its way, where a user wants to see the consequences.
  struct Mishap {
    double delay = 0;     ///< [s] that it arrives late
    bool damage = false;  ///< every bit is inverted
  };

  /// Says why the peer has ended, once it has; asked ten times a second while waiting.
  using PeerEnded = std::function<std::optional<std::string>()>;

  /// Says whether to wait no longer, since the user has ended the run; asked ten times a second while
  /// waiting.
  using Cancelled = std::function<bool()>;

  /// Binds "ipc:///path" (at most 107 characters of path) or "tcp://address:port" (port "*": any free one),
  /// the latter always with CURVE keys, made here, and for other machines only with options.allowed. @throws
  /// Error
  static Channel listen(const std::string& endpoint, Options options);

  /// Tries to reach the coupler as long as patience lasts. @throws Error, as for tcp without a key.
  static Channel connect(const Connection& connection, Options options);

  /// Two connected ends within this process.
  static std::pair<Channel, Channel> pair(Options first, Options second);

  Channel(Channel&& other) noexcept;
  ~Channel();

  const std::string& endpoint() const;    ///< as bound or connected
  const std::string& server_key() const;  ///< empty unless tcp
  const std::string& peer() const { return options_.peer; }
  const Traffic& traffic() const { return traffic_; }

  void set_peer(std::string name) { options_.peer = std::move(name); }
  void set_peer_ended(PeerEnded peer_ended) { peer_ended_ = std::move(peer_ended); }
  void set_cancelled(Cancelled cancelled) { cancelled_ = std::move(cancelled); }

  /// Of the next message that arrives.
  void set_mishap(const Mishap& mishap) { mishap_ = mishap; }

  /// Over TCP, closes connections that send much without having shown their key; receive() does so itself.
  void turn_away_strangers();

  /// Sends without waiting. @throws PeerLost; Error where the message exceeds the limit.
  void send(const google::protobuf::MessageLite& message);

  /// As send(), but closing the channel then waits up to two seconds for the message to be delivered.
  void send_last(const google::protobuf::MessageLite& message);

  /// Sends raw bytes, for tests of the receiver.
  void send_bytes(std::string_view bytes);

  /// Sleeps until the next message arrives. `awaited` names it in errors. `limit`: largest size [bytes], if
  /// it is smaller than the channel's.
  /// @throws PeerLost; Interrupted; Error where the message is too large or cannot be decoded.
  void receive(google::protobuf::Message& message, const std::string& awaited,
               std::size_t limit = std::numeric_limits<std::size_t>::max());

 private:
  Channel(std::unique_ptr<Line> line, Options options);

  zmq::message_t wait_for_message(const std::string& awaited);
  void suffer_mishap(zmq::message_t& message);
  std::optional<std::string> cause_of_end(zmq::message_t& last_message);
  void put(zmq::message_t&& bytes);

  std::unique_ptr<Line> line_;
  Options options_;
  PeerEnded peer_ended_;
  Cancelled cancelled_;
  Mishap mishap_;
  Traffic traffic_;
  bool lost_ = false;
};

}  // namespace cosurge
