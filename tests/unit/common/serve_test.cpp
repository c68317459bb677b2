#include "common/wire/serve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>

#include "tests/support/mock_participant.hpp"
#include "tests/support/requests.hpp"

namespace cosurge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using State = Service::State;

const std::string token = "token of the run";
const testing::Piston piston;

/// A request of any kind, right in itself.
v1::Request request_of(v1::Request::CallCase call, std::uint64_t sequence) {
  v1::Request request;
  switch (call) {
    case v1::Request::kWelcome:
      request = testing::welcome_request(token);
      break;
    case v1::Request::kInitialize:
      request = testing::initialize_request(sequence);
      break;
    case v1::Request::kAdvance:
      request = testing::advance_request(sequence, InterfaceMotion::at_rest(2, piston.points));
      break;
    case v1::Request::kSave:
      request.mutable_save();
      break;
    case v1::Request::kRestore:
      request.mutable_restore()->set_state(std::string(sizeof(double), '\0'));
      break;
    case v1::Request::kFrame:
      request.mutable_frame();
      break;
    case v1::Request::kFinalize:
      request.mutable_finalize();
      break;
    default:
      break;
  }
  request.set_sequence(sequence);
  return request;
}

class ServiceTest : public ::testing::Test {
 protected:
  v1::Reply ask(v1::Request::CallCase call) { return service.answer(request_of(call, ++sequence)); }

  /// Leads the service to a state.
  void bring_to(State state) {
    if (state >= State::welcomed) ask(v1::Request::kWelcome);
    if (state >= State::running) ask(v1::Request::kInitialize);
    if (state >= State::over) ask(v1::Request::kFinalize);
    ASSERT_EQ(service.state(), state);
  }

  std::unique_ptr<testing::MockFluid> fluid = testing::water_column(piston);
  Service service{*fluid, token};
  std::uint64_t sequence = 0;
};

/// The protocol as docs/protocol.md draws it, written down a second time.
std::set<v1::Request::CallCase> legal_calls(State state) {
  using R = v1::Request;
  switch (state) {
    case State::greeted:
      return {R::kWelcome};
    case State::welcomed:
      return {R::kInitialize, R::kFinalize};
    case State::running:
      return {R::kAdvance, R::kSave, R::kRestore, R::kFrame, R::kFinalize};
    default:
      return {};
  }
}

TEST(Protocol, AnswersEveryLegalCallAndRefusesEveryOther) {
  using R = v1::Request;
  for (const State state : {State::greeted, State::welcomed, State::running, State::over}) {
    for (const R::CallCase call : {R::CALL_NOT_SET, R::kWelcome, R::kInitialize, R::kAdvance, R::kSave,
                                   R::kRestore, R::kFrame, R::kFinalize}) {
      SCOPED_TRACE(fmt::format("state {}, call {}", static_cast<int>(state), static_cast<int>(call)));
      const auto fluid = testing::water_column(piston);
      Service service(*fluid, token);
      std::uint64_t sequence = 0;
      if (state >= State::welcomed) service.answer(request_of(R::kWelcome, ++sequence));
      if (state >= State::running) service.answer(request_of(R::kInitialize, ++sequence));
      if (state >= State::over) service.answer(request_of(R::kFinalize, ++sequence));
      ASSERT_EQ(service.state(), state);
      const R request = request_of(call, ++sequence);
      if (legal_calls(state).contains(call)) {
        EXPECT_EQ(service.answer(request).sequence(), sequence);
      } else {
        EXPECT_THAT([&] { service.answer(request); }, ThrowsMessage<Error>(HasSubstr("is out of order")));
        EXPECT_EQ(service.state(), State::over);
      }
    }
  }
}

TEST_F(ServiceTest, SaysHelloWithRoleVersionAndToken) {
  const v1::Hello hello = service.hello().hello();
  EXPECT_EQ(hello.role(), v1::FLUID);
  EXPECT_EQ(hello.protocol(), protocol_version);
  EXPECT_EQ(hello.program(), "mock_fluid");
  EXPECT_EQ(hello.token(), token);
}

