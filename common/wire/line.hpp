// The ZeroMQ socket under a channel, and its monitor of the other side.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <zmq.hpp>

#include "common/wire/connection.hpp"
#include "common/wire/door.hpp"
#include "common/wire/gate.hpp"

namespace cosurge {

/// A PAIR socket with heartbeats. A dead peer's connection closes at once; a frozen peer's, or one behind a
/// broken network, is closed when `silence` has passed without a sign of life. The answers come from ZeroMQ's
/// own thread, so that a peer which computes for hours stays alive.
class Line {
 public:
  /// Longer than any delay of a thread on an overloaded machine, and than the passage of one message.
  static constexpr double silence = 3;  // [s]

  /// Over TCP, a peer that sends a message of more than `message_limit` bytes is cut off before the message
  /// is read, and one that has not shown its key after some seconds; nobody else can connect once the first
  /// message was taken. `allowed`: machines that may connect over TCP; empty: any with the key of the server,
  /// which only an address within this machine may have. @throws Error
  static std::unique_ptr<Line> listen(const std::string& endpoint, std::size_t message_limit,
                                      const std::vector<AllowedMachine>& allowed = {});

  /// Over TCP, with the keys of this machine. @throws Error where it has none, unless the address is within
  /// this machine.
  static std::unique_ptr<Line> connect(const Connection& connection);
  static std::pair<std::unique_ptr<Line>, std::unique_ptr<Line>> pair();

  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line();

  const std::string& endpoint() const { return endpoint_; }
  const std::string& server_key() const { return server_key_; }

  /// Neither waits; false where there is no message, or nobody to take one.
  bool take(zmq::message_t& message);
  bool put(zmq::message_t&& message);

  /// Sleeps until a message or news of the peer arrives, or the time is over.
  void sleep(double seconds);

  /// Over TCP, answers who may connect, and closes connections that send much without having shown their key.
  /// To be called often while a solver is awaited; sleep() does so for this line.
  void turn_away_strangers();

  /// How the connection was lost, once it was.
  std::optional<std::string> loss();

  /// Reason why peers could not connect so far; usually empty.
  const std::string& trouble() const {
    return door_ && !door_->refused().empty() ? door_->refused() : trouble_;
  }

  /// How long closing may wait for sent messages to be delivered.
  void set_linger(int milliseconds);

 private:
  explicit Line(std::shared_ptr<zmq::context_t> context);

  void watch();
  void read_news();
  void note(int event, int value);

  std::shared_ptr<zmq::context_t> context_;
  zmq::socket_t socket_;
  zmq::socket_t monitor_;  // monitor of socket_; unused within one process
  std::string endpoint_;
  std::string server_key_;
  bool accepts_ = false;    // listens, so that strangers may try to connect
  bool connected_ = false;  // as the one that connects
  int peer_descriptor_ = -1;
  Gate gate_;
  std::optional<Door> door_;  // of a port for certain machines only
  std::optional<std::string> loss_;
  std::string trouble_;

  // Sockets within one process have no connection that could break: each end tells the other that it closes.
  std::shared_ptr<std::atomic<bool>> closed_;
  std::shared_ptr<std::atomic<bool>> peer_closed_;
};

}  // namespace cosurge
