// Limits the connections to a TCP port on which one solver is awaited.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <set>

namespace cosurge {

/// Limits the number of connections that wait for their handshake, and keeps only the peer's connection once
/// the gate is shut. A connection to a closed gate gets no answer from the system; a later attempt of it
/// succeeds if the gate is open again. The gate closes when its owner has reported the connections, so that
/// more may come until then. Connections that send much more than a handshake without having shown the key
/// are closed, because ZeroMQ would store up to the size limit of a message for each.
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
