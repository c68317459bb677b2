// Limits the connections to a TCP port on which one solver is awaited.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <set>

namespace cosurge {

/// Lets few connections wait for their handshake at a time, and none but the peer's stay once the gate is
/// shut. A connection that comes to a closed gate gets no answer from the system; it succeeds by one of its
/// repetitions where the gate opens again. The gate closes when its owner has told it of the connections:
/// more may come until then. Whoever sends much more than a handshake without having shown the key is cut
/// off: ZeroMQ would keep as much as a message may have.
class Gate {
 public:
  /// Connections at a time: a quarter of the files that this process may open, 256 at most.
  static std::size_t most();

  Gate() = default;  ///< for a line that has no port: without effect

  /// `descriptor`: the listening socket.
  explicit Gate(int descriptor) : descriptor_(descriptor) {}

  /// Descriptors of connections.
  void came(int connection);
  void left(int connection);

  /// Whether any connection is so young that it may not have shown its key.
  bool has_strangers();

  /// Ends the connections of strangers that have sent too much. All news of connections must have been told.
  void cut_off();

  bool knows(int connection) const { return connections_.contains(connection); }

  /// For good: only `peer`, which has shown its key, stays. All others are closed, so that their descriptors
  /// are free for the run.
  void shut(int peer);

 private:
  using Clock = std::chrono::steady_clock;

  void end(int connection) const;
  void update();

  int descriptor_ = -1;
  std::set<int> connections_;
  std::map<int, Clock::time_point> strangers_;  // start of connections without a finished handshake
  bool shut_ = false;
  bool closed_ = false;
};

}  // namespace cosurge
