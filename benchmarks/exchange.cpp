// Cost of the exchange of a window, compared with a bare ping-pong of ZeroMQ with the same bytes: 1000
// points, a fluid and a structure without physics as two processes, over ipc and tcp. Both are measured in
// turns in one run.
//
// build/release/bin/exchange [POINTS] > docs/tables/exchange_window.csv
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <zmq.hpp>

#include "common/wire/keys.hpp"
#include "common/wire/serve_main.hpp"
#include "coupler/coupler.hpp"
#include "coupler/launcher.hpp"
#include "coupler/run_folder.hpp"
#include "tests/support/requests.hpp"

namespace cosurge {
namespace {

constexpr int rounds = 11, windows_a_round = 400;

using Clock = std::chrono::steady_clock;

double microseconds(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

testing::Piston piston_of(int points) {
  testing::Piston piston;
  piston.points = points;
  return piston;
}

// The coupled run

/// A fluid and a structure as processes, and the windows of their run.
class CoupledRun {
 public:
  CoupledRun(const RunFolder& folder, const std::string& listen, const std::string& points)
      : fluid_(start(Role::fluid, folder, listen, points)),
        solid_(start(Role::solid, folder, listen, points)) {
    v1::Case the_case = testing::piston_case();
    the_case.mutable_time()->set_end(1e9);
    the_case.mutable_output()->set_frame_interval(1e9);
    the_case.mutable_coupling()->set_scheme(v1::Coupling::weak);
    fluid_.join(2, {});
    solid_.join(2, {});
    coupler_.emplace(the_case, Participants{.fluid = dynamic_cast<Fluid*>(&fluid_.participant()),
                                            .solid = dynamic_cast<Solid*>(&solid_.participant())});
  }

  /// Runs some windows. Returns the exchange of one [us].
  double windows(int count) {
    const double before = exchange();
    int left = count;
    coupler_->run({}, [&] { return --left < 0; });
    return 1e6 * (exchange() - before) / count;
  }

 private:
  static Solver start(Role role, const RunFolder& folder, const std::string& listen,
                      const std::string& points) {
    const Wiring wiring{.folder = folder.path(), .listen = listen};
    const Command command{
        .program = "/proc/self/exe", .arguments = {role_name(role), points}, .log = folder.path() / "log"};
    return Solver::process(role, wiring, command, 1);
  }

  double exchange() const {
    return fluid_.participant().cost().exchange() + solid_.participant().cost().exchange();
  }

  Solver fluid_, solid_;
  std::optional<Coupler> coupler_;
};

/// The process of a fluid or a structure: cosurge's own loop around a participant that computes in no time.
int solver_main(int argc, char** argv) {
  const bool fluid = std::strcmp(argv[1], "fluid") == 0;
  const testing::Piston piston = piston_of(std::stoi(argv[2]));
  argv[2] = argv[0];
  return serve_main(argc - 2, argv + 2, [&]() -> std::unique_ptr<Participant> {
    if (fluid) return testing::water_column(piston);
    return testing::sprung_piston(piston);
  });
}

// The bare ping-pong

/// Bytes of the four messages of a window.
struct Sizes {
  std::size_t motion_request, load_reply, load_request, motion_reply;
};

Sizes sizes_of(int points) {
  const InterfaceMotion motion = InterfaceMotion::at_rest(2, points);
  const InterfaceLoad load = InterfaceLoad::zero(2, points);
  v1::Request to_fluid = testing::advance_request(1, motion), to_solid = to_fluid;
  encode(load, *to_solid.mutable_advance()->mutable_load());
  v1::Reply of_fluid, of_solid;
  for (v1::Reply* reply : {&of_fluid, &of_solid}) {
    reply->set_sequence(1);
    reply->set_seconds(1e-6);
    reply->mutable_advanced()->add_values(1);
    reply->mutable_advanced()->set_window(1);
  }
  encode(load, *of_fluid.mutable_advanced()->mutable_load());
  encode(motion, *of_solid.mutable_advanced()->mutable_motion());
  return {to_fluid.ByteSizeLong(), of_fluid.ByteSizeLong(), to_solid.ByteSizeLong(), of_solid.ByteSizeLong()};
}

/// Two processes that answer every message with some bytes; the keys of CURVE are optional.
class PingPong {
 public:
  PingPong(const RunFolder& folder, const std::string& transport, bool curve, const Sizes& sizes)
      : sizes_(sizes) {
    const std::string name = fmt::format("{}{}", transport, curve ? "-curve" : "");
    open(first_, folder, transport, name + "-a", curve, sizes.load_reply);
    open(second_, folder, transport, name + "-b", curve, sizes.motion_reply);
  }

  /// The time of one window [us].
  double windows(int count) {
    const auto start = Clock::now();
    for (int k = 0; k < count; ++k) {
      pass(first_, sizes_.motion_request);
      pass(second_, sizes_.load_request);
    }
    return microseconds(start) / count;
  }

 private:
  void open(zmq::socket_t& socket, const RunFolder& folder, const std::string& transport,
            const std::string& name, bool curve, std::size_t reply) {
    socket = zmq::socket_t(context_, zmq::socket_type::pair);
    socket.set(zmq::sockopt::linger, 0);
    const CurveKeys keys = new_curve_keys();
    if (curve) {
      socket.set(zmq::sockopt::curve_server, true);
      socket.set(zmq::sockopt::curve_secretkey, keys.secret);
    }
    socket.bind(transport == "ipc" ? "ipc://" + (folder.path() / name).string() : "tcp://127.0.0.1:*");
    const std::string endpoint = socket.get(zmq::sockopt::last_endpoint);
    processes_.push_back(std::make_unique<SolverProcess>(
        Command{.program = "/proc/self/exe",
                .arguments = {"echo", endpoint, std::to_string(reply), curve ? keys.open : ""},
                .log = folder.path() / "log"}));
    pass(socket, 1);
  }

  static void pass(zmq::socket_t& socket, std::size_t size) {
    zmq::message_t message(size);
    std::memset(message.data(), 1, size);
    socket.send(message, zmq::send_flags::none);
    (void)socket.recv(message);
  }

  Sizes sizes_;
  zmq::context_t context_{1};
  zmq::socket_t first_, second_;
  std::vector<std::unique_ptr<SolverProcess>> processes_;  // ended first
};

int echo_main(char** argv) {
  zmq::context_t context(1);
  zmq::socket_t socket(context, zmq::socket_type::pair);
  if (const std::string server = argv[4]; !server.empty()) {
    const CurveKeys keys = new_curve_keys();
    socket.set(zmq::sockopt::curve_serverkey, server);
    socket.set(zmq::sockopt::curve_publickey, keys.open);
    socket.set(zmq::sockopt::curve_secretkey, keys.secret);
  }
  socket.connect(argv[2]);
  const std::size_t size = std::stoul(argv[3]);
  for (zmq::message_t message; socket.recv(message);) {
    message.rebuild(size);
    std::memset(message.data(), 2, size);
    socket.send(message, zmq::send_flags::none);
  }
  return 0;
}

// Both

void measure(const RunFolder& folder, const std::string& transport, bool curve, int points) {
  const Sizes sizes = sizes_of(points);
  CoupledRun run(folder, transport == "ipc" ? "" : "tcp://127.0.0.1:*", std::to_string(points));
  PingPong bare(folder, transport, curve, sizes);
  std::vector<double> coupled, ping_pong;
  run.windows(windows_a_round);
  bare.windows(windows_a_round);
  for (int round = 0; round < rounds; ++round) {
    coupled.push_back(run.windows(windows_a_round));
    ping_pong.push_back(bare.windows(windows_a_round));
  }
  const std::size_t bytes = sizes.motion_request + sizes.load_reply + sizes.load_request + sizes.motion_reply;
  fmt::print("{}{},{},{},{:.1f},{:.1f},{:.2f}\n", transport, curve ? " with CURVE" : "", points, bytes,
             median(coupled), median(ping_pong), median(coupled) / median(ping_pong));
}

}  // namespace
}  // namespace cosurge

int main(int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "1000";
  if (word == "fluid" || word == "solid") return cosurge::solver_main(argc, argv);
  if (word == "echo") return cosurge::echo_main(argv);
  const int points = std::stoi(word);
  const cosurge::RunFolder folder;
  fmt::print("# build/release/bin/exchange {} > docs/tables/exchange_window.csv\n", points);
  fmt::print("transport,points,bytes_a_window,exchange_us,ping_pong_us,ratio\n");
  cosurge::measure(folder, "ipc", false, points);
  cosurge::measure(folder, "tcp", true, points);
}
