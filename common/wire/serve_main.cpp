#include "common/wire/serve_main.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstring>
#include <iostream>

#include "common/threads.hpp"
#include "common/wire/serve.hpp"
#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

constexpr int exit_error = 1;
constexpr int exit_usage = 2;
constexpr int exit_numerical = 3;

struct Options {
  std::string connection;
  std::string endpoint;
  int threads = 0;
  double patience = 3600;
};

/// The system sends SIGTERM when the coupler that started this program dies.
void end_in_words(int) {
  constexpr const char* words = "stopped by SIGTERM: the coupler has ended, or has stopped this solver\n";
  const auto written = ::write(STDERR_FILENO, words, std::strlen(words));
  _exit(written < 0 ? exit_error + 1 : exit_error);
}

void run(Participant& participant, const Options& options) {
  const Identity identity = participant.identity();
  Connection connection = read_connection(options.connection);
  const Role role = participant.role();
  require(connection.role == role, "{} is for a {} solver, {} is a {} solver", options.connection,
          role_name(connection.role), identity.program, role_name(role));
  if (!options.endpoint.empty()) connection.endpoint = options.endpoint;
  set_threads(options.threads);
  Channel channel = Channel::connect(
      connection, {.peer = "the coupler at " + connection.endpoint, .patience = options.patience});
  serve(participant, channel, connection.token);
}

}  // namespace

int serve_main(int argc, char** argv, const std::function<std::unique_ptr<Participant>()>& make) {
  ensure_passive_waiting(argv);
  std::signal(SIGTERM, end_in_words);
  std::string name = "solver";
  try {
    const std::unique_ptr<Participant> participant = make();
    const Identity identity = participant->identity();
    name = identity.program;
    CLI::App app(fmt::format("The {} solver of a Cosurge run. The coupler starts it. To start it by hand, "
                             "also on another machine, use the command that the coupler prints.",
                             role_name(participant->role())),
                 name);
    Options options;
    app.set_version_flag("--version", name + " " + identity.version);
    app.add_option("--connect", options.connection, "Connection file written by the coupler")->required();
    app.add_option("--endpoint", options.endpoint,
                   "Address of the coupler, if it differs from the one in the file (tcp://host:port)");
    app.add_option("--threads", options.threads, "Number of threads; 0 leaves it to OpenMP")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--patience", options.patience, "Longest wait for the coupler's next request [s]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? 0 : exit_usage;
    }
    run(*participant, options);
    return 0;
  } catch (const NumericalError& error) {
    std::cerr << name << ": " << printable(error.what()) << '\n';
    return exit_numerical;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << printable(error.what()) << '\n';
    return exit_error;
  }
}

}  // namespace cosurge
