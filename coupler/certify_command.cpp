#include "coupler/certify_command.hpp"

#include <cmath>
#include <limits>

#include "coupler/certify/abuse.hpp"
#include "coupler/interface_state.hpp"
#include "coupler/launcher.hpp"
#include "coupler/run_folder.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

using certify::Abuse;
using certify::points_of_plate;
using certify::scene_for;
using certify::size;
using certify::to_end;

constexpr double rounding = 1e-9;    // relative tolerance for values that may differ by rounding only
constexpr double linear = 1e-3;      // relative tolerance where the structure is linear: loads are small
constexpr double small_load = 1e-3;  // [N]

/// One start of the program, with the coupler's end of the connection as in a run.
struct Trial {
  explicit Trial(const CertifyOptions& options)
      : the_case(scene_for(options, folder.path())),
        solver(Solver::process(options.role,
                               {.folder = folder.path(), .listen = {}, .patience = options.patience},
                               {.program = options.command.front(),
                                .arguments = {options.command.begin() + 1, options.command.end()},
                                .log = folder.path() / "log"},
                               1)),
        participant(solver.join(2, {"save", "frame"})) {
    if (solid != nullptr) {
      points = points_of_plate(the_case);
      state.load = InterfaceLoad::zero(2, points.points());
      setup = solid->initialize(the_case, points, state.load, state.motion);
    } else {
      setup = fluid->initialize(the_case, points, state.load);
      state.motion = InterfaceMotion::at_rest(2, points.points());
    }
    rest = state;
  }

  /// Window `index`; where the program is a solid, with `load` times a fixed pattern of forces.
  InterfaceState advance(std::uint64_t index, double load, Attempt attempt = Attempt::once) {
    if (solid != nullptr)
      for (Eigen::Index k = 0; k < points.points(); ++k)
        state.load.force.col(k) << load * std::sin(1.0 + 0.3 * static_cast<double>(k)),
            load * 0.5 * std::cos(0.7 * static_cast<double>(k));
    Window window{.index = index, .start = static_cast<double>(index) * size, .size = size};
    window.attempt = attempt;
    report = solid != nullptr ? solid->advance(window, state.load, state.motion)
                              : fluid->advance(window, state.motion, state.load);
    return state;
  }

  RunFolder folder;
  v1::Case the_case;
  Solver solver;
  RemoteParticipant& participant;
  Fluid* fluid = dynamic_cast<Fluid*>(&participant);  // null for a solid
  Solid* solid = dynamic_cast<Solid*>(&participant);  // null for a fluid
  Interface points;
  InterfaceState state, rest;
  Setup setup;
  Report report;
};

/// Throws if two answers are not bit-identical, with the difference.
void expect_same(const InterfaceState& a, const InterfaceState& b, const std::string& what) {
  require(a.motion.displacement == b.motion.displacement && a.motion.velocity == b.motion.velocity,
          "{}: the motion differs", what);
  require(a.load.force == b.load.force && a.load.pressure == b.load.pressure, "{}: the load differs", what);
}

// Correct runs

void comes_and_goes(const CertifyOptions& options) {
  Trial trial(options);
  trial.participant.finalize();
  require(trial.solver.stop("", to_end), "does not exit with code 0 within {} s after Finalize",
          to_end.count());
}

void starts_at_rest(const CertifyOptions& options) {
  const Trial trial(options);
  require(trial.rest.motion.displacement.allFinite() && trial.rest.motion.velocity.isZero(),
          "moves before the first window");
  require(trial.setup.window > 0, "its first window is not > 0");
}

void reports_what_it_announced(const CertifyOptions& options) {
  Trial trial(options);
  for (std::uint64_t n = 0; n < 20; ++n) {
    trial.advance(n, small_load);
    require(trial.report.values.size() == trial.setup.columns.size(), "{} values for {} columns",
            trial.report.values.size(), trial.setup.columns.size());
    for (const double value : trial.report.values) require(std::isfinite(value), "reports {}", value);
  }
}

