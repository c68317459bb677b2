#include "solid_solver/models/mps/pair_weights.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>

#include "common/error.hpp"

namespace cosurge::mps {
namespace {

using particles::Neighbor;
using particles::Slots;

/// A pair of particles, seen from the first one, which is free.
struct Link {
  std::size_t first, second, neighbor, opposite;  // particles; the pair in the stencil, from both sides
  double reach;
  bool ends_in_clamp;
};

template <int dim>
std::size_t opposite_of(std::size_t neighbor, const particles::Stencil<dim>& stencil) {
  const auto& all = stencil.neighbors;
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(),
                   [&](const Neighbor<dim>& n) { return n.offset == -all[neighbor].offset; }) -
      all.begin());
}

template <int dim>
std::vector<Link> links_of(const particles::BodyGrid<dim>& grid, const particles::Stencil<dim>& stencil) {
  std::vector<Link> links;
  for (std::size_t k = 0; k < stencil.neighbors.size(); ++k) {
    const Neighbor<dim>& n = stencil.neighbors[k];
    const std::size_t opposite = opposite_of(k, stencil);
    for (std::size_t i = 0; i < grid.positions().size(); ++i) {
      const long j = grid.particle_in(grid.slot(i) + grid.shift(n.offset));
      if (j < 0 || grid.held(i)) continue;
      const bool held = grid.held(static_cast<std::size_t>(j));
      if (!held && k > opposite) continue;  // counted from the other particle
      links.push_back({.first = i,
                       .second = static_cast<std::size_t>(j),
                       .neighbor = k,
                       .opposite = opposite,
                       .reach = held ? grid.share_outside_clamps(grid.positions()[i], n.r0) : 1,
                       .ends_in_clamp = held});
    }
  }
  return links;
}

/// Matrix from the weights of the links to the second moments of all particles; matrix rows are (particle, a
/// <= b).
template <int dim>
Eigen::SparseMatrix<double> moments(const std::vector<Link>& links, std::size_t count,
                                    const particles::Stencil<dim>& stencil) {
  constexpr int parts = dim * (dim + 1) / 2;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t column = 0; column < links.size(); ++column) {
    const Link& link = links[column];
    const Neighbor<dim>& n = stencil.neighbors[link.neighbor];
    const Vec<dim> direction = n.r0 / n.length;
    // The part of a pair's energy on the side of a clamp belongs to the free particle.
    const double scale = link.ends_in_clamp ? 2 * link.reach * link.reach : 1;
    int part = 0;
    for (int a = 0; a < dim; ++a) {
      for (int b = a; b < dim; ++b, ++part) {
        const double moment = scale * direction[a] * direction[b];
        entries.emplace_back(static_cast<int>(link.first * parts) + part, static_cast<int>(column), moment);
        if (!link.ends_in_clamp)
          entries.emplace_back(static_cast<int>(link.second * parts) + part, static_cast<int>(column),
                               moment);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(count) * parts,
                                     static_cast<Eigen::Index>(links.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// A weight for every link. Conjugate gradients that start from the lattice's weights find the solution
/// nearest to them.
template <int dim>
Eigen::VectorXd solve_weights(const std::vector<Link>& links, const particles::BodyGrid<dim>& grid,
                              const particles::Stencil<dim>& stencil) {
  constexpr int parts = dim * (dim + 1) / 2;
  const std::size_t count = grid.positions().size();
  Eigen::VectorXd weight(static_cast<Eigen::Index>(links.size()));
  for (std::size_t k = 0; k < links.size(); ++k)
    weight[static_cast<Eigen::Index>(k)] = stencil.neighbors[links[k].neighbor].w / links[k].reach;
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count) * parts);
  for (std::size_t i = 0; i < count; ++i) {
    if (grid.held(i)) continue;
    for (int a = 0, part = 0; a < dim; part += dim - a, ++a)
      whole[static_cast<Eigen::Index>(i) * parts + part] = stencil.n0 / dim;
  }
  const Eigen::SparseMatrix<double> matrix = moments(links, count, stencil);
  Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>, Eigen::IdentityPreconditioner> solver(
      matrix);
  solver.setTolerance(1e-12);
  solver.setMaxIterations(20000);
  weight += solver.solve(whole - matrix * weight);
  if (solver.info() != Eigen::Success)
    throw NumericalError(
        fmt::format("solid: the pair weights did not converge: residual {:.2g} after {} iterations",
                    solver.error(), solver.iterations()));
  return weight;
}

template <int dim>
PairWeights<dim> no_pairs(const particles::BodyGrid<dim>& grid, const particles::Stencil<dim>& stencil) {
  const Slots zero = Slots::Zero(grid.slots());
  PairWeights<dim> weights{.pairs = {}, .dilates = zero, .bending = 0};
  weights.pairs.assign(stencil.neighbors.size(), {.spring = zero, .stretch = zero, .reach = zero + 1});
  return weights;
}

}  // namespace

template <int dim>
PairWeights<dim> lattice_weights(const particles::BodyGrid<dim>& grid,
                                 const particles::Stencil<dim>& stencil) {
  PairWeights<dim> weights = no_pairs(grid, stencil);
  for (std::size_t i = 0; i < grid.positions().size(); ++i) {
    const Eigen::Index slot = grid.slot(i);
    weights.dilates[slot] = 1;
    for (std::size_t k = 0; k < stencil.neighbors.size(); ++k) {
      const Neighbor<dim>& n = stencil.neighbors[k];
      if (grid.particle_in(slot + grid.shift(n.offset)) < 0) continue;
      weights.pairs[k].spring[slot] = weights.pairs[k].stretch[slot] = n.w;
    }
  }
  return weights;
}

template <int dim>
PairWeights<dim> whole_weights(const particles::BodyGrid<dim>& grid, const particles::Stencil<dim>& stencil) {
  PairWeights<dim> weights = no_pairs(grid, stencil);
  for (std::size_t i = 0; i < grid.positions().size(); ++i)
    weights.dilates[grid.slot(i)] = grid.held(i) ? 0 : 1;
  const std::vector<Link> links = links_of(grid, stencil);
  const Eigen::VectorXd weight = solve_weights(links, grid, stencil);
  for (std::size_t k = 0; k < links.size(); ++k) {
    const Link& link = links[k];
    const double w = weight[static_cast<Eigen::Index>(k)];
    const auto put = [&](std::size_t neighbor, std::size_t particle) {
      auto& pair = weights.pairs[neighbor];
      const Eigen::Index slot = grid.slot(particle);
      pair.spring[slot] = w;
      pair.stretch[slot] = link.ends_in_clamp ? 2 * link.reach * w : w;
      pair.reach[slot] = link.reach;
    };
    put(link.neighbor, link.first);
    put(link.opposite, link.second);
  }
  const double l0 = stencil.spacing;
  double lost = 0;  // (S38)
  for (const Neighbor<dim>& n : stencil.neighbors) lost += n.w * std::pow(n.r0[0] * n.r0[1] / n.length, 2);
  weights.bending = l0 * l0 / 12 + dim / stencil.n0 * lost / 4;
  return weights;
}

template PairWeights<2> lattice_weights<2>(const particles::BodyGrid<2>&, const particles::Stencil<2>&);
template PairWeights<3> lattice_weights<3>(const particles::BodyGrid<3>&, const particles::Stencil<3>&);
template PairWeights<2> whole_weights<2>(const particles::BodyGrid<2>&, const particles::Stencil<2>&);
template PairWeights<3> whole_weights<3>(const particles::BodyGrid<3>&, const particles::Stencil<3>&);

}  // namespace cosurge::mps
