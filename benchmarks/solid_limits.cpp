// Stability limits of the explicit structural models: tables of docs/stability.md.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "solid_solver/models/hamiltonian/hamiltonian_body.hpp"
#include "solid_solver/models/mps/mps_body.hpp"
#include "tests/support/solid_cases.hpp"
#include "tests/support/structures.hpp"
#include "tests/support/timoshenko.hpp"

namespace cosurge {
namespace {

using test::l0;

constexpr double re = 2.1, density = 2500, young_modulus = 1e6;

struct Block {
  int columns, rows;
  bool clamped;
  double poisson_ratio;
  double stabilisation = 1;  // parameter of `hamiltonian`
};

template <typename Body, typename... Choice>
Body make(const Block& block, const Choice&... choice) {
  const v1::Case c = test::plate({.columns = block.columns, .rows = block.rows, .clamped = block.clamped});
  const Elasticity material{
      .density = density, .young_modulus = young_modulus, .poisson_ratio = block.poisson_ratio};
  return Body(test::body_of<2>(c.solid().body(0)), 0, particles::full_stencil<2>(l0, re),
              {.material = material, .gravity = Vec<2>::Zero()}, choice...);
}

double pressure_speed(const Block& block) {
  return Elasticity{.density = density, .young_modulus = young_modulus, .poisson_ratio = block.poisson_ratio}
      .pressure_speed();
}

/// Gives each particle a random velocity up to `speed`, which excites all motions of the lattice, mostly the
/// shortest ones. Returns the kinetic energy after ten periods of the first mode, relative to the start;
/// infinite if a particle became faster than the waves.
template <typename Body>
double energy_left(Body body, const Block& block, double dt, double speed) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-speed, speed);
  double start = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(body.particles()); ++p) {
    const Vec<2> v(unit(random), unit(random));
    body.place(p, Vec<2>::Zero(), v);
  }
  start = body.velocity().squaredNorm();
  const Cantilever plate = {block.rows * l0, block.columns * l0, density, young_modulus, block.poisson_ratio};
  const auto steps = static_cast<int>(std::ceil(10 / plate.timoshenko() / dt));
  constexpr int parts = 100;
  for (int k = 0; k < parts; ++k) {
    body.advance((steps + parts - 1) / parts, dt);
    if (!(body.velocity().cwiseAbs().maxCoeff() < 10 * pressure_speed(block))) return INFINITY;
  }
  return body.velocity().squaredNorm() / start;
}

template <typename Body, typename... Choice>
void steps_of(const std::string& model, const Choice&... choice) {
  for (const double nu : {0.0, 0.1, 0.2, 0.3, 0.4, 0.45}) {
    const Block block{.columns = 12, .rows = 40, .clamped = true, .poisson_ratio = nu};
    const Body body = make<Body>(block, choice...);
    const double stable = 2 / body.highest_frequency(), unit = l0 / pressure_speed(block);
    for (const double speed : {1e-3, 0.1})
      for (const double share : {0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 1.02, 1.05, 1.1, 1.3, 1.6}) {
        const double left = energy_left(body, block, share * stable, speed * pressure_speed(block));
        fmt::print("{},{:g},{:.4f},{:g},{:g},{},{:.3g}\n", model, nu, stable / unit, speed, share,
                   left < 10 ? "stable" : "blown_up", left);
        std::fflush(stdout);
      }
  }
}

void steps() {
  fmt::print("model,poisson_ratio,stated_c_p_over_l0,speed_over_c_p,share,state,kinetic_energy\n");
  steps_of<mps::MpsBody<2>>("mps corrected", MpsParameters::Pairs::corrected);
  steps_of<mps::MpsBody<2>>("mps paper", MpsParameters::Pairs::paper);
  steps_of<hamiltonian::HamiltonianBody<2>>("hamiltonian", 1.0);
}

struct Spectrum {
  Eigen::VectorXd frequency;  // over c_p / l0, ascending
  Eigen::MatrixXd shape;
};

