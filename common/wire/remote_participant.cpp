#include "common/wire/remote_participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "common/version.hpp"
#include "common/wire/convert.hpp"
#include "common/wire/parts.hpp"
#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

using Reply = v1::Reply;

constexpr std::size_t most_without_numbers = std::size_t{1} << 16;  // [bytes] of Hello and Done
constexpr std::size_t most_of_a_failure = 4000;                     // [bytes] of its words

template <typename List, typename Value>
bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

std::string result_name(Reply::ResultCase result) {
  const auto* field = Reply::descriptor()->FindFieldByNumber(result);
  return field == nullptr ? "no result" : field->name();
}

/// Why the solver that says this hello cannot take part; empty where it can.
std::string mismatch(const v1::Hello& hello, const Identity& identity,
                     const RemoteParticipant::Expectation& expected) {
  if (const Role role = role_of(hello); role != expected.role) {
    return fmt::format("it is a {} solver, a {} solver is expected", role_name(role),
                       role_name(expected.role));
  }
  if (hello.token() != expected.token) return "it has the token of another run";
  if (!contains(identity.dimensions, expected.dimension)) {
    return fmt::format("it does not support {} dimensions", expected.dimension);
  }
  for (const std::string& capability : expected.capabilities) {
    if (!contains(identity.capabilities, capability))
      return fmt::format("it does not support \"{}\"", capability);
  }
  return {};
}

}  // namespace

template <typename Call>
auto RemoteParticipant::call(std::string place, Call&& content) {
  require(!over_, "{}: {} was requested after its end", channel_.peer(), place);
  place_ = std::move(place);
  try {
    const auto start = std::chrono::steady_clock::now();
    auto result = content();
    ++cost_.calls;
    cost_.total += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  } catch (const Interrupted& interrupted) {
    abort(interrupted.what());
    throw;
  } catch (const std::exception& error) {
    // The solver that failed or is lost has been named already.
    if (over_) throw;
    const std::string text = fmt::format("{}: {} [{}]", channel_.peer(), error.what(), place_);
    abort(text);
    throw Error(text);
  }
}

RemoteParticipant::RemoteParticipant(Channel channel, const Expectation& expected,
                                     Channel::PeerEnded peer_ended)
    : channel_(std::move(channel)) {
  channel_.set_peer_ended(std::move(peer_ended));
  try {
    greet(expected);
  } catch (const PeerLost&) {
    throw;
  } catch (const Interrupted&) {
    refuse("the run was interrupted");
    throw;
  } catch (const std::exception& error) {
    refuse(error.what());
    throw Error(fmt::format("{}: refused: {}", channel_.peer(), error.what()));
  }
  call("welcome", [&] {
    v1::Welcome& welcome = *request_.mutable_welcome();
    welcome.set_protocol(protocol_version);
    welcome.set_program("cosurge");
    welcome.set_version(version);
    welcome.set_token(expected.token);
    exchange(Reply::kDone);
    return 0;
  });
}

RemoteParticipant::~RemoteParticipant() { abort("it ended before this solver was finalized"); }

void RemoteParticipant::greet(const Expectation& expected) {
  channel_.receive(reply_, "its hello", most_without_numbers);
  require(!reply_.has_failure(), "{}", printable(reply_.failure().what(), most_of_a_failure));
  require(reply_.has_hello() && reply_.sequence() == 0, "its first message is not a hello");
  const v1::Hello& hello = reply_.hello();
  channel_.set_peer(fmt::format("{} {}", hello.program(), hello.version()));
  // A program of another protocol can be trusted with nothing further.
  require(hello.protocol() == protocol_version, "it uses protocol {}, the coupler uses {}", hello.protocol(),
          protocol_version);
  identity_ = decode(hello);
  const std::string reason = mismatch(hello, identity_, expected);
  require(reason.empty(), "{}", reason);
}

void RemoteParticipant::refuse(const std::string& reason) {
  v1::Request request;
  request.mutable_refuse()->set_reason(reason);
  try {
    channel_.send_last(request);
  } catch (const PeerLost&) {
    // Nobody is there to be told; the reason counts.
  }
}

const Reply& RemoteParticipant::exchange(Reply::ResultCase expected) {
  request_.set_sequence(++sequence_);
  try {
    channel_.send(request_);
    channel_.receive(
        reply_, fmt::format("its answer to {}", place_),
        expected == Reply::kDone ? most_without_numbers : std::numeric_limits<std::size_t>::max());
  } catch (const PeerLost& lost) {
    abort(lost.what());
    throw;
  }
  if (reply_.has_failure()) {
    over_ = true;
    const std::string text =
        fmt::format("{}: {}", channel_.peer(), printable(reply_.failure().what(), most_of_a_failure));
    if (reply_.failure().numerical()) throw NumericalError(text);
    throw Error(text);
  }
  require(reply_.sequence() == sequence_, "its answer has number {} instead of {}", reply_.sequence(),
          sequence_);
  require(reply_.result_case() == expected, "it answers with {} instead of {}",
          result_name(reply_.result_case()), result_name(expected));
  require(reply_.seconds() >= 0 && std::isfinite(reply_.seconds()), "it says it computed for {} s",
          reply_.seconds());
  cost_.computing += reply_.seconds();
  return reply_;
}

