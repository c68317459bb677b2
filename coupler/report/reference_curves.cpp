#include "coupler/report/reference_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

#include "common/case/probe_columns.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::optional<double> number(const std::string& text) {
  const std::string digits = trimmed(text);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// "walhorn_2005" is "Walhorn 2005".
std::string title_of(const fs::path& file) {
  std::string name = file.stem().string();
  bool start = true;
  for (char& letter : name) {
    if (letter == '_') letter = ' ';
    if (start) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    start = letter == ' ';
  }
  return name;
}

/// Histories of the case that a column of a table is for.
std::vector<std::string> histories_of(const std::string& column, const v1::Case& the_case) {
  std::vector<std::string> names;
  for (const v1::Probe& probe : the_case.output().probe())
    for (const std::string& own : probe_columns(probe, the_case.dimension())) {
      const bool moves = probe.quantity() == v1::Probe::displacement;
      const bool any = moves && column == fmt::format("u{}_m", own.back());
      const std::string unit = probe.quantity() == v1::Probe::pressure ? "Pa"
                               : probe.quantity() == v1::Probe::force  ? "N"
                                                                       : "m";
      if (any || column == fmt::format("{}_{}", own, unit)) names.push_back(probe_group(probe) + "/" + own);
    }
  return names;
}

Json curve(const std::string& column, const fs::path& path, std::ifstream& file) {
  Json out = {
      {"column", column}, {"name", title_of(path)}, {"time", Json::array()}, {"values", Json::array()}};
  int line = 1;
  for (std::string text; std::getline(file, text);) {
    ++line;
    if (trimmed(text).empty()) continue;
    const auto comma = text.find(',');
    const auto time = number(text.substr(0, comma));
    const auto value = comma == std::string::npos ? std::nullopt : number(text.substr(comma + 1));
    if (!time || !value) {
      out["error"] = fmt::format("{}:{}: \"{}\" is not two numbers with a comma between them", path.string(),
                                 line, trimmed(text));
      break;
    }
    out["time"].push_back(*time);
    out["values"].push_back(*value);
  }
  return out;
}

}  // namespace

Json reference_curves(const fs::path& case_folder, const v1::Case& the_case) {
  Json curves = Json::array();
  std::vector<fs::path> tables;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(case_folder / "reference", none))
    if (entry.path().extension() == ".csv") tables.push_back(entry.path());
  std::sort(tables.begin(), tables.end());
  for (const fs::path& path : tables) {
    std::ifstream file(path);
    std::string header;
    std::getline(file, header);
    const auto comma = header.find(',');
    if (comma == std::string::npos || trimmed(header.substr(0, comma)) != "t_s") continue;
    for (const std::string& name : histories_of(trimmed(header.substr(comma + 1)), the_case)) {
      std::ifstream again(path);
      std::getline(again, header);
      curves.push_back(curve(name, path, again));
    }
  }
  return curves;
}

}  // namespace cosurge
