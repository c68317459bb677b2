// The boxes of a case, with their keys.
#pragma once

#include "common/case/case_rules.hpp"

namespace cosurge {

/// A box of the case, with its key.
struct NamedBox {
  std::string key;
  v1::Box box;
  bool unscaled_outline = false;  // it is the box around an outline as it is in its file
};

/// A shape, or the box around its outline.
NamedBox named_box(const std::string& key, const v1::Shape& shape, int dimension);

/// Box of each body, or of its outline.
std::vector<NamedBox> body_bounds(const v1::Solid& solid, int dimension);

/// Bodies, regions of water and obstacles that are boxes.
std::vector<NamedBox> body_boxes(const v1::Solid& solid);
std::vector<NamedBox> water_boxes(const v1::Fluid& fluid);
std::vector<NamedBox> obstacle_boxes(const v1::Fluid& fluid);

/// @param margin by which boxes may overlap, or lie outside the other box [m]
bool overlap(const v1::Box& a, const v1::Box& b, double margin);
bool inside(const v1::Box& inner, const v1::Box& outer, double margin);

/// Whether min < max in all coordinates of all boxes.
bool check_boxes_ordered(const std::vector<NamedBox>& boxes, CaseErrors& errors);

}  // namespace cosurge
