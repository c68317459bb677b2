#include "solid_solver/models/modal/modes.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/MatOp/SymShiftInvert.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <numbers>

#include "common/error.hpp"

namespace cosurge::modal {
namespace {

// Shift relative to omega^2 of the fundamental pressure wave: far below the modes of all but the most slender
// bodies, and far above the rounding error of K.
constexpr double shift = 1e-3;
constexpr double rounding = 1e-6;  // [shift] tolerance for the zero eigenvalue of a rigid motion
constexpr double tolerance = 1e-12;
constexpr int most_restarts = 1000;

}  // namespace

template <int dim>
Modes lowest_modes(const fem::FemBody<dim>& body, const Elasticity& material, int count) {
  using Inverse = Spectra::SymShiftInvert<double, Eigen::Sparse, Eigen::Sparse>;
  using Product = Spectra::SparseSymMatProd<double>;
  const auto unknowns = static_cast<int>(body.unknowns());
  require(count < unknowns, "solid.modal.modes = {}: must be < {}, the unknowns of a body", count, unknowns);
  const Box<dim>& bounds = body.mesh().shape().bounds();
  const double length = (bounds.max - bounds.min).maxCoeff();
  const double wave = std::numbers::pi * material.pressure_speed() / length;
  const double sigma = -shift * wave * wave;

  const fem::Matrix stiffness = body.tangent(fem::Vector::Zero(unknowns));
  Inverse inverse(stiffness, body.mass());
  Product product(body.mass());
  const int basis = std::min(unknowns, std::max(2 * count + 1, 20));
  Spectra::SymGEigsShiftSolver<Inverse, Product, Spectra::GEigsMode::ShiftInvert> solver(inverse, product,
                                                                                         count, basis, sigma);
  solver.init();
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, most_restarts, tolerance,
                                    Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw NumericalError(fmt::format(
        "solid: {} of {} modes found in {} restarts; lower solid.modal.modes or raise solid.fem.element",
        found, count, most_restarts));
  Modes modes{.omega_squared = solver.eigenvalues(), .shapes = solver.eigenvectors()};
  for (int i = 0; i < count; ++i) {
    if (modes.omega_squared[i] < -rounding * sigma) modes.omega_squared[i] = 0;
    const Eigen::VectorXd shape = modes.shapes.col(i);
    modes.shapes.col(i) /= std::sqrt(shape.dot(body.momentum(shape)));
  }
  return modes;
}

template <int dim>
Modes lowest_of_body(const Structure<dim>& structure, std::size_t b, int count) {
  const Elasticity& material = structure.material;
  const fem::FemBody<dim> body(structure.bodies[b], b, structure.element, material, Vec<dim>::Zero());
  return lowest_modes(body, material, std::clamp(static_cast<int>(body.unknowns()) - 1, 1, count));
}

template Modes lowest_of_body<2>(const Structure<2>&, std::size_t, int);
template Modes lowest_of_body<3>(const Structure<3>&, std::size_t, int);
template Modes lowest_modes<2>(const fem::FemBody<2>&, const Elasticity&, int);
template Modes lowest_modes<3>(const fem::FemBody<3>&, const Elasticity&, int);

}  // namespace cosurge::modal
