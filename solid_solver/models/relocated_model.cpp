#include "solid_solver/models/relocated_model.hpp"

#include <cmath>
#include <limits>

namespace cosurge {
namespace {

constexpr double far = 100;  // times the extent of all bodies: loses two of a double's 16 digits

template <int dim>
Box<dim> bounds_of_bodies(const Structure<dim>& structure) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box<dim> all(Vec<dim>::Constant(infinite), Vec<dim>::Constant(-infinite));
  for (const Body<dim>& body : structure.bodies) {
    all.min = all.min.cwiseMin(body.shape.bounds().min);
    all.max = all.max.cwiseMax(body.shape.bounds().max);
  }
  return all;
}

}  // namespace

template <int dim>
std::optional<Vec<dim>> origin_near_bodies(const Structure<dim>& structure) {
  const Box<dim> all = bounds_of_bodies(structure);
  const Vec<dim> middle = 0.5 * (all.min + all.max);
  if (middle.norm() <= far * (all.max - all.min).maxCoeff()) return std::nullopt;
  Vec<dim> origin;
  for (int k = 0; k < dim; ++k) origin[k] = structure.spacing * std::round(middle[k] / structure.spacing);
  return origin;
}

template <int dim>
Structure<dim> relocated(const Structure<dim>& structure, const Vec<dim>& origin) {
  Structure<dim> moved = structure;
  for (Body<dim>& body : moved.bodies) {
    body.shape = body.shape.moved(-origin);
    for (Shape<dim>& clamp : body.clamps) clamp = clamp.moved(-origin);
    for (Support<dim>& support : body.supports)
      support.box = {support.box.min - origin, support.box.max - origin};
  }
  if (auto* sprung = std::get_if<SprungParameters<dim>>(&moved.model); sprung != nullptr && sprung->pivot)
    *sprung->pivot -= origin;
  return moved;
}

RelocatedModel::RelocatedModel(std::unique_ptr<SolidModel> model, const Eigen::VectorXd& origin)
    : WrappedModel(std::move(model)), origin_(origin) {}

Interpolation RelocatedModel::interpolation(const Field& position, const std::vector<int>& body) const {
  return saying_origin(origin_, [&] { return model_->interpolation(position.colwise() - origin_, body); });
}

int RelocatedModel::advance(const Window& window, const NodalLoad& load) {
  return saying_origin(origin_, [&] { return model_->advance(window, load); });
}

NodeLayout RelocatedModel::layout() const {
  NodeLayout layout = model_->layout();
  layout.position.colwise() += origin_;
  return layout;
}

Snapshot RelocatedModel::frame() const {
  Snapshot arrays = model_->frame();
  for (Array& array : arrays) {
    if (array.name != "solid_position") continue;
    const auto dimension = static_cast<std::size_t>(origin_.size());
    for (std::size_t k = 0; k < array.values.size(); ++k)
      array.values[k] =
          static_cast<float>(array.values[k] + origin_[static_cast<Eigen::Index>(k % dimension)]);
  }
  return arrays;
}

template std::optional<Vec<2>> origin_near_bodies<2>(const Structure<2>&);
template std::optional<Vec<3>> origin_near_bodies<3>(const Structure<3>&);
template Structure<2> relocated<2>(const Structure<2>&, const Vec<2>&);
template Structure<3> relocated<3>(const Structure<3>&, const Vec<3>&);

}  // namespace cosurge
