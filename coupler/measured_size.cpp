#include "coupler/measured_size.hpp"

#include <sys/resource.h>

#include <chrono>
#include <cmath>

#include "common/case/carriers.hpp"
#include "common/case/several_solids.hpp"
#include "common/case/window_sizes.hpp"
#include "coupler/coupler.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

/// Measures the time of a few windows, after some that are not counted if there are enough.
class Stopwatch : public Observer {
 public:
  static constexpr int warm_up = 3;
  static constexpr int windows = 10;
  static constexpr double patience = 30;  // s

  void window(const Window&, const Reports&, const std::vector<double>&) override {
    ++seen_;
    last_ = Clock::now();
    if (seen_ == warm_up) since_ = last_, before_ = seen_;
  }
  bool done() const { return seen_ >= warm_up + windows || (seen_ > 0 && seconds(begin_, last_) > patience); }
  double seconds_per_window() const {
    if (seen_ > before_) return seconds(since_, last_) / (seen_ - before_);
    return seen_ > 0 ? seconds(begin_, last_) / seen_ : 0;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }

  Clock::time_point begin_ = Clock::now(), since_ = begin_, last_ = begin_;
  int seen_ = 0;
  int before_ = 0;  // windows that are not counted
};

}  // namespace

MeasuredSize measure_size(Simulation& simulation) {
  simulation.begin();
  say("  running at most {} windows to measure their time ...\n", Stopwatch::warm_up + Stopwatch::windows);
  Stopwatch stopwatch;
  simulation.observe(stopwatch);
  simulation.run([&] { return stopwatch.done(); });
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const v1::Case& the_case = simulation.the_case();
  return {.members = simulation.members(),
          .points = static_cast<long>(simulation.coupler().interface().points()),
          .windows = std::ceil(the_case.time().end() / expected_window(the_case)),
          .megabytes = static_cast<double>(usage.ru_maxrss) / 1024,
          .seconds_per_window = stopwatch.seconds_per_window()};
}

void say_size(const v1::Case& the_case, const MeasuredSize& size) {
  for (const Member& member : size.members) {
    say("  {:<12} {} particles", member.name, member.setup.particles);
    if (member.setup.substep > 0)
      say(", sub-steps of {:.3g} s ({:.0f} a window)", member.setup.substep,
          std::ceil(expected_window(the_case) / member.setup.substep));
    say("\n");
  }
  for (int b = 0; b < the_case.solid().body_size(); ++b)
    if (const v1::Body& body = the_case.solid().body(b); !is_held(solid_of(the_case, body), body))
      say("  {:<12} {}: no clamp or support holds it\n", "free",
          with_written_keys(the_case, fmt::format("solid.body.{}", b)));
  say("  {:<12} {} points\n", "interface", size.points);
  say("  {:<12} about {:.0f} of at most {:g} s, to t = {:g} s\n", "windows", size.windows,
      longest_window(the_case), the_case.time().end());
  say("  {:<12} {:.0f} MB\n", "memory", size.megabytes);
  say("  {:<12} {:.3g} ms per window now, about {:.0f} s in total\n", "time", 1e3 * size.seconds_per_window,
      size.seconds());
}

}  // namespace cosurge
