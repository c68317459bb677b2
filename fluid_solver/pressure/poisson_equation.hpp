// The pressure Poisson equation.
#pragma once

#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/pressure/linear_solver.hpp"
#include "fluid_solver/pressure/open_surface.hpp"
#include "fluid_solver/reference_values.hpp"

namespace cosurge::fluid {

/// Constants of the pressure equation, eq. (11).
template <int dim>
struct PoissonParameters {
  double spacing;          ///< l0 [m]
  double re;               ///< effective radius of the Laplacian [m]
  double density;          ///< rho [kg/m3]
  double compressibility;  ///< alpha [1/Pa]
  Vec<dim> gravity;        ///< [m/s2]
  /// Whether the free surface follows from missing water (OpenSurface). If so, only particles that cannot
  /// have a pressure are flagged: drops, and walls without water beside them. If not, P = 0 at particles
  /// flagged as free surface, as in Amaro & Cheng.
  bool open_surface = false;
};

/// Eq. (11): (2 d / (lambda0 n0)) sum (P_j - P_i) w - alpha rho / tau^2 P_i = S_i for every particle with a
/// pressure that is not flagged as free surface. Multiplied by -lambda0 n0 / (2 d), the matrix is a symmetric
/// M-matrix. Dummies and inner points of bodies represent P_j = P_i + rho g . x_ij, the Neumann condition of
/// a wall at rest. So do particles on the other side of a body.
template <int dim>
class PoissonEquation {
 public:
  explicit PoissonEquation(const PoissonParameters<dim>& parameters);

  /// Builds the matrix. `areas` are the area vectors of the particles, by place; only those on body surfaces
  /// are used. `tau` [s] is the time scale on which the source corrects the density, eq. (11).
  void assemble(const Particles<dim>& particles, const CellGrid<dim>& grid,
                const std::vector<Vec<dim>>& areas, double tau);

  /// Builds the right-hand side for the assembled matrix; `source` is S for each particle, by place [kg/(m3
  /// s2)].
  void set_source(const std::vector<double>& source);

  /// Relative deviation of each unknown's smooth density, eq. (2b) with the radius of the Laplacian, from
  /// that of the lattice [-]. NaN beside the free surface, where missing water cannot be distinguished from a
  /// low density.
  const std::vector<double>& deviation() const { return deviation_; }

  /// Divergence of the velocity with the weights of the equation, eq. (10b) and (10c), at each unknown [1/s].
  /// Water slides along walls and bodies. `kick` = dt g [m/s] is added to the velocity of both: the predicted
  /// velocity of the water contains it, and the Neumann condition subtracts it from both (docs/method.md, "At
  /// faces"). Without an open surface the value is NaN at unknowns that are not water, or that have a free
  /// surface or a body within the radius.
  std::vector<double> divergence(const Particles<dim>& particles, const CellGrid<dim>& grid,
                                 const Vec<dim>& kick) const;

  /// The same for `velocity` [m/s] by place, where only bodies move: zero at unknowns without a body within
  /// the radius.
  std::vector<double> divergence_by_bodies(const Particles<dim>& particles,
                                           const std::vector<Vec<dim>>& velocity,
                                           const CellGrid<dim>& grid) const;

  /// The right-hand side for `source` alone, without the gravity terms at walls.
  std::vector<double> rows_of(const std::vector<double>& source) const;

  const Matrix& matrix() const { return A_; }
  const std::vector<double>& right_hand_side() const { return b_; }
  const CellsOfUnknowns& cells() const { return cells_; }
  const std::vector<std::int32_t>& unknowns() const { return place_; }  ///< place of each unknown's particle

 private:
  /// One array over the unknowns for each coordinate, padded to whole lanes.
  using Lines = std::array<std::vector<double>, dim>;

  /// Data shared by the rows of one assembly.
  struct Assembly {
    const Particles<dim>& particles;
    const CellGrid<dim>& grid;
    const std::vector<Vec<dim>>& areas;
    int reach;  ///< cells to each side that a row looks at
  };

  /// Which particles other than water lie within the radius of an unknown, one bit each.
  enum Sight : std::uint8_t { walls = 1, bodies = 2, surface = 4 };

  /// A row while it is filled.
  struct Row {
    int i;                ///< place of its particle
    std::int64_t end;     ///< behind the last block so far
    Doubles weights{};    ///< sums of weights, by lane
    double diagonal = 0;  ///< contribution of the free surface
    double wall = 0;      ///< contribution of the Neumann terms
    Floats smooth{};      ///< sums of shares in the smooth density, by lane
    double others = 0;    ///< the same for particles that are not unknowns or are hidden behind a body
    std::uint8_t sight = 0;

    void see(Sight what) { sight |= what; }
  };

  void number_unknowns(const Particles<dim>& particles, const CellGrid<dim>& grid);
  void list_cells(const CellGrid<dim>& grid, int reach);
  Row fill_row(const Assembly& assembly, int row, std::int64_t begin);
  void fill_line(const Assembly& assembly, int first, int last, Row& row);
  void weigh(const Vec<dim>& x_i, int first, int count, float* weights) const;
  void hide_behind_bodies(const Assembly& assembly, int first, int count, float* weights, Row& row) const;
  void append_blocks(int first, int count, const float* weights, Row& row);
  void open_to_air(double lack, Row& row) const;
  void add_others(const Assembly& assembly, int first, int last, Row& row) const;
  template <typename Value>
  Lines in_lines(Value&& value) const;
  Doubles parting(const Lines& velocity, int k, const Floats& weights, int column) const;
  double weight_at(const Vec<dim>& x_ij) const;
  double per_sum() const;
  double divergence_at_faces(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                             const CellGrid<dim>& grid, int i, const Vec<dim>& kick) const;

  PoissonParameters<dim> parameters_;
  ReferenceValues reference_;
  OpenSurface open_surface_;
  Matrix A_;
  std::vector<double> b_;
  std::vector<double> wall_;  // Neumann terms in b_
  std::vector<double> deviation_;
  std::vector<std::uint8_t> sight_;
  CellsOfUnknowns cells_;
  std::vector<std::int32_t> place_;  // place of the particle of each unknown
  std::vector<std::int32_t> rank_;   // number of unknowns in lower places, for each place and the end
  std::vector<std::int32_t> other_;  // places of the particles without an unknown
  std::vector<std::int32_t> wet_;    // number of lower unknowns on bodies, for each unknown and the end
  std::vector<std::int32_t> face_;   // the same for unknowns on walls and bodies
  Lines x_;                          // positions of the unknowns
};

}  // namespace cosurge::fluid
