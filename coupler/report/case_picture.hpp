// A picture of a case before its run.
#pragma once

#include <filesystem>

#include "coupler/coupler.hpp"

namespace cosurge {

/// @throws Error where `file` exists, is no .html or .png, or its folder does not exist.
void require_picture_file(const std::filesystem::path& file);

/// Writes the page with the particles at the start and the outlines of all parts of the case
/// (outlines_of_check()). `participants` are initialized and have not advanced.
void write_case_picture(const std::filesystem::path& file, const v1::Case& the_case,
                        const Participants& participants);

}  // namespace cosurge