template <typename Give, typename Take>
Setup RemoteParticipant::initialize_by(const v1::Case& the_case, const Give& give, const Take& take) {
  return call("initialize", [&] {
    v1::Initialize& initialize = *request_.mutable_initialize();
    *initialize.mutable_the_case() = the_case;
    give(initialize);
    const v1::Initialized& initialized = exchange(Reply::kInitialized).initialized();
    take(initialized);
    Setup setup = decode(initialized);
    columns_ = setup.columns.size();
    particles_ = setup.particles;
    return setup;
  });
}

template <typename Give, typename Take>
Report RemoteParticipant::advance_by(const Window& window, const Give& give, const Take& take) {
  return call(fmt::format("advance, window {} (t = {:.6g} s)", window.index, window.start), [&] {
    v1::Advance& advance = *request_.mutable_advance();
    encode(window, *advance.mutable_window());
    attempt_ = window.attempt == Attempt::again ? attempt_ + 1 : advance.window().attempt();
    advance.mutable_window()->set_attempt(attempt_);
    give(advance);
    const v1::Advanced& advanced = exchange(Reply::kAdvanced).advanced();
    take(advanced);
    return decode(advanced, columns_);
  });
}

Setup RemoteFluid::initialize(const v1::Case& the_case, Interface& interface, InterfaceLoad& load) {
  const int dimension = the_case.dimension();
  return initialize_by(
      the_case, [](v1::Initialize&) {},
      [&](const v1::Initialized& reply) {
        interface = decode(reply.interface(), dimension, the_case.solid().body_size());
        load = InterfaceLoad::zero(dimension, interface.points());
        decode(reply.load(), load);
      });
}

Report RemoteFluid::advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) {
  return advance_by(
      window, [&](v1::Advance& request) { encode(motion, *request.mutable_motion()); },
      [&](const v1::Advanced& reply) { decode(reply.load(), load); });
}

Setup RemoteSolid::initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                              InterfaceMotion& motion) {
  motion = InterfaceMotion::at_rest(the_case.dimension(), interface.points());
  return initialize_by(
      the_case,
      [&](v1::Initialize& request) {
        if (interface.points() == 0) return;
        encode(interface, *request.mutable_interface());
        encode(load, *request.mutable_load());
      },
      [&](const v1::Initialized& reply) { decode(reply.motion(), motion); });
}

Report RemoteSolid::advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) {
  return advance_by(
      window, [&](v1::Advance& request) { encode(load, *request.mutable_load()); },
      [&](const v1::Advanced& reply) { decode(reply.motion(), motion); });
}

std::string RemoteParticipant::save() {
  return call("save", [&] {
    std::string state;
    bool more = true;
    while (more) {
      request_.mutable_save();
      exchange(Reply::kSaved);
      v1::Saved& part = *reply_.mutable_saved();
      more = part.more();
      require_part({.what = "state", .bytes = part.state().size(), .before = state.size(), .more = more},
                   particles_);
      if (state.empty())
        state = std::move(*part.mutable_state());
      else
        state += part.state();
    }
    return state;
  });
}

void RemoteParticipant::restore(const std::string& state) {
  call("restore", [&] {
    StateParts parts(state);
    bool last = false;
    while (!last) {
      last = parts.next(*request_.mutable_restore());
      exchange(Reply::kDone);
    }
    return 0;
  });
}

Snapshot RemoteParticipant::frame() {
  return call("frame", [&] {
    Snapshot frame;
    std::size_t bytes = 0;
    bool more = true;
    while (more) {
      request_.mutable_frame();
      const v1::Snapshot& part = exchange(Reply::kSnapshot).snapshot();
      more = part.more();
      require_part({.what = "frame", .bytes = part.ByteSizeLong(), .before = bytes, .more = more},
                   particles_);
      bytes += part.ByteSizeLong();
      append(decode(part), frame);
      require_few_arrays(static_cast<int>(frame.size()));
    }
    return frame;
  });
}

void RemoteParticipant::finalize() {
  call("finalize", [&] {
    request_.mutable_finalize();
    return exchange(Reply::kDone).sequence();
  });
  over_ = true;
}

void RemoteParticipant::abort(const std::string& reason) noexcept {
  if (over_) return;
  over_ = true;
  try {
    v1::Request request;
    request.mutable_abort()->set_reason(reason);
    channel_.send_last(request);
  } catch (const std::exception&) {
    // A solver that cannot be told is gone.
  }
}

RemoteParticipant::Cost RemoteParticipant::cost() const {
  Cost cost = cost_;
  const Channel::Traffic& traffic = channel_.traffic();
  cost.messages = traffic.messages;
  cost.bytes = traffic.bytes_sent + traffic.bytes_received;
  cost.waiting = traffic.waiting;
  return cost;
}

}  // namespace cosurge
