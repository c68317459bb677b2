// Rules for outlines, and for the bodies that have one.
#pragma once

#include "common/case/case_rules.hpp"

namespace cosurge {

/// Where a body's shape stands: "solid.body.0.box", "solid.body.0.shape".
std::string body_key(const v1::Solid& solid, int body);

/// Message for an outline with too few corners to enclose anything; empty if it has enough.
std::string too_few_corners(const v1::Shape& outline, int dimension);

/// Whether a polygon crosses itself or goes around twice, or triangles leave a hole, are not all ordered the
/// same way around or are there twice: what to say of it, else nothing.
std::string not_closed(const v1::Shape& outline, int dimension);

/// Bodies with an outline have sites, in one piece, none that another body has, and no parts that overlap.
/// After check_sizes() (common/case/region_rules.hpp).
void check_outlined_bodies(const v1::Case& the_case, CaseErrors& errors);

/// No obstacle, where it is at the start, has a site of a body, whatever the shapes of both.
void check_obstacles(const v1::Case& the_case, CaseErrors& errors);

}  // namespace cosurge
