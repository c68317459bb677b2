// Multilevel preconditioner on the cells of the neighbour search.
#pragma once

#include <Eigen/Cholesky>

#include "fluid_solver/pressure/linear_solver.hpp"

namespace cosurge::fluid {

/// Plain aggregation (Braess 1995, Computing 55, 379-393): the unknowns of one cell (2.1 l0 wide, about four
/// in two dimensions) make one unknown of the next level, 2 x 2 (x 2) cells one of the level after, down to a
/// small dense system. Prolongation P is piecewise constant and coarse matrices are Galerkin sums;
/// corrections are scaled up because piecewise constants are too stiff. The levels of cells form a V-cycle V
/// with one damped Jacobi sweep before and after. On the unknowns themselves the preconditioner is the sum
/// D^-1 + 1.6 P V P^T, which takes half as many iterations again as a full V-cycle but no product with the
/// matrix. Coarse levels are in single precision, which is accurate enough for a preconditioner.
class Aggregation : public Preconditioner {
 public:
  void set_up(const Matrix& A, const CellsOfUnknowns& cells) override;
  void apply(const std::vector<double>& r, std::vector<float>& z) override;

  int levels() const { return static_cast<int>(coarse_.size()) + 1; }

 private:
  static constexpr float damping = 0.8F;  // damping of the Jacobi sweeps
  static constexpr float correction =
      1.6F;  // factor on the coarse correction, the best value measured on disordered columns
  static constexpr int directly = 160;  // unknowns below which the system is factorised

  /// One coarse level: its matrix, and how its unknowns gather those of the finer level.
  struct Level : BlockRows {
    std::vector<std::array<int, 3>> cell;
    std::vector<float> diagonal;
    // Only for levels after the first one; the unknowns of the first are the cells:
    std::vector<std::int32_t> aggregate;  // aggregate of each unknown of the finer level
    std::vector<std::int32_t> begin;      // first entry of each aggregate in `member`, and the end
    std::vector<std::int32_t> member;     // unknowns of the finer level
    std::vector<float> r, x, t;
    int size() const { return static_cast<int>(cell.size()); }
    void list_members();
  };

  Level first_level(const Matrix& A, const CellsOfUnknowns& cells) const;
  static Level next_level(const Level& fine);
  void factorise();
  void cycle(std::size_t level);

  const Matrix* A_ = nullptr;
  std::vector<std::int32_t> first_;  // unknown of each aggregate, and the end
  std::vector<Level> coarse_;
  Eigen::LLT<Eigen::MatrixXf> direct_;
};

}  // namespace cosurge::fluid
