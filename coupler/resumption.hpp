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

/// The run in a folder with values in place of those of its case. It says what it changes, and in what the
/// case file differs from the case of the run by now.
/// @throws Error, and nothing is written: where the run is finished and nothing makes it longer, where a
/// value must not change, or where the new case is not valid.
Resumption resumption_of(const std::filesystem::path& folder, const std::vector<std::string>& overrides);

}  // namespace cosurge
