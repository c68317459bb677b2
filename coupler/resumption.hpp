// Allowed changes of a resumed run, and changes of its case file.
#pragma once

#include <string>
#include <vector>

#include "coupler/checkpoint.hpp"
#include "coupler/provenance.hpp"

namespace cosurge {

/// A resumed run.
struct Resumption {
  Checkpoint checkpoint;  ///< its case is the present one
  bool same_scheme;       ///< whether the coupling scheme is that of the saved state
  Provenance provenance;
};

/// Prepares the run in a folder with changed values. Prints the changes, and the differences between the case
/// file and the present case of the run.
/// @throws Error, and nothing is written: where the run is finished and nothing makes it longer, where a
/// value must not change, or where the new case is not valid.
Resumption resumption_of(const std::filesystem::path& folder, const std::vector<std::string>& overrides);

}  // namespace cosurge
