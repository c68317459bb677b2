#include "common/wire/serve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/version.hpp"
#include "common/wire/convert.hpp"
#include "common/wire/timed_call.hpp"

namespace cosurge {
namespace {

using Request = v1::Request;
using State = Service::State;

struct Step {
  State from;
  Request::CallCase call;
  State to;
};

/// All that the protocol allows.
constexpr auto legal_steps = std::to_array<Step>({
    {State::greeted, Request::kWelcome, State::welcomed},
    {State::greeted, Request::kRefuse, State::over},
    {State::greeted, Request::kAbort, State::over},
    {State::welcomed, Request::kInitialize, State::running},
    {State::welcomed, Request::kFinalize, State::over},
    {State::welcomed, Request::kAbort, State::over},
    {State::running, Request::kAdvance, State::running},
    {State::running, Request::kSave, State::running},
    {State::running, Request::kRestore, State::running},
    {State::running, Request::kFrame, State::running},
    {State::running, Request::kFinalize, State::over},
    {State::running, Request::kAbort, State::over},
});

std::string call_name(const Request& request) {
  const auto* field = Request::descriptor()->FindFieldByNumber(request.call_case());
  return field == nullptr ? "no call" : field->name();
}

State next_state(State state, const Request& request) {
  for (const Step& step : legal_steps) {
    if (step.from == state && step.call == request.call_case()) return step.to;
  }
  constexpr std::array<const char*, 4> state_names = {"before the welcome", "before the initialization",
                                                      "in a running run", "in a run that is over"};
  throw Error(
      fmt::format("{} is out of order {}", call_name(request), state_names[static_cast<std::size_t>(state)]));
}

/// Where in a run a request stands, for errors.
std::string place(const Request& request) {
  if (!request.has_advance()) return call_name(request);
  const v1::Window& window = request.advance().window();
  return fmt::format("advance, window {} (t = {:.6g} s)", window.index(), window.start());
}

v1::Reply failure(const std::string& what, bool numerical) {
  v1::Reply reply;
  reply.mutable_failure()->set_what(what);
  reply.mutable_failure()->set_numerical(numerical);
  return reply;
}

}  // namespace

Service::Service(Participant& participant, std::string token, std::size_t part)
    : participant_(participant),
      side_(side_of(participant)),
      identity_(participant.identity()),
      token_(std::move(token)),
      part_(part) {}

v1::Reply Service::hello() const {
  v1::Reply reply;
  encode(participant_.role(), identity_, *reply.mutable_hello());
  reply.mutable_hello()->set_protocol(protocol_version);
  reply.mutable_hello()->set_token(token_);
  return reply;
}

v1::Reply Service::answer(const Request& request) {
  const State before = state_;
  state_ = State::over;  // unless all goes well
  if (request.has_refuse()) throw Dismissed("the coupler refused this solver: " + request.refuse().reason());
  if (request.has_abort()) throw Dismissed("the coupler ended the run: " + request.abort().reason());
  try {
    require(request.sequence() == sequence_ + 1, "request {} came after request {}", request.sequence(),
            sequence_);
    const State after = next_state(before, request);
    v1::Reply reply;
    reply.set_sequence(++sequence_);
    dispatch(request, reply);
    state_ = after;
    return reply;
  } catch (const NumericalError& error) {
    throw NumericalError(fmt::format("{} [{}]", error.what(), place(request)));
  } catch (const std::exception& error) {
    throw Error(fmt::format("{} [{}]", error.what(), place(request)));
  }
}

void Service::dispatch(const Request& request, v1::Reply& reply) {
  // Another call ends a state or a frame that is underway.
  if (!request.has_save()) state_parts_.reset();
  if (!request.has_frame()) frame_parts_.reset();
  if (!request.has_restore()) arriving_.clear();
  if (request.has_advance()) {
    advance(request.advance(), reply);
  } else if (request.has_save()) {
    save(reply);
  } else if (request.has_frame()) {
    frame(reply);
  } else if (request.has_initialize()) {
    initialize(request.initialize(), reply);
  } else {
    if (request.has_welcome()) welcome(request.welcome());
    if (request.has_restore()) restore(request.restore());
    remembered_.Clear();
    if (request.has_finalize()) participant_.finalize();
    reply.mutable_done();
  }
}

void Service::save(v1::Reply& reply) {
  if (!state_parts_) state_parts_.emplace(timed(reply, [&] { return participant_.save(); }), part_);
  if (state_parts_->next(*reply.mutable_saved())) state_parts_.reset();
}

void Service::frame(v1::Reply& reply) {
  if (!frame_parts_) frame_parts_.emplace(timed(reply, [&] { return participant_.frame(); }), part_);
  if (frame_parts_->next(*reply.mutable_snapshot())) frame_parts_.reset();
}

void Service::restore(const v1::Restore& request) {
  arriving_ += request.state();
  if (request.more()) return;
  participant_.restore(arriving_);
  arriving_.clear();
}

void Service::welcome(const v1::Welcome& request) const {
  require(request.protocol() == protocol_version, "the coupler {} {} uses protocol {}, this {} {} uses {}",
          request.program(), request.version(), request.protocol(), identity_.program, identity_.version,
          protocol_version);
  require(request.token() == token_, "the coupler {} {} has the token of another run", request.program(),
          request.version());
}

void Service::initialize(const v1::Initialize& request, v1::Reply& reply) {
  const int dimension = request.the_case().dimension();
  const auto& dimensions = identity_.dimensions;
  require(std::find(dimensions.begin(), dimensions.end(), dimension) != dimensions.end(),
          "{} does not support {} dimensions", identity_.program, dimension);
  side_->initialize(request, reply);
}

/// A window can be gone through again as long as no other has come between.
void Service::check_attempt(const v1::Window& window) {
  require(window.attempt() <= 1 ||
              (remembered_.attempt() == window.attempt() - 1 && remembered_.index() == window.index() &&
               remembered_.start() == window.start() && remembered_.size() == window.size()),
          "attempt {} is at another window than attempt {} before it", window.attempt(),
          window.attempt() - 1);
  remembered_ = window;
}

void Service::advance(const v1::Advance& request, v1::Reply& reply) {
  check_attempt(request.window());
  side_->advance(request, reply);
}

void serve(Participant& participant, Channel& channel, const std::string& token) {
  Service service(participant, token);
  channel.send(service.hello());
  Request request;
  try {
    while (service.state() != State::over) {
      channel.receive(request, fmt::format("request {}", request.sequence() + 1));
      const v1::Reply reply = service.answer(request);
      service.state() == State::over ? channel.send_last(reply) : channel.send(reply);
    }
  } catch (const PeerLost&) {
    throw;
  } catch (const Dismissed&) {
    throw;
  } catch (const NumericalError& error) {
    channel.send_last(failure(error.what(), true));
    throw;
  } catch (const std::exception& error) {
    channel.send_last(failure(error.what(), false));
    throw;
  }
}

}  // namespace cosurge
