// The pressure equation of a column of water, for tests and benchmarks of its solvers.
#pragma once

#include "fluid_solver/pressure/poisson_equation.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid::test {

/// The pressure equation of a disordered column, `width` particles wide and twice as high, without walls; its
/// top row is free surface. The right-hand side is noise.
struct Column {
  static constexpr double l0 = 0.004;
  static constexpr double dt = 1e-4;

  explicit Column(int width, double compressibility = 1e-20)
      : cloud(block<2>({width, 2 * width}, l0, 0.2)),
        equation({.spacing = l0,
                  .re = 4 * l0,
                  .density = 1000,
                  .compressibility = compressibility,
                  .gravity = {0, 0}}) {
    auto& particles = cloud.particles;
    for (int i = 0; i < particles.size(); ++i)
      particles.free_surface[i] = static_cast<std::uint8_t>(particles.x[i][1] > (2 * width - 1) * l0);
    std::mt19937 random(1);
    std::normal_distribution<double> noise;
    source.resize(particles.x.size());
    for (double& s : source) s = noise(random);
    assemble();
  }

  void assemble() {
    equation.assemble(cloud.particles, cloud.neighbors.grid(), {}, dt);
    equation.set_source(source);
  }

  const Matrix& A() const { return equation.matrix(); }
  const std::vector<double>& b() const { return equation.right_hand_side(); }

  std::unique_ptr<Preconditioner> preconditioner(PressureSolution::Preconditioner choice) const {
    auto M = make_preconditioner(choice);
    M->set_up(A(), equation.cells());
    return M;
  }

  Cloud<2> cloud;
  PoissonEquation<2> equation;
  std::vector<double> source;
};

}  // namespace cosurge::fluid::test