/// Spectrum of the undeformed body, from differences of its forces.
Spectrum spectrum(const Block& block) {
  using Body = hamiltonian::HamiltonianBody<2>;
  Body body = make<Body>(block, block.stabilisation);
  std::vector<std::pair<std::size_t, int>> unknowns;
  for (std::size_t p = 0; p < body.grid().positions().size(); ++p)
    if (!body.grid().held(p))
      for (const int axis : {0, 1}) unknowns.emplace_back(p, axis);
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  const double step = 1e-6 * l0;
  Eigen::MatrixXd K(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto [p, axis] = unknowns[static_cast<std::size_t>(i)];
    body.place(p, step * Vec<2>::Unit(axis), Vec<2>::Zero());
    const Field a = body.acceleration();
    body.place(p, Vec<2>::Zero(), Vec<2>::Zero());
    for (Eigen::Index j = 0; j < size; ++j) {
      const auto [q, other] = unknowns[static_cast<std::size_t>(j)];
      K(j, i) = -a(other, static_cast<Eigen::Index>(q)) / step;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(0.5 * (K + K.transpose()));
  return {.frequency = modes.eigenvalues().cwiseMax(0).cwiseSqrt() * l0 / pressure_speed(block),
          .shape = modes.eigenvectors()};
}

/// Ratio for a vector over the particles: change between neighbours along both axes, divided by the change
/// between next-nearest neighbours. 1 for a smooth vector, large for an alternating one.
double alternation(const Block& block, const Eigen::VectorXd& shape) {
  const auto at = [&](int i, int j) { return shape.segment<2>(2 * (j * block.columns + i)); };
  double near = 0, far = 0;
  for (int j = 0; j + 2 < block.rows; ++j)
    for (int i = 0; i + 2 < block.columns; ++i) {
      near += 4 * ((at(i + 1, j) - at(i, j)).squaredNorm() + (at(i, j + 1) - at(i, j)).squaredNorm());
      far += (at(i + 2, j) - at(i, j)).squaredNorm() + (at(i, j + 2) - at(i, j)).squaredNorm();
    }
  return std::sqrt(near / far);
}

const Block small_block{.columns = 12, .rows = 24, .clamped = false, .poisson_ratio = 0.3};

/// Number of motions of a free block, and of a clamped one, that are slower than its first bending with the
/// full stabilisation: a free block has three, a clamped one none.
void zero_modes() {
  fmt::print("stabilisation,clamped,slower_than_bending,lowest_beyond,first_bending,alternating\n");
  for (const bool clamped : {false, true}) {
    Block block = small_block;
    block.clamped = clamped;
    const int rigid = clamped ? 0 : 3;
    block.stabilisation = 1;
    const double bending = spectrum(block).frequency[rigid];
    for (const double stabilisation : {0.0, 1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0}) {
      block.stabilisation = stabilisation;
      const Spectrum all = spectrum(block);
      int slow = 0, wild = 0;
      for (; all.frequency[slow] < 0.7 * bending; ++slow)
        wild += alternation(block, all.shape.col(slow)) > 2 ? 1 : 0;
      fmt::print("{:g},{},{},{:.3e},{:.4f},{}\n", stabilisation, clamped, slow, all.frequency[rigid], bending,
                 wild);
    }
  }
}

/// The motion of a free block with the least energy except the rigid ones, without stabilisation and with it.
void zero_mode() {
  fmt::print("stabilisation,x,y,u_x,u_y,frequency\n");
  for (const double stabilisation : {0.0, 1.0}) {
    Block block = small_block;
    block.stabilisation = stabilisation;
    const Spectrum all = spectrum(block);
    const Eigen::VectorXd shape = all.shape.col(3) / all.shape.col(3).cwiseAbs().maxCoeff();
    for (int j = 0; j < block.rows; ++j)
      for (int i = 0; i < block.columns; ++i) {
        const auto u = shape.segment<2>(2 * (j * block.columns + i));
        fmt::print("{:g},{:.1f},{:.1f},{:.4f},{:.4f},{:.3e}\n", stabilisation, i + 0.5, j + 0.5, u[0], u[1],
                   all.frequency[3]);
      }
  }
}

}  // namespace
}  // namespace cosurge

int main(int count, char** arguments) {
  using namespace cosurge;
  const std::map<std::string, std::function<void()>> tables = {
      {"steps", steps}, {"zero_modes", zero_modes}, {"zero_mode", zero_mode}};
  CLI::App app("Writes one table of the limits of the explicit solids to standard output, as CSV");
  std::string table;
  app.add_option("table", table)->required()->check(CLI::IsMember(tables));
  CLI11_PARSE(app, count, arguments);
  fmt::print("# build/release/bin/solid_limits {}\n", table);
  tables.at(table)();
}
