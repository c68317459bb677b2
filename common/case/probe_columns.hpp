// The columns that probes make in the results, and those that the results have of their own.
#pragma once

#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// The solver that writes the columns of a probe: "fluid", or "solid" for displacements.
std::string probe_group(const v1::Probe& probe);

/// Names of its columns: a vector has one for each direction ("tip_x"). A moment
/// in two dimensions is no vector.
std::vector<std::string> probe_columns(const v1::Probe& probe, int dimension);

/// Whether the solver of this group has a column of this name without any probe, among those that a probe's
/// column could be.
bool is_own_column(const std::string& group, const std::string& name);

}  // namespace cosurge