void shows_frames_of_one_kind(const CertifyOptions& options) {
  Trial trial(options);
  const Snapshot first = trial.participant.frame();
  require(!first.empty(), "sends an empty frame");
  trial.advance(0, small_load);
  const Snapshot second = trial.participant.frame();
  require(first.size() == second.size(), "sends {} arrays, then {}", first.size(), second.size());
  for (std::size_t k = 0; k < first.size(); ++k)
    require(first[k].name == second[k].name && first[k].values.size() == second[k].values.size(),
            "array {} changes its name or length", first[k].name);
}

void goes_back_and_through_again(const CertifyOptions& options) {
  Trial trial(options);
  for (std::uint64_t n = 0; n < 3; ++n) trial.advance(n, small_load);
  const InterfaceState before = trial.state;
  const InterfaceState first = trial.advance(3, small_load, Attempt::first);
  trial.state = before;
  trial.advance(3, 2 * small_load, Attempt::again);
  trial.state = before;
  expect_same(first, trial.advance(3, small_load, Attempt::again),
              "a third attempt with the load of the first");
}

void continues_from_a_saved_state(const CertifyOptions& options) {
  Trial trial(options);
  for (std::uint64_t n = 0; n < 3; ++n) trial.advance(n, small_load);
  const std::string state = trial.participant.save();
  const InterfaceState then = trial.state;
  std::vector<InterfaceState> whole;
  for (std::uint64_t n = 3; n < 8; ++n) whole.push_back(trial.advance(n, small_load));
  Trial fresh(options);
  for (Trial* one : {&trial, &fresh}) {
    one->participant.restore(state);
    one->state = then;
    for (std::uint64_t n = 3; n < 8; ++n)
      expect_same(whole[n - 3], one->advance(n, small_load),
                  one == &fresh ? "in a fresh process" : "restored");
  }
}

// Structures

void stays_at_rest_without_load(const CertifyOptions& options) {
  Trial trial(options);
  for (std::uint64_t n = 0; n < 10; ++n) trial.advance(n, 0);
  require((trial.state.motion.displacement - trial.rest.motion.displacement).norm() == 0,
          "moves without load or gravity");
}

/// Maxwell and Betti's theorem: a load on point j moves point i as much as the same load on i moves j. It
/// holds if loads are mapped with the transpose of the motion's mapping.
void answers_by_the_transpose(const CertifyOptions& options) {
  const auto response = [&](Eigen::Index loaded) {
    Trial trial(options);
    trial.state.load.force.setZero();
    trial.state.load.force(0, loaded) = small_load;
    trial.report =
        trial.solid->advance({.index = 0, .start = 0, .size = size}, trial.state.load, trial.state.motion);
    return Field(trial.state.motion.displacement - trial.rest.motion.displacement);
  };
  const Trial trial(options);
  const Eigen::Index i = trial.points.points() - 1;
  const Eigen::Index j = trial.points.points() / 2;
  const Field by_i = response(i);
  const Field by_j = response(j);
  const double scale = std::max(std::abs(by_i(0, i)), std::abs(by_j(0, j)));
  if (scale == 0) return;  // rigid
  require(std::abs(by_i(0, j) - by_j(0, i)) <= linear * scale,
          "a unit load at point {} moves point {} by {:.6g} m/N, the reverse by {:.6g} m/N", i, j,
          by_i(0, j) / small_load, by_j(0, i) / small_load);
}

/// Checks that the mean velocity is the displacement over the window, and that the work that the solid
/// reports equals the work at the points.
void moves_and_works_consistently(const CertifyOptions& options) {
  Trial trial(options);
  double work = 0;
  double gross = 0;
  for (std::uint64_t n = 0; n < 20; ++n) {
    const Field before = trial.state.motion.displacement;
    trial.advance(n, small_load);
    const Field step = trial.state.motion.displacement - before;
    require((step - size * trial.state.motion.velocity).norm() <= rounding * (step.norm() + 1e-300),
            "the velocity is not the mean over the window");
    work += (trial.state.load.force.array() * step.array()).sum();
    gross += (trial.state.load.force.array() * step.array()).abs().sum();
  }
  for (std::size_t k = 0; k < trial.setup.columns.size(); ++k)
    if (trial.setup.columns[k].name == "interface_work")
      require(std::abs(trial.report.values[k] - work) <= rounding * gross,
              "reports a work of {:.12g} J; loads and motions at the points give {:.12g} J",
              trial.report.values[k], work);
}

