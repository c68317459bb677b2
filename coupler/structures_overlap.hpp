// Whether structures that have no contact with each other overlap.
#pragma once

#include <optional>
#include <vector>

#include "common/participant.hpp"

namespace cosurge {

/// Two points of different structures, by their numbers.
struct Overlap {
  Eigen::Index first = 0;
  Eigen::Index second = 0;
};

/// Two points of different structures that are closer to each other than `distance` [m], if there are any.
/// @param places of the points [m]
/// @param structure number of the structure of each point
std::optional<Overlap> find_overlap(const Field& places, const std::vector<int>& structure, double distance);

}  // namespace cosurge
