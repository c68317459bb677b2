// A solver with prepared answers, one of them changed; and the message of its coupler.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/wire/remote_participant.hpp"
#include "common/wire/serve.hpp"
#include "tests/support/requests.hpp"

namespace cosurge::testing {

/// The answers of a run, in their order.
enum class Phase { hello, welcome, initialize, advance, save, frame, restore, finalize };

constexpr std::size_t phases = 8;

/// The request of a phase, for a solver of this role.
inline v1::Request request_of(Phase phase, Role role, const std::string& token) {
  const Piston piston;
  v1::Request request;
  if (phase == Phase::welcome) request = welcome_request(token);
  if (phase == Phase::initialize) request = initialize_request(2);
  if (phase == Phase::advance) request = advance_request(3, InterfaceMotion::at_rest(2, piston.points));
  if (phase == Phase::save) request.mutable_save();
  if (phase == Phase::frame) request.mutable_frame();
  if (phase == Phase::restore)
    request.mutable_restore()->set_state(std::string((role == Role::fluid ? 1 : 3) * sizeof(double), '\0'));
  if (phase == Phase::finalize) request.mutable_finalize();
  if (role == Role::solid) {
    const InterfaceLoad load = InterfaceLoad::zero(2, piston.points);
    if (phase == Phase::initialize) {
      Interface interface {
        .dimension = 2, .position = Field::Zero(2, piston.points), .area = Field::Zero(2, piston.points),
        .body = std::vector<int>(static_cast<std::size_t>(piston.points), 0)
      };
      encode(interface, *request.mutable_initialize()->mutable_interface());
      encode(load, *request.mutable_initialize()->mutable_load());
    }
    if (phase == Phase::advance) encode(load, *request.mutable_advance()->mutable_load());
  }
  request.set_sequence(static_cast<std::uint64_t>(phase));
  return request;
}

/// The answers of a correct solver.
inline std::vector<v1::Reply> right_answers(Role role, const std::string& token) {
  const Piston piston;
  const auto fluid = water_column(piston);
  const auto solid = sprung_piston(piston);
  Participant& participant =
      role == Role::fluid ? static_cast<Participant&>(*fluid) : static_cast<Participant&>(*solid);
  Service service(participant, token);
  std::vector<v1::Reply> answers = {service.hello()};
  for (std::size_t phase = 1; phase < phases; ++phase)
    answers.push_back(service.answer(request_of(static_cast<Phase>(phase), role, token)));
  return answers;
}

/// All calls of a coupler to a solver that sends these bytes. The message of the error; empty if there is
/// none.
inline std::string error_of_coupler(Role role, const std::string& token,
                                    const std::vector<std::string>& answers) {
  const Piston piston;
  auto [coupler, solver] =
      Channel::pair({.peer = role == Role::fluid ? "the fluid solver" : "the solid solver",
                     .patience = 5,
                     .message_limit = 1000000},
                    {.peer = "the coupler"});
  for (const std::string& bytes : answers) solver.send_bytes(bytes);
  const RemoteParticipant::Expectation expected{
      .role = role, .token = token, .dimension = 2, .capabilities = {"save", "frame"}};
  Interface interface {
    .dimension = 2, .position = Field::Zero(2, piston.points), .area = Field::Zero(2, piston.points),
    .body = std::vector<int>(static_cast<std::size_t>(piston.points), 0)
  };
  InterfaceLoad load = InterfaceLoad::zero(2, piston.points);
  InterfaceMotion motion = InterfaceMotion::at_rest(2, piston.points);
  const Window window{.index = 0, .start = 0, .size = 1e-4};
  const auto run = [&](auto& participant) {
    std::string state = participant.save();
    participant.frame();
    participant.restore(state);
    participant.finalize();
  };
  try {
    if (role == Role::fluid) {
      RemoteFluid fluid(std::move(coupler), expected);
      fluid.initialize(piston_case(), interface, load);
      fluid.advance(window, motion, load);
      run(fluid);
    } else {
      RemoteSolid solid(std::move(coupler), expected);
      solid.initialize(piston_case(), interface, load, motion);
      solid.advance(window, load, motion);
      run(solid);
    }
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// The same for a correct solver with one changed answer.
inline std::string error_of_coupler(Role role, Phase phase, const std::function<void(v1::Reply&)>& spoil) {
  const std::string token = "token of the run";
  std::vector<v1::Reply> answers = right_answers(role, token);
  spoil(answers[static_cast<std::size_t>(phase)]);
  std::vector<std::string> bytes;
  for (const v1::Reply& answer : answers) bytes.push_back(answer.SerializeAsString());
  return error_of_coupler(role, token, bytes);
}

}  // namespace cosurge::testing
