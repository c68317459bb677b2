#include "solid_solver/models/rigid/rigid_model.hpp"

#include "common/error.hpp"
#include "common/geometry/body_sites.hpp"
#include "common/state_bytes.hpp"

namespace cosurge {

template <int dim>
RigidModel<dim>::RigidModel(const Structure<dim>& structure) {
  for (const Body<dim>& body : structure.bodies) {
    const BodySites<dim> sites(body.shape, structure.spacing);
    for (const Vec<dim>& x : sites.all()) {
      for (int k = 0; k < dim; ++k) positions_.push_back(static_cast<float>(x[k]));
      particle_body_.push_back(static_cast<int>(bodies()));
    }
    bounds_.push_back(body.shape.bounds());
  }
}

template <int dim>
Interpolation RigidModel<dim>::interpolation(const Field& position, const std::vector<int>& body) const {
  Interpolation H(position.cols(), nodes());
  for (Eigen::Index point = 0; point < position.cols(); ++point) {
    const int b = body[static_cast<std::size_t>(point)];
    require(b >= 0 && b < bodies(), "solid: the interface has a point of body {}, but there are {} bodies", b,
            bodies());
    const auto own = static_cast<std::size_t>(b);
    const Vec<dim> way = (Vec<dim>(position.col(point)) - middle(own)) / length(own);
    H.insert(point, b * per_body) = 1 - way.sum();
    for (int k = 0; k < dim; ++k) H.insert(point, b * per_body + 1 + k) = way[k];
  }
  return H;
}

template <int dim>
int RigidModel<dim>::advance(const Window&, const NodalLoad& load) {
  total_load_ = load.last.rowwise().sum();
  return 0;
}

template <int dim>
NodeLayout RigidModel<dim>::layout() const {
  NodeLayout layout{.position = Field(dim, nodes()), .body = {}, .particle_body = particle_body_};
  for (std::size_t b = 0; b < bounds_.size(); ++b) {
    const auto first = static_cast<Eigen::Index>(b) * per_body;
    layout.position.middleCols(first, per_body) = middle(b).replicate(1, per_body);
    for (int k = 0; k < dim; ++k) layout.position(k, first + 1 + k) += length(b);
    layout.body.insert(layout.body.end(), per_body, static_cast<int>(b));
  }
  return layout;
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
