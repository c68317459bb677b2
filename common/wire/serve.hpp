// The solver's side of the protocol (docs/protocol.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "common/participant.hpp"
#include "common/wire/channel.hpp"
#include "common/wire/parts.hpp"
#include "common/wire/side.hpp"
#include "proto/exchange.pb.h"

namespace cosurge {

/// The coupler has refused this solver or ended the run; it waits for no answer.
class Dismissed : public Error {
 public:
  using Error::Error;
};

/// Answers requests on behalf of a participant, in the order that the protocol allows. Knows no wire.
class Service {
 public:
  enum class State { greeted, welcomed, running, over };

  /// `part`: largest part of a state or frame [bytes].
  Service(Participant& participant, std::string token, std::size_t part = part_bytes);

  v1::Reply hello() const;

  /// @throws Dismissed after Refuse and Abort; Error for a request that is out of order, or wrong in itself;
  /// otherwise what the participant throws. Errors say in which call and window. The service is over then.
  v1::Reply answer(const v1::Request& request);

  State state() const { return state_; }

 private:
  void dispatch(const v1::Request& request, v1::Reply& reply);
  void welcome(const v1::Welcome& request) const;
  void initialize(const v1::Initialize& request, v1::Reply& reply);
  void advance(const v1::Advance& request, v1::Reply& reply);
  void check_attempt(const v1::Window& window);
  void save(v1::Reply& reply);
  void frame(v1::Reply& reply);
  void restore(const v1::Restore& request);

  Participant& participant_;
  std::unique_ptr<Side> side_;
  Identity identity_;
  std::string token_;
  State state_ = State::greeted;
  std::uint64_t sequence_ = 0;
  std::size_t part_;
  std::optional<StateParts> state_parts_;  // the state that is being sent
  std::optional<FrameParts> frame_parts_;  // the frame that is being sent
  std::string arriving_;                   // the parts received so far of a state to restore
  v1::Window remembered_;                  // that may be gone through again; attempt 0: none
};

/// Serves one run: sends Hello and answers until the run is finalized. Errors are reported to the coupler,
/// where there still is one, and thrown.
void serve(Participant& participant, Channel& channel, const std::string& token);

}  // namespace cosurge
