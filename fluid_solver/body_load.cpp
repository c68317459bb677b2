#include "fluid_solver/body_load.hpp"

namespace cosurge::fluid {

template <int dim>
BodyLoad<dim>::BodyLoad(const Interface& interface, int body, const Vec<dim>& about, double spacing)
    : about_(about) {
  double sum = 0;
  for (Eigen::Index k = 0; k < interface.points(); ++k) {
    if (interface.body[static_cast<std::size_t>(k)] != body) continue;
    point_.push_back(k);
    place_.push_back(interface.position.col(k));
    const Vec<dim> way = interface.position.col(k) - about;
    const double share = (1 - way.array().abs() / spacing).max(0.0).prod();  // linear on the lattice
    if (share > 0) around_.emplace_back(k, share);
    sum += share;
  }
  for (auto& [k, share] : around_) share /= sum;
}

template <int dim>
Load<dim> BodyLoad<dim>::read(const InterfaceMotion& motion, const InterfaceLoad& load) const {
  Vec<dim> about = about_;
  for (const auto& [k, share] : around_) about += share * motion.displacement.col(k);
  Load<dim> sum;
  for (std::size_t m = 0; m < point_.size(); ++m) {
    const Vec<dim> x = place_[m] + motion.displacement.col(point_[m]);
    sum.add(x - about, load.force.col(point_[m]));
  }
  return sum;
}

template class BodyLoad<2>;
template class BodyLoad<3>;

}  // namespace cosurge::fluid
