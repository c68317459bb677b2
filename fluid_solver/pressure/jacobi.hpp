// Diagonal preconditioner.
#pragma once

#include "fluid_solver/pressure/linear_solver.hpp"

namespace cosurge::fluid {

/// Multiplies the residual by the inverse of the diagonal of the matrix.
class Jacobi : public Preconditioner {
 public:
  void set_up(const Matrix& A, const CellsOfUnknowns&) override { diagonal_ = &A.diagonal; }
  void apply(const std::vector<double>& r, std::vector<float>& z) override {
    for (std::size_t i = 0; i < r.size(); ++i) z[i] = static_cast<float>(r[i] / (*diagonal_)[i]);
  }

 private:
  const std::vector<double>* diagonal_ = nullptr;
};

}  // namespace cosurge::fluid
