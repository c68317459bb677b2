// A user's own plate in the water of a dam break: it leans on a spring, u_x = q (y / h)^2. An observer
// watches it.
#include <algorithm>
#include <cosurge/simulation.hpp>
#include <cstring>
#include <iostream>
#include <stdexcept>

struct LeaningPlate : cosurge::Solid {
  double mass = 2, spring = 2000;  // per metre of width, of the unknown q [kg/m, N/m2]
  double q = 0, speed = 0;
  Eigen::RowVectorXd lean;  // H: displacement of each point for q = 1

  cosurge::Identity identity() const override { return {"leaning plate", "1", {2}, {"save", "frame"}}; }
  cosurge::Setup initialize(const cosurge::v1::Case&, const cosurge::Interface& points,
                            const cosurge::InterfaceLoad&, cosurge::InterfaceMotion& motion) override {
    lean = (points.position.row(1) / points.position.row(1).maxCoeff()).array().square();
    motion = cosurge::InterfaceMotion::at_rest(2, points.points());
    return {.columns = {{"q", "m"}}, .particles = 0, .window = 1};
  }
  cosurge::Report advance(const cosurge::Window& window, const cosurge::InterfaceLoad& load,
                          cosurge::InterfaceMotion& motion) override {
    speed += window.size * (load.force.row(0).dot(lean) - spring * q) / mass;
    q += window.size * speed;
    motion.displacement.row(0) = q * lean;
    motion.velocity.row(0) = speed * lean;
    return {.values = {q}, .window = 1};
  }
  std::string save() override {
    std::string state(2 * sizeof(double), ' ');
    std::memcpy(state.data(), &q, sizeof q);
    std::memcpy(state.data() + sizeof q, &speed, sizeof speed);
    return state;
  }
  void restore(const std::string& state) override {
    std::memcpy(&q, state.data(), sizeof q);
    std::memcpy(&speed, state.data() + sizeof q, sizeof speed);
  }
  cosurge::Snapshot frame() override { return {}; }
};

struct Largest : cosurge::Observer {
  int windows = 0;
  double q = 0;
  void window(const cosurge::Window&, const cosurge::Reports& reports, const std::vector<double>&) override {
    ++windows;
    q = std::max(q, reports.at(1).values.at(0));
  }
};

/// consumer CASE [wire]: with `wire` the fluid solver is a process of its own.
int main(int argc, char** argv) try {
  if (argc < 2) throw std::invalid_argument("usage: consumer CASE [wire]");
  const std::vector<std::string> coarse = {"fluid.spacing=0.004", "fluid.water.0.max=[0.148, 0.292]",
                                           "time.end=0.2"};
  auto simulation = cosurge::Simulation::of_file(argv[1], coarse);
  simulation.here(std::make_unique<LeaningPlate>());
  if (argc > 2) simulation.in_process(cosurge::Role::fluid);
  Largest largest;
  simulation.observe(largest);
  simulation.run();
  std::cout.precision(17);
  std::cout << largest.windows << " windows, largest q " << largest.q << " m\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
