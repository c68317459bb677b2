#include "common/case/bodies.hpp"

#include "common/case/from_case.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr double on_the_face = 1e-9;  // [m] tolerance: points on a face count as inside

template <int dim>
int first_body_at(const v1::Solid& solid, const Vec<dim>& x) {
  for (int b = 0; b < solid.body_size(); ++b)
    if (from_case<dim>(shape_of(solid.body(b))).outside(x) <= on_the_face) return b;
  return -1;
}

}  // namespace

v1::Shape shape_of(const v1::Box& box) {
  v1::Shape shape;
  *shape.mutable_min() = box.min();
  *shape.mutable_max() = box.max();
  return shape;
}

v1::Shape shape_of(const v1::Body& body) { return body.has_shape() ? body.shape() : shape_of(body.box()); }

int body_at(const v1::Solid& solid, const google::protobuf::RepeatedField<double>& position) {
  return position.size() == 2 ? first_body_at<2>(solid, from_case<2>(position))
                              : first_body_at<3>(solid, from_case<3>(position));
}

double solid_spacing(const v1::Case& the_case) {
  if (the_case.solid().has_spacing()) return the_case.solid().spacing();
  require(the_case.has_fluid(), "solid.spacing: missing, and there is no fluid to take it from");
  return the_case.fluid().spacing();
}

}  // namespace cosurge