TEST_F(ServiceTest, RefusesACouplerOfAnotherProtocolOrRunInWords) {
  v1::Request welcome = testing::welcome_request(token);
  welcome.mutable_welcome()->set_protocol(99);
  EXPECT_THAT([&] { service.answer(welcome); },
              ThrowsMessage<Error>(
                  HasSubstr("the coupler cosurge 0.1.0 uses protocol 99, this mock_fluid 0.1.0 uses 2")));
  Service other(*fluid, "another token");
  EXPECT_THAT([&] { other.answer(testing::welcome_request(token)); },
              ThrowsMessage<Error>(HasSubstr("has the token of another run")));
}

TEST_F(ServiceTest, RefusesARequestOutOfSequence) {
  bring_to(State::running);
  EXPECT_THAT([&] { service.answer(request_of(v1::Request::kSave, 7)); },
              ThrowsMessage<Error>(HasSubstr("request 7 came after request 2 [save]")));
}

TEST_F(ServiceTest, RefusesWrongInputAndNamesCallWindowFieldAndPoint) {
  bring_to(State::running);
  InterfaceMotion motion = InterfaceMotion::at_rest(2, piston.points);
  motion.velocity(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { service.answer(testing::advance_request(3, motion, 212)); },
              ThrowsMessage<Error>("velocity of point 3 is nan [advance, window 212 (t = 0.0212 s)]"));
}

TEST_F(ServiceTest, RefusesASceneOfADimensionThatItCannotCompute) {
  fluid->who.dimensions = {3};
  Service only_3d(*fluid, token);
  only_3d.answer(testing::welcome_request(token));
  EXPECT_THAT([&] { only_3d.answer(testing::initialize_request(2)); },
              ThrowsMessage<Error>("mock_fluid does not support 2 dimensions [initialize]"));
}

TEST_F(ServiceTest, RefusesALoadForTheFluid) {
  bring_to(State::running);
  v1::Request request = request_of(v1::Request::kAdvance, 3);
  request.mutable_advance()->mutable_load();
  EXPECT_THAT([&] { service.answer(request); }, ThrowsMessage<Error>(HasSubstr("no motion for the fluid")));
}

TEST_F(ServiceTest, GoesThroughAWindowAgainFromItsStart) {
  bring_to(State::running);
  InterfaceMotion motion = InterfaceMotion::at_rest(2, piston.points);
  const auto pressure = [&](double velocity, std::uint32_t attempt) {
    motion.velocity.row(1).setConstant(velocity);
    v1::Request request = testing::advance_request(++sequence, motion, 7);
    request.mutable_advance()->mutable_window()->set_attempt(attempt);
    return service.answer(request).advanced().load().pressure(0);
  };
  const double first = pressure(0.1, 1);
  EXPECT_NE(pressure(0.2, 2), first);
  EXPECT_EQ(pressure(0.1, 3), first);
}

TEST_F(ServiceTest, RefusesAnotherAttemptAtAWindowWhoseStartIsNotRemembered) {
  const InterfaceMotion motion = InterfaceMotion::at_rest(2, piston.points);
  const auto attempt = [&](std::uint64_t window, std::uint32_t number) {
    v1::Request request = testing::advance_request(++sequence, motion, window);
    request.mutable_advance()->mutable_window()->set_attempt(number);
    return [&, request] { service.answer(request); };
  };
  bring_to(State::running);
  attempt(5, 1)();
  attempt(5, 2)();
  EXPECT_THAT(attempt(6, 3),
              ThrowsMessage<Error>(HasSubstr("attempt 3 is at another window than attempt 2 before it")));
}

TEST_F(ServiceTest, RefusesASecondAttemptWithoutAFirst) {
  bring_to(State::running);
  v1::Request request = testing::advance_request(3, InterfaceMotion::at_rest(2, piston.points));
  request.mutable_advance()->mutable_window()->set_attempt(2);
  EXPECT_THAT([&] { service.answer(request); }, ThrowsMessage<Error>(HasSubstr("attempt 2")));
}

