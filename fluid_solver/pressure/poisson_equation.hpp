// The pressure Poisson equation.
#pragma once

#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/pressure/linear_solver.hpp"
#include "fluid_solver/pressure/open_surface.hpp"
#include "fluid_solver/reference_values.hpp"

namespace cosurge::fluid {

template <int dim>
struct PoissonParameters {
  double spacing;          ///< l0 [m]
  double re;               ///< effective radius of the Laplacian [m]
  double density;          ///< rho [kg/m3]
  double compressibility;  ///< alpha [1/Pa]
  Vec<dim> gravity;        ///< [m/s2]
  /// Whether the free surface is what OpenSurface makes of missing water; else P = 0 at particles flagged as
  /// free surface, as in Amaro & Cheng. Flagged are then only particles without pressure: lone drops, and
  /// walls without water beside them.
  bool open_surface = false;
};

/// Eq. (11): (2 d / (lambda0 n0)) sum (P_j - P_i) w - alpha rho / tau^2 P_i = S_i for every particle with a
/// pressure that is not flagged as free surface. Times -lambda0 n0 / (2 d) it is a symmetric M-matrix.
/// Dummies and inner points of bodies represent P_j = P_i + rho g . x_ij: the Neumann condition of a wall at
/// rest. So do pairs that see each other through a body.
template <int dim>
class PoissonEquation {
 public:
  explicit PoissonEquation(const PoissonParameters<dim>& parameters);

  /// Builds the matrix. `areas` are the area vectors of the particles on body surfaces (others are not looked
  /// at), by place. `tau` [s] is the time on which the source mends the density.
  void assemble(const Particles<dim>& particles, const CellGrid<dim>& grid,
                const std::vector<Vec<dim>>& areas, double tau);

  /// Builds the right-hand side for the matrix that is there; `source` is S for each particle, by place
  /// [kg/(m3 s2)].
  void set_source(const std::vector<double>& source);

  /// Deviation of each unknown's smooth density, eq. (2b) with the radius of the Laplacian, from the density
  /// of the lattice, relative to the latter [-]. NaN beside the free surface: there, missing water cannot be
  /// told from thin water.
  const std::vector<double>& deviation() const { return deviation_; }

  /// Divergence of the velocity with the equation's own weights, eq. (10b) and (10c), at each unknown [1/s].
  /// Water slides along walls and bodies; `kick` [m/s] is added to the velocity of both: what gravity has
  /// given the water in the prediction. The Neumann condition takes it back from both; without it the source
  /// would count the weight of the water once more. Without an open surface it is NaN at unknowns that are no
  /// water, or have a free surface or a body within the radius.
  std::vector<double> divergence(const Particles<dim>& particles, const CellGrid<dim>& grid,
                                 const Vec<dim>& kick) const;

  /// The same for `velocity` [m/s] by place, where only bodies move: zero at unknowns that see no body.
  std::vector<double> divergence_by_bodies(const Particles<dim>& particles,
                                           const std::vector<Vec<dim>>& velocity,
                                           const CellGrid<dim>& grid) const;

  /// The right-hand side of a source alone, without gravity at walls.
  std::vector<double> rows_of(const std::vector<double>& source) const;

  const Matrix& matrix() const { return A_; }
  const std::vector<double>& right_hand_side() const { return b_; }
  const CellsOfUnknowns& cells() const { return cells_; }
  const std::vector<std::int32_t>& unknowns() const { return place_; }  ///< place of each unknown's particle

 private:
  /// A vector for each unknown, coordinate by coordinate, and room for whole lanes.
  using Lines = std::array<std::vector<double>, dim>;

  /// Data shared by the rows of one assembly.
  struct Assembly {
    const Particles<dim>& particles;
    const CellGrid<dim>& grid;
    const std::vector<Vec<dim>>& areas;
    int reach;  ///< cells to each side that a row looks at
  };

  /// Kinds of particles within the radius of an unknown, beside water: one bit each.
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
  std::vector<std::int32_t> place_;  // place of each unknown
  std::vector<std::int32_t> rank_;   // unknowns in lower places than this one, for each place and the end
  std::vector<std::int32_t> other_;  // places of the particles that are no unknowns
  std::vector<std::int32_t> wet_;  // unknowns on bodies that are numbered lower, for each unknown and the end
  std::vector<std::int32_t> face_;  // the same of unknowns on walls and bodies
  Lines x_;                         // positions of the unknowns
};

}  // namespace cosurge::fluid
