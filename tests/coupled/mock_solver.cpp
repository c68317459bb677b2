// A solver program without physics that has a chosen fault at a chosen call.
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <thread>

#include "common/version.hpp"
#include "common/wire/serve.hpp"
#include "tests/support/mock_participant.hpp"

namespace cosurge {
namespace {

constexpr std::size_t oversize = 3000000;  // [bytes], beyond the limit that the tests set

struct Options {
  std::string connection;
  std::string fault;
  std::uint64_t at = 0;  // number of the request whose answer is wrong; 0: the hello
  int threads = 0;
};

/// Faults of the program itself, before it answers.
void go_wrong(const std::string& fault) {
  if (fault == "exit") _exit(7);
  if (fault == "kill") raise(SIGKILL);
  if (fault == "stop") raise(SIGSTOP);
  if (fault == "sleep") std::this_thread::sleep_for(std::chrono::seconds(4));
}

/// Faults of the answer.
void spoil(v1::Reply& reply, const std::string& fault) {
  if (fault == "wrong-version") reply.mutable_hello()->set_protocol(protocol_version + 1);
  if (fault == "wrong-role") reply.mutable_hello()->set_role(v1::SOLID);
  if (fault == "wrong-token") reply.mutable_hello()->set_token("none");
  if (fault == "wrong-length") reply.mutable_advanced()->mutable_load()->mutable_force()->RemoveLast();
  if (fault == "nan") {
    reply.mutable_advanced()->mutable_load()->set_force(3, std::numeric_limits<double>::quiet_NaN());
  }
  if (fault == "out-of-order") reply.mutable_saved();
  if (fault == "wrong-sequence") reply.set_sequence(reply.sequence() + 5);
  if (fault == "long-hello") reply.mutable_hello()->set_program(std::string(100000, 'x'));
  if (fault == "long-done") reply.mutable_failure()->set_what(std::string(100000, 'x'));
  if (fault == "many-notes")
    for (int k = 0; k < 200; ++k) reply.mutable_advanced()->add_notes("look");
  if (fault == "many-columns")
    for (int k = 0; k < 20000; ++k)
      reply.mutable_initialized()->add_columns()->set_name(fmt::format("c{}", k));
  if (fault == "column-name") reply.mutable_initialized()->add_columns()->set_name("../time");
  if (fault == "giant") reply.mutable_saved()->set_state(std::string(64 * oversize, 'x'));
  if (fault == "oversized") reply.mutable_saved()->set_state(std::string(oversize, 'x'));
}

void send(Channel& channel, v1::Reply reply, const Options& options, std::uint64_t number) {
  if (number != options.at) return channel.send_last(reply);
  go_wrong(options.fault);
  spoil(reply, options.fault);
  options.fault == "garbage" ? channel.send_bytes("\xde\xad\xbe\xef") : channel.send_last(reply);
}

void run(const Options& options) {
  const Connection connection = read_connection(options.connection);
  const auto fluid = testing::water_column({});
  Service service(*fluid, connection.token);
  Channel channel = Channel::connect(connection, {.peer = "the coupler", .patience = 60});
  send(channel, service.hello(), options, 0);
  v1::Request request;
  while (service.state() != Service::State::over) {
    channel.receive(request, "the next request");
    send(channel, service.answer(request), options, request.sequence());
  }
}

/// As run(), but by the real serve(), with a participant that fails in its first window.
void run_and_throw(const Options& options) {
  const Connection connection = read_connection(options.connection);
  const auto fluid = testing::water_column({});
  fluid->on_advance = [](const Window&, const InterfaceMotion&, InterfaceLoad&) -> Report {
    throw NumericalError("the mock has diverged");
  };
  Channel channel = Channel::connect(connection, {.peer = "the coupler", .patience = 60});
  serve(*fluid, channel, connection.token);
}

}  // namespace
}  // namespace cosurge

int main(int argc, char** argv) {
  cosurge::Options options;
  CLI::App app("A solver that goes wrong", "mock_solver");
  app.add_option("--connect", options.connection)->required();
  app.add_option("--threads", options.threads);
  app.add_option("--fault", options.fault);
  app.add_option("--at", options.at);
  CLI11_PARSE(app, argc, argv);
  try {
    options.fault == "throw" ? cosurge::run_and_throw(options) : cosurge::run(options);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "mock_solver: " << error.what() << '\n';
    return 1;
  }
}
