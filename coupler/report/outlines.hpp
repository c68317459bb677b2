// The parts of a case as lines, for pictures of it.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Tank, water at the start, obstacles, bodies, clamps, supports and probes: [{"kind", "label", "lines",
/// "poses"}]. Lines are polylines of points [m]; a probe's is one point. What moves has a pose for each of
/// `times` [s]: the coordinates of where it has taken the origin, then those of the axes that have turned
/// with it (dimension x dimension, one axis after the other); the others have no "poses".
nlohmann::ordered_json outlines(const v1::Case& the_case, const std::vector<double>& times);

/// What a picture of a case adds before its run: for each wall that moves, its outline at the extremes of its
/// motion until the end of the run ("extreme") and the path of its middle ("path"); of bodies with an outline
/// the stairs that it becomes on the lattice ("stairs", two dimensions).
nlohmann::ordered_json outlines_of_check(const v1::Case& the_case);

}  // namespace cosurge
