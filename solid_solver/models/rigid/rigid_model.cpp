#include "solid_solver/models/rigid/rigid_model.hpp"

#include "common/body_sites.hpp"
#include "common/error.hpp"
#include "common/state_bytes.hpp"

namespace cosurge {

template <int dim>
RigidModel<dim>::RigidModel(const v1::Solid& solid, double spacing) : bodies_(solid.body_size()) {
  for (const v1::Body& body : solid.body()) {
    const BodySites<dim> sites(body, spacing);
    for (const Vec<dim>& x : sites.all())
      for (int k = 0; k < dim; ++k) positions_.push_back(static_cast<float>(x[k]));
  }
}

template <int dim>
Interpolation RigidModel<dim>::interpolation(const Field& position, const std::vector<int>& body) const {
  Interpolation H(position.cols(), bodies_);
  for (Eigen::Index point = 0; point < position.cols(); ++point) {
    const int b = body[static_cast<std::size_t>(point)];
    require(b >= 0 && b < bodies_, "solid: a point of body {}, but there are {}", b, bodies_);
    H.insert(point, b) = 1;
  }
  return H;
}

template <int dim>
int RigidModel<dim>::advance(const Window&, const NodalLoad& load) {
  total_load_ = load.last.rowwise().sum();
  return 0;
}

template <int dim>
std::vector<Column> RigidModel<dim>::columns() const {
  std::vector<Column> columns;
  columns.reserve(dim);
  for (int k = 0; k < dim; ++k) columns.push_back({std::string("load_") + "xyz"[k], "N"});
  return columns;
}

template <int dim>
std::vector<double> RigidModel<dim>::values() const {
  return {total_load_.begin(), total_load_.end()};
}

template <int dim>
std::string RigidModel<dim>::save() const {
  StateWriter state;
  state.put(total_load_);
  return state.take();
}

template <int dim>
void RigidModel<dim>::restore(const std::string& state) {
  StateReader reader(state);
  reader.get(total_load_);
  reader.finish();
}

template <int dim>
Snapshot RigidModel<dim>::frame() const {
  const std::size_t count = positions_.size() / dim;
  return {
      {.name = "solid_position", .unit = "m", .components = dim, .values = positions_},
      {.name = "solid_velocity", .unit = "m/s", .components = dim, .values = std::vector<float>(count * dim)},
      {.name = "solid_von_mises", .unit = "Pa", .components = 1, .values = std::vector<float>(count)}};
}

template class RigidModel<2>;
template class RigidModel<3>;

}  // namespace cosurge
