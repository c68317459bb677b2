// Tables of numbers in text files, in the forms in which spreadsheets save them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosurge {

/// A column of a table: its name, and the unit that its numbers are in ("" where it has none).
struct TableColumn {
  std::string name;
  std::string unit;
};

/// "x [m], y [m]"
std::string describe(const std::vector<TableColumn>& columns);

/// The rows of a table.
struct Table {
  std::vector<double> values;  ///< row by row, in the order of the columns that were asked for
  std::vector<int> lines;      ///< where each row stands, counted from 1
};

/// Reads the rows of a table with exactly these columns.
///
/// - Numbers are parted by commas, semicolons, tabs or blanks. Numbers parted by semicolons may have decimal
///   commas, and so may numbers in quotes: "0,25".
/// - A mark of UTF-8 in front, ends of lines of any system, empty lines and rows of empty cells, empty cells
///   at the end of a row, lines "sep=;" and comments after # are left out.
/// - Lines without a number before the first row are a header. Where a header has the names of all columns
///   (any case, units in brackets), their order is the header's; units other than the columns' are refused.
///
/// Ambiguous text is rejected: numbers separated by tabs or blanks with commas in them, whole
/// numbers with a zero in front ("050", mostly the end of a decimal comma), "1,234" where no other number of
/// the file shows that the comma is decimal.
/// @throws Error "file:line: ..." with the expected content.
Table read_table(const std::filesystem::path& file, const std::vector<TableColumn>& columns);

}  // namespace cosurge
