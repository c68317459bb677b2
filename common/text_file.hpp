// Text files as editors and spreadsheets save them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosurge {

/// All bytes of a file. @throws Error when there is no such file, or it cannot be read.
std::string file_contents(const std::filesystem::path& file);

/// UTF-8 without the mark EF BB BF that some programs put in front.
/// @throws Error naming `file` when the bytes begin with the mark of UTF-16 or UTF-32.
std::string without_byte_order_mark(std::string bytes, const std::filesystem::path& file);

/// The lines of a text without their ends: LF, CR LF, or CR.
std::vector<std::string> lines_of(const std::string& text);

/// The first characters of a text, for a message that quotes it.
std::string clipped(const std::string& text, std::size_t most = 40);

}  // namespace cosurge
