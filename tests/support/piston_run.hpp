// A coupled run of the sprung piston under a lumped water column.
#pragma once

#include <vector>

#include "coupler/coupler.hpp"
#include "tests/support/mock_participant.hpp"

namespace cosurge::testing {

/// Records the pressure of every window, and the values of the coupler itself.
class PressureHistory : public Observer {
 public:
  void window(const Window& window, const Reports& reports, const std::vector<double>& own) override {
    time.push_back(window.start + window.size);
    pressure.push_back(reports.at(0).values.at(0));
    height.push_back(reports.at(1).values.at(0));
    coupling.push_back(own);
  }

  std::vector<double> time, pressure, height;
  std::vector<std::vector<double>> coupling;
};

/// Computes `count` windows with the settings of the coupling for both participants.
struct PistonRun {
  std::unique_ptr<MockFluid> fluid;
  std::unique_ptr<MockSolid> solid;
  v1::Case the_case = piston_case();
  std::unique_ptr<Coupler> coupler;
  PressureHistory history;

  PistonRun(Piston piston, const v1::Coupling& coupling, double window = 1e-3) {
    piston.ramped = coupling.load() == v1::Coupling::ramped;
    piston.end_velocity = coupling.velocity() == v1::Coupling::end;
    fluid = water_column(piston);
    solid = sprung_piston(piston);
    *the_case.mutable_coupling() = coupling;
    the_case.mutable_time()->set_end(1e6);
    the_case.mutable_time()->set_window(window);
    the_case.mutable_output()->set_frame_interval(1e6);
    coupler = std::make_unique<Coupler>(the_case, Participants{fluid.get(), solid.get()});
  }

  void run(std::size_t count) {
    const std::size_t until = history.time.size() + count;
    coupler->run({&history}, [&] { return history.time.size() >= until; });
  }

  /// The coupler's own values in the last window.
  double value(const std::string& name) const {
    const std::vector<Column> columns = coupler->columns();
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (columns[k].name == name) return history.coupling.back().at(k);
    throw Error("no column " + name);
  }

  /// Mean frequency between the first and last upward passage of the height through its mean [Hz].
  double frequency() const {
    double mean = 0;
    for (const double y : history.height) mean += y / static_cast<double>(history.height.size());
    std::vector<double> passages;
    for (std::size_t k = 1; k < history.height.size(); ++k) {
      const double a = history.height[k - 1] - mean, b = history.height[k] - mean;
      if (a < 0 && b >= 0)
        passages.push_back(history.time[k - 1] + a / (a - b) * (history.time[k] - history.time[k - 1]));
    }
    return static_cast<double>(passages.size() - 1) / (passages.back() - passages.front());
  }
};

}  // namespace cosurge::testing