TEST_F(ServiceTest, PassesOnWhatTheParticipantThrowsWithItsPlaceAndKind) {
  bring_to(State::running);
  fluid->on_advance = [](const Window&, const InterfaceMotion&, InterfaceLoad&) -> Report {
    throw NumericalError("the pressure diverges");
  };
  EXPECT_THAT([&] { ask(v1::Request::kAdvance); },
              ThrowsMessage<NumericalError>("the pressure diverges [advance, window 0 (t = 0 s)]"));
}

TEST_F(ServiceTest, IsDismissedByRefusalAndAbortInAnyState) {
  v1::Request refuse;
  refuse.mutable_refuse()->set_reason("wrong role");
  EXPECT_THAT([&] { service.answer(refuse); },
              ThrowsMessage<Dismissed>(HasSubstr("refused this solver: wrong role")));
  v1::Request abort;
  abort.mutable_abort()->set_reason("the other one failed");
  for (const State state : {State::greeted, State::welcomed, State::running}) {
    Service fresh(*fluid, token);
    if (state >= State::welcomed) fresh.answer(request_of(v1::Request::kWelcome, 1));
    if (state >= State::running) fresh.answer(request_of(v1::Request::kInitialize, 2));
    EXPECT_THAT([&] { fresh.answer(abort); },
                ThrowsMessage<Dismissed>(HasSubstr("ended the run: the other one failed")));
    EXPECT_EQ(fresh.state(), State::over);
  }
}

TEST_F(ServiceTest, SavesAndRestoresTheState) {
  bring_to(State::running);
  fluid->state[0] = 0.25;
  v1::Request restore = request_of(v1::Request::kRestore, 4);
  restore.mutable_restore()->set_state(ask(v1::Request::kSave).saved().state());
  fluid->state[0] = 0;
  service.answer(restore);
  EXPECT_EQ(fluid->state[0], 0.25);
}

auto serving(Participant& fluid, Channel& channel) {
  return [&fluid, &channel] { serve(fluid, channel, token); };
}

TEST(Serve, TellsTheCouplerWhatItThrows) {
  const auto fluid = testing::water_column(piston);
  fluid->on_initialize = [](const v1::Case&, Interface&, InterfaceLoad&) -> cosurge::Setup {
    throw NumericalError("no lattice fits");
  };
  auto [coupler, solver] =
      Channel::pair({.peer = "fluid", .patience = 5}, {.peer = "the coupler", .patience = 5});
  coupler.send(testing::welcome_request(token));
  coupler.send(testing::initialize_request(2));
  EXPECT_THROW(serve(*fluid, solver, token), NumericalError);
  v1::Reply reply;
  coupler.receive(reply, "hello");
  coupler.receive(reply, "done");
  EXPECT_TRUE(reply.has_done());
  coupler.receive(reply, "failure");
  EXPECT_EQ(reply.failure().what(), "no lattice fits [initialize]");
  EXPECT_TRUE(reply.failure().numerical());
}

TEST(Serve, RefusesBytesThatAreNoRequest) {
  const auto fluid = testing::water_column(piston);
  auto [coupler, solver] =
      Channel::pair({.peer = "fluid", .patience = 5}, {.peer = "the coupler", .patience = 5});
  coupler.send_bytes("\x0f\xff");
  EXPECT_THAT(serving(*fluid, solver), ThrowsMessage<Error>(HasSubstr("2 bytes cannot be decoded")));
  v1::Reply reply;
  coupler.receive(reply, "hello");
  coupler.receive(reply, "failure");
  EXPECT_THAT(reply.failure().what(), HasSubstr("cannot be decoded"));
}

TEST(Serve, EndsWhenTheCouplerGoes) {
  const auto fluid = testing::water_column(piston);
  auto [coupler, solver] = Channel::pair({.peer = "fluid"}, {.peer = "the coupler", .patience = 60});
  { const Channel goes = std::move(coupler); }
  EXPECT_THAT(serving(*fluid, solver), ThrowsMessage<PeerLost>(HasSubstr("the coupler: ")));
}

}  // namespace
}  // namespace cosurge
