// Rules for the spacing of a lattice.
#pragma once

#include "common/case/named_boxes.hpp"

namespace cosurge {

constexpr double whole_spacings =
    1e-6;  // [spacings] tolerance for quotients of decimal numbers such as 0.146 / 0.002

/// Whether a length is a whole multiple of the spacing; not zero times, unless it is zero.
bool divides(double spacing, double length);

/// The spacing divides every coordinate of the boxes, and none has more spacings than a computer can hold.
void check_spacing(const std::string& key, double spacing, const std::vector<NamedBox>& boxes,
                   CaseErrors& errors);

}  // namespace cosurge
