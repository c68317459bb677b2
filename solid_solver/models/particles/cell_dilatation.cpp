#include "solid_solver/models/particles/cell_dilatation.hpp"

#include <algorithm>

namespace cosurge::particles {

double lambda_of_particles(const Elasticity& material) {
  constexpr double most = 4;  // mu
  return std::min(material.lambda(), most * material.mu());
}

template <int dim>
CellDilatation<dim>::CellDilatation(const BodyGrid<dim>& grid, const Slots& members, double spacing,
                                    const Elasticity& material)
    : first_(grid.first_slot()),
      last_(grid.last_slot()),
      over_edges_(1 / (diagonals * spacing)),
      stiffness_(Slots::Zero(grid.slots())),
      dilatation_(stiffness_) {
  for (int m = 0; m < diagonals; ++m) {
    SiteIndex<dim> to;
    for (int k = 0; k < dim; ++k) {
      to[k] = k == 0 || (m >> (k - 1) & 1) != 0 ? 1 : 0;
      diagonals_[m].along[k] = to[k] != 0 ? 1 : -1;
    }
    diagonals_[m].to = grid.shift(to);
    diagonals_[m].from = grid.shift(SiteIndex<dim>::Ones() - to);
    pull_[m].fill(stiffness_);
  }
  share_volumes(grid, members);
  stiffness_ *= (material.lambda() - lambda_of_particles(material)) / material.density;
}

template <int dim>
void CellDilatation<dim>::share_volumes(const BodyGrid<dim>& grid, const Slots& members) {
  std::vector<Eigen::Index> cells;
  Slots around = Slots::Zero(grid.slots());  // cells of a particle
  const auto corners = [&](Eigen::Index i, const auto& visit) {
    for (const Diagonal& d : diagonals_) {
      visit(i + d.from);
      visit(i + d.to);
    }
  };
  for (Eigen::Index i = first_; i < last_; ++i) {
    bool whole = true;
    corners(i, [&](Eigen::Index corner) { whole = whole && members[corner] != 0; });
    if (!whole) continue;
    cells.push_back(i);
    corners(i, [&](Eigen::Index corner) { around[corner] += 1; });
  }
  for (const Eigen::Index i : cells)
    corners(i, [&](Eigen::Index corner) { stiffness_[i] += 1 / around[corner]; });
}

template <int dim>
typename CellDilatation<dim>::Gradient CellDilatation<dim>::gradient(const Vectors& u, Eigen::Index i) const {
  Gradient H;
  for (int a = 0; a < dim; ++a) {
    for (Lanes& component : H[a]) component.setZero();
    for (const Diagonal& d : diagonals_) {
      const Lanes apart = over_edges_ * (at(u[a], i + d.to) - at(u[a], i + d.from));
      for (int k = 0; k < dim; ++k) H[a][k] += d.along[k] * apart;
    }
  }
  return H;
}

template <int dim>
void CellDilatation<dim>::measure(const Vectors& u, const Vectors& v, double retardation) const {
  for (Eigen::Index i = first_; i < last_; i += BodyGrid<dim>::lanes) {
    Gradient H = gradient(u, i), later = H;
    if (retardation > 0) {
      const Gradient rate = gradient(v, i);
      for (int a = 0; a < dim; ++a)
        for (int k = 0; k < dim; ++k) later[a][k] += retardation * rate[a][k];
    }
    Lanes theta = Lanes::Zero();
    for (int a = 0; a < dim; ++a) {
      theta += later[a][a];
      for (int k = 0; k < dim; ++k) theta += 0.5 * later[a][k] * later[a][k];
      H[a][a] += 1;
    }
    at(dilatation_, i) = theta;
    const Lanes pressure = over_edges_ * at(stiffness_, i) * theta;
    for (int m = 0; m < diagonals; ++m) {
      for (int a = 0; a < dim; ++a) {
        Lanes stretched = diagonals_[m].along[0] * H[a][0];
        for (int k = 1; k < dim; ++k) stretched += diagonals_[m].along[k] * H[a][k];
        at(pull_[m][a], i) = pressure * stretched;
      }
    }
  }
}

template <int dim>
LaneVec<dim> CellDilatation<dim>::acceleration(Eigen::Index i) const {
  LaneVec<dim> sum;
  for (int a = 0; a < dim; ++a) {
    sum[a].setZero();
    for (int m = 0; m < diagonals; ++m)
      sum[a] += at(pull_[m][a], i - diagonals_[m].from) - at(pull_[m][a], i - diagonals_[m].to);
  }
  return sum;
}

template class CellDilatation<2>;
template class CellDilatation<3>;

}  // namespace cosurge::particles
