#include "solid_solver/models/relocated_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/shape.hpp"

namespace cosurge {
namespace {

constexpr double far = 100;  // times the extent of all bodies: two of a double's 16 digits

using Coordinates = google::protobuf::RepeatedField<double>;

void subtract(const std::vector<double>& origin, Coordinates& values) {
  for (int k = 0; k < values.size(); ++k) values[k] -= origin[static_cast<std::size_t>(k) % origin.size()];
}

template <typename Corners>
void subtract_corners(const std::vector<double>& origin, Corners& box) {
  subtract(origin, *box.mutable_min());
  subtract(origin, *box.mutable_max());
}

void subtract(const std::vector<double>& origin, v1::Shape& shape) {
  subtract_corners(origin, shape);
  subtract(origin, *shape.mutable_vertex());
}

template <int dim>
Box<dim> bounds_of_bodies(const v1::Solid& solid) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box<dim> all(Vec<dim>::Constant(infinite), Vec<dim>::Constant(-infinite));
  for (const v1::Body& body : solid.body()) {
    const Shape<dim> shape(shape_of(body));
    all.min = all.min.cwiseMin(shape.bounds().min);
    all.max = all.max.cwiseMax(shape.bounds().max);
  }
  return all;
}

template <int dim>
std::vector<double> origin_of(const v1::Solid& solid, double spacing) {
  const Box<dim> all = bounds_of_bodies<dim>(solid);
  const Vec<dim> middle = 0.5 * (all.min + all.max);
  if (middle.norm() <= far * (all.max - all.min).maxCoeff()) return {};
  std::vector<double> origin;
  for (const double x : middle) origin.push_back(spacing * std::round(x / spacing));
  return origin;
}

}  // namespace

std::vector<double> origin_near_bodies(const v1::Case& the_case, double spacing) {
  return the_case.dimension() == 2 ? origin_of<2>(the_case.solid(), spacing)
                                   : origin_of<3>(the_case.solid(), spacing);
}

v1::Case relocated(const v1::Case& the_case, const std::vector<double>& origin) {
  v1::Case moved = the_case;
  v1::Solid& solid = *moved.mutable_solid();
  for (v1::Body& body : *solid.mutable_body()) {
    if (body.has_box()) subtract_corners(origin, *body.mutable_box());
    if (body.has_shape()) subtract(origin, *body.mutable_shape());
    for (v1::Shape& clamp : *body.mutable_clamp()) subtract(origin, clamp);
    for (v1::Support& support : *body.mutable_support()) subtract_corners(origin, *support.mutable_box());
  }
  if (solid.has_sprung()) subtract(origin, *solid.mutable_sprung()->mutable_pivot());
  return moved;
}

RelocatedModel::RelocatedModel(std::unique_ptr<SolidModel> model, const std::vector<double>& origin)
    : WrappedModel(std::move(model)), origin_(origin) {}

Interpolation RelocatedModel::interpolation(const Field& position, const std::vector<int>& body) const {
  const Eigen::Map<const Eigen::VectorXd> origin(origin_.data(), static_cast<Eigen::Index>(origin_.size()));
  return saying_origin(origin_, [&] { return model_->interpolation(position.colwise() - origin, body); });
}

int RelocatedModel::advance(const Window& window, const NodalLoad& load) {
  return saying_origin(origin_, [&] { return model_->advance(window, load); });
}

NodeLayout RelocatedModel::layout() const {
  NodeLayout layout = model_->layout();
  layout.position.colwise() += Eigen::Map<const Eigen::VectorXd>(origin_.data(), layout.position.rows());
  return layout;
}

Snapshot RelocatedModel::frame() const {
  Snapshot arrays = model_->frame();
  for (Array& array : arrays) {
    if (array.name != "solid_position") continue;
    for (std::size_t k = 0; k < array.values.size(); ++k)
      array.values[k] = static_cast<float>(array.values[k] + origin_[k % origin_.size()]);
  }
  return arrays;
}

}  // namespace cosurge
