// What differs between the roles on the solver's side of the wire.
#pragma once

#include <memory>

#include "common/participant.hpp"
#include "proto/exchange.pb.h"

namespace cosurge {

/// Makes a call of a request, and the reply of what the call fills. The reply also says how long the call
/// took.
class Side {
 public:
  virtual ~Side() = default;

  /// @throws Error where the request does not fit the role, or a number in it is wrong; what the participant
  /// throws.
  virtual void initialize(const v1::Initialize& request, v1::Reply& reply) = 0;
  virtual void advance(const v1::Advance& request, v1::Reply& reply) = 0;
};

/// The side of a participant, which must outlive it.
std::unique_ptr<Side> side_of(Participant& participant);

}  // namespace cosurge
