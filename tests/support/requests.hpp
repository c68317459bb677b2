// Messages of a legal run, for tests that feed one side of the protocol by hand.
#pragma once

#include <string>

#include "common/version.hpp"
#include "common/wire/convert.hpp"
#include "tests/support/mock_participant.hpp"

namespace cosurge::testing {

inline v1::Request welcome_request(const std::string& token) {
  v1::Request request;
  request.set_sequence(1);
  request.mutable_welcome()->set_protocol(protocol_version);
  request.mutable_welcome()->set_program("cosurge");
  request.mutable_welcome()->set_version("0.1.0");
  request.mutable_welcome()->set_token(token);
  return request;
}

inline v1::Request initialize_request(std::uint64_t sequence) {
  v1::Request request;
  request.set_sequence(sequence);
  *request.mutable_initialize()->mutable_the_case() = piston_case();
  return request;
}

inline v1::Request advance_request(std::uint64_t sequence, const InterfaceMotion& motion,
                                   std::uint64_t window = 0) {
  v1::Request request;
  request.set_sequence(sequence);
  const double size = 1e-4;
  encode(Window{.index = window, .start = static_cast<double>(window) * size, .size = size},
         *request.mutable_advance()->mutable_window());
  encode(motion, *request.mutable_advance()->mutable_motion());
  return request;
}

}  // namespace cosurge::testing
