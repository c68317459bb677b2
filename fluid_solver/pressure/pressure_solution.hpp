// How the pressure equation is solved.
#pragma once

namespace cosurge::fluid {

/// Preconditioner, tolerance and limit of the conjugate gradients.
struct PressureSolution {
  enum class Preconditioner {
    aggregation,  ///< multilevel, with aggregates of the particles in the cells of the neighbour search
    jacobi,
  };
  Preconditioner preconditioner;
  double tolerance;    ///< tolerance of the relative residual
  int max_iterations;  ///< the run fails after more iterations
};

}  // namespace cosurge::fluid
