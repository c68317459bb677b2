// The computing time of a call, for the reply to it.
#pragma once

#include <chrono>

#include "proto/exchange.pb.h"

namespace cosurge {

/// The result of the call; the reply gets the seconds that it took.
template <typename Call>
auto timed(v1::Reply& reply, Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  auto result = call();
  reply.set_seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

}  // namespace cosurge
