// Interface of a solver for the pressure equation.
#pragma once

#include <memory>
#include <vector>

#include "fluid_solver/pressure/matrix.hpp"
#include "fluid_solver/pressure/pressure_solution.hpp"

namespace cosurge::fluid {

struct [[nodiscard]] SolveReport {
  int iterations = 0;
  double relative_residual = 0;  ///< ||b - A x|| / ||b||, computed from x and not from the recurrence
  bool converged = true;
};

/// The cells of the neighbour search that contain unknowns. Unknowns are numbered by cell.
struct CellsOfUnknowns {
  /// Consecutive cells.
  struct Line {
    std::int32_t begin;
    std::int32_t end;
  };

  std::vector<std::int32_t> first;       ///< first unknown of each cell, and the end
  std::vector<std::array<int, 3>> cell;  ///< coordinates of each
  std::vector<std::int32_t> of_unknown;  ///< cell of each unknown, and the end
  int lines_per_cell = 0;
  std::vector<Line> line;  ///< cells that the rows of each cell may touch; those that are missing are empty

  int size() const { return static_cast<int>(cell.size()); }
};

/// An approximate inverse: symmetric, positive definite, the same for every vector until it is set up again.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  virtual void set_up(const Matrix& A, const CellsOfUnknowns& cells) = 0;
  virtual void apply(const std::vector<double>& r, std::vector<float>& z) = 0;
};

/// Creates the chosen preconditioner.
std::unique_ptr<Preconditioner> make_preconditioner(PressureSolution::Preconditioner choice);

/// Preconditioned conjugate gradients (Barrett et al. 1994, Templates, fig. 2.5) from the start value in x
/// until
/// ||b - A x|| <= tolerance ||b||. The residual is recomputed before success is reported.
SolveReport conjugate_gradient(const Matrix& A, const std::vector<double>& b, Preconditioner& M,
                               double tolerance, int max_iterations, std::vector<double>& x);

}  // namespace cosurge::fluid
