#include "common/case/named_boxes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/case/bodies.hpp"
#include "common/case/outline_rules.hpp"

namespace cosurge {
namespace {

bool is_box(const v1::Shape& shape) { return shape.vertex().empty(); }

}  // namespace

NamedBox named_box(const std::string& key, const v1::Shape& shape, int dimension) {
  NamedBox named{.key = key, .box = {}, .unscaled_outline = shape.vertex_size() > 0 && !shape.has_scale()};
  *named.box.mutable_min() = shape.min();
  *named.box.mutable_max() = shape.max();
  for (int v = 0; v < shape.vertex_size(); ++v) {
    const int k = v % dimension;
    if (v < dimension) {
      named.box.add_min(shape.vertex(v));
      named.box.add_max(shape.vertex(v));
    }
    named.box.set_min(k, std::min(named.box.min(k), shape.vertex(v)));
    named.box.set_max(k, std::max(named.box.max(k), shape.vertex(v)));
  }
  return named;
}

std::vector<NamedBox> body_bounds(const v1::Solid& solid, int dimension) {
  std::vector<NamedBox> bounds;
  for (int i = 0; i < solid.body_size(); ++i)
    bounds.push_back(named_box(body_key(solid, i), shape_of(solid.body(i)), dimension));
  return bounds;
}

std::vector<NamedBox> body_boxes(const v1::Solid& solid) {
  std::vector<NamedBox> boxes;
  for (int i = 0; i < solid.body_size(); ++i)
    if (const v1::Shape shape = shape_of(solid.body(i)); is_box(shape))
      boxes.push_back(named_box(body_key(solid, i), shape, 0));
  return boxes;
}

std::vector<NamedBox> water_boxes(const v1::Fluid& fluid) {
  std::vector<NamedBox> boxes;
  for (int i = 0; i < fluid.water_size(); ++i)
    if (is_box(fluid.water(i)))
      boxes.push_back(named_box(fmt::format("fluid.water.{}", i), fluid.water(i), 0));
  return boxes;
}

std::vector<NamedBox> obstacle_boxes(const v1::Fluid& fluid) {
  std::vector<NamedBox> boxes;
  for (int i = 0; i < fluid.obstacle_size(); ++i)
    if (is_box(fluid.obstacle(i).shape()))
      boxes.push_back(named_box(fmt::format("fluid.obstacle.{}.shape", i), fluid.obstacle(i).shape(), 0));
  return boxes;
}

bool overlap(const v1::Box& a, const v1::Box& b, double margin) {
  for (int k = 0; k < a.min_size(); ++k)
    if (a.max(k) <= b.min(k) + margin || b.max(k) <= a.min(k) + margin) return false;
  return true;
}

bool inside(const v1::Box& inner, const v1::Box& outer, double margin) {
  for (int k = 0; k < inner.min_size(); ++k)
    if (inner.min(k) < outer.min(k) - margin || inner.max(k) > outer.max(k) + margin) return false;
  return true;
}

bool check_boxes_ordered(const std::vector<NamedBox>& boxes, CaseErrors& errors) {
  bool ok = true;
  for (const NamedBox& named : boxes) {
    for (int k = 0; k < named.box.min_size(); ++k) {
      if (named.box.min(k) < named.box.max(k)) continue;
      errors.add(named.key, fmt::format("min {} must be < max {} in coordinate {}", named.box.min(k),
                                        named.box.max(k), k));
      ok = false;
    }
  }
  return ok;
}

}  // namespace cosurge
