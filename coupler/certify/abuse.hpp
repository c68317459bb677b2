// A coupler that violates the protocol, to test a solver.
#pragma once

#include <string>

#include "common/wire/channel.hpp"
#include "coupler/certify/scene.hpp"
#include "coupler/launcher.hpp"
#include "coupler/run_folder.hpp"
#include "coupler/solver_process.hpp"

namespace cosurge::certify {

/// One start of the program, to which any message can be sent.
class Abuse {
 public:
  explicit Abuse(const CertifyOptions& options);

  /// Sends a request with the next number, and receives the answer to it.
  const v1::Reply& ask(v1::Request request);

  void welcome();
  v1::Request initialize(const CertifyOptions& options) const;

  /// A window with the initial motion or load that the program has sent.
  v1::Request advance(const CertifyOptions& options) const;

  /// The forces or the velocities of a window's request.
  static google::protobuf::RepeatedField<double>& numbers_of(v1::Request& request);

  /// @param skip how many request numbers are skipped before this request
  void send(v1::Request request, int skip = 0);
  void send_bytes(const std::string& bytes) { channel_.send_bytes(bytes); }

  /// Requires that the program exits by itself within some seconds, with a Failure message if `says_so`.
  /// @throws Error where it does not
  void expect_failure(bool says_so);

 private:
  SolverProcess start(const CertifyOptions& options) const;

  RunFolder folder_;
  Channel channel_;
  std::string token_;
  SolverProcess process_;
  std::uint64_t sequence_ = 0;
  v1::Reply reply_;
};

}  // namespace cosurge::certify