// Incorrect runs

void accepts_a_refusal(const CertifyOptions& options) {
  Abuse abuse(options);
  v1::Request request;
  request.mutable_refuse()->set_reason("a test");
  abuse.send(request);
  abuse.expect_failure(false);
}

void obeys_an_abort(const CertifyOptions& options) {
  Abuse abuse(options);
  abuse.welcome();
  v1::Request request;
  request.mutable_abort()->set_reason("a test");
  abuse.send(request);
  abuse.expect_failure(false);
}

void refuses_a_window_before_the_start(const CertifyOptions& options) {
  Abuse abuse(options);
  abuse.welcome();
  abuse.send(abuse.advance(options));
  abuse.expect_failure(true);
}

void refuses_a_number_that_was_left_out(const CertifyOptions& options) {
  Abuse abuse(options);
  abuse.welcome();
  abuse.send(abuse.initialize(options), 3);
  abuse.expect_failure(true);
}

/// A window with invalid numbers.
void refuses_a_window_with(const CertifyOptions& options,
                           const std::function<void(google::protobuf::RepeatedField<double>&)>& spoil) {
  Abuse abuse(options);
  abuse.welcome();
  require(abuse.ask(abuse.initialize(options)).has_initialized(), "does not initialize");
  v1::Request request = abuse.advance(options);
  spoil(Abuse::numbers_of(request));
  abuse.send(request);
  abuse.expect_failure(true);
}

void refuses_what_is_no_number(const CertifyOptions& options) {
  refuses_a_window_with(options,
                        [](auto& numbers) { numbers.Set(3, std::numeric_limits<double>::quiet_NaN()); });
}

void refuses_a_wrong_length(const CertifyOptions& options) {
  refuses_a_window_with(options, [](auto& numbers) { numbers.RemoveLast(); });
}

void survives_no_garbage(const CertifyOptions& options) {
  Abuse abuse(options);
  abuse.welcome();
  abuse.send_bytes("\xff\xff\xff\xff no message");
  abuse.expect_failure(false);
}

struct Check {
  const char* what;
  void (*run)(const CertifyOptions&);
  bool of_solids = false;
};

constexpr Check checks[] = {
    {"connects, is finalized, and exits with code 0", comes_and_goes},
    {"starts at rest and states its largest window", starts_at_rest},
    {"reports as many finite values as it announced", reports_what_it_announced},
    {"sends frames whose arrays keep their names and lengths", shows_frames_of_one_kind},
    {"repeats a window from its start with bit-identical results", goes_back_and_through_again},
    {"continues from a saved state with bit-identical results, also in a new process",
     continues_from_a_saved_state},
    {"stays at rest without load", stays_at_rest_without_load, true},
    {"has a symmetric response to point loads (Maxwell and Betti)", answers_by_the_transpose, true},
    {"reports the mean velocity, and the work of the loads at the points", moves_and_works_consistently,
     true},
    {"exits when it is refused", accepts_a_refusal},
    {"exits when the run is aborted", obeys_an_abort},
    {"rejects a window before the initialization, with a message", refuses_a_window_before_the_start},
    {"rejects a request with a wrong sequence number, with a message", refuses_a_number_that_was_left_out},
    {"rejects NaN, with a message", refuses_what_is_no_number},
    {"rejects a field of the wrong length, with a message", refuses_a_wrong_length},
    {"exits when it receives malformed bytes", survives_no_garbage},
};

}  // namespace

int certify_command(const CertifyOptions& options) {
  int failed = 0;
  for (const Check& check : checks) {
    if (check.of_solids && options.role != Role::solid) continue;
    std::string trouble;
    try {
      check.run(options);
    } catch (const std::exception& error) {
      trouble = error.what();
    }
    failed += trouble.empty() ? 0 : 1;
    say("{}  {}{}{}\n", trouble.empty() ? "passed" : "FAILED", check.what, trouble.empty() ? "" : ": ",
        trouble);
    std::fflush(stdout);
  }
  say("{}\n", failed == 0 ? "certified" : fmt::format("{} checks failed", failed));
  return failed == 0 ? 0 : 1;
}

}  // namespace cosurge
