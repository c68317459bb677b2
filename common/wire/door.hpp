// Asks those who connect over TCP for a public key that is allowed.
#pragma once

#include <string>
#include <vector>
#include <zmq.hpp>

#include "common/wire/keys.hpp"

namespace cosurge {

/// Answers ZeroMQ's questions whether a peer may connect (ZAP, RFC 27 of ZeroMQ), for all sockets of one
/// context: ZeroMQ's thread asks once a peer has proved that it has the secret key to its public key. A peer
/// waits for its answer; after the time of a handshake it is refused.
class Door {
 public:
  /// Must exist before a socket of the context is bound.
  Door(zmq::context_t& context, std::vector<AllowedMachine> allowed);

  /// Answers all questions that have been asked. Does not wait.
  void answer();

  void* handle() { return socket_.handle(); }  ///< readable when there is a question

  /// The last peer that was refused, in words; empty where none was.
  const std::string& refused() const { return refused_; }

 private:
  std::vector<AllowedMachine> allowed_;
  zmq::socket_t socket_;
  std::string refused_;
};

}  // namespace cosurge
