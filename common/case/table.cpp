#include "common/case/table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "common/error.hpp"
#include "common/text_file.hpp"

namespace cosurge {
namespace {

constexpr const char* blanks = " \t\v\f";

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

struct Cell {
  std::string text;
  bool quoted = false;
};

/// A line that is not empty, and its separator: ';', '\t', ',' or ' '.
struct Line {
  int number;
  char separator;
  std::vector<Cell> cells;
};

/// The separator of a line: the first of semicolon, tab and comma that it has outside of quotes, else
/// blanks. Tabs beside a comma are blanks.
char separator_of(const std::string& text) {
  bool quoted = false, semicolon = false, tab = false, comma = false;
  char before = 0;  // the last non-blank character
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    const auto next = text.find_first_not_of(blanks, k);
    semicolon = semicolon || c == ';';
    comma = comma || c == ',';
    tab = tab || (c == '\t' && before != ',' && next != std::string::npos && text[next] != ',');
    if (c != ' ' && c != '\t') before = c;
  }
  return semicolon ? ';' : tab ? '\t' : comma ? ',' : ' ';
}

std::vector<Cell> cells_of(const std::string& text, char separator) {
  std::vector<Cell> cells(1);
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') {
      quoted = !quoted;
      cells.back().quoted = true;
    } else if (!quoted && (c == separator || (separator == ' ' && c == '\t'))) {
      cells.emplace_back();
    } else {
      cells.back().text += c;
    }
  }
  for (Cell& cell : cells) cell.text = trimmed(cell.text);
  const auto empty = [](const Cell& cell) { return cell.text.empty(); };
  if (separator == ' ') std::erase_if(cells, empty);
  while (!cells.empty() && empty(cells.back())) cells.pop_back();
  return cells;
}

/// The lines that have cells. If one line has semicolons, semicolons separate the cells of all lines;
/// otherwise tabs separate the cells of lines with commas, because such a comma is part of a number.
std::vector<Line> filled_lines(const std::string& text) {
  std::vector<std::pair<int, std::string>> lines;
  std::string separators;
  int number = 0;
  for (std::string line : lines_of(text)) {
    ++number;
    line = trimmed(line.substr(0, line.find('#')));
    const bool empty = line.find_first_not_of(",;\" \t") == std::string::npos;
    if (empty || lower(line).starts_with("sep=")) continue;
    lines.emplace_back(number, line);
    separators += separator_of(line);
  }
  const bool semicolons = separators.find(';') != std::string::npos;
  const bool tabs = separators.find('\t') != std::string::npos;
  std::vector<Line> filled;
  for (const auto& [at, line] : lines) {
    char separator = separator_of(line);
    if (semicolons) separator = ';';
    if (separator == ',' && tabs) separator = '\t';
    std::vector<Cell> cells = cells_of(line, separator);
    if (!cells.empty()) filled.push_back({at, separator, std::move(cells)});
  }
  return filled;
}

/// The number that a text is, with a decimal point; too small ones are 0.
std::optional<double> number(const std::string& text) {
  const std::string plain = text.starts_with("+") ? text.substr(1) : text;
  double value = 0;
  const char* end = plain.data() + plain.size();
  const auto [stop, error] = std::from_chars(plain.data(), end, value);
  if (stop != end || plain.empty() || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::strtod(plain.c_str(), nullptr);
  return value;
}

std::string with_point(std::string text) {
  if (std::count(text.begin(), text.end(), ',') == 1) std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

bool looks_like_a_number(const Cell& cell) { return number(with_point(cell.text)).has_value(); }

/// Digits with a leading zero: decimals after a decimal comma, not a number.
bool has_needless_zero(const std::string& text) {
  const std::string digits = text.starts_with("-") || text.starts_with("+") ? text.substr(1) : text;
  return digits.size() > 1 && digits.front() == '0' &&
         digits.find_first_not_of("0123456789") == std::string::npos;
}

/// Whether a comma may as well part thousands: "1,234".
bool may_be_thousands(const std::string& text) {
  const std::string digits = text.starts_with("-") || text.starts_with("+") ? text.substr(1) : text;
  const auto comma = digits.find(',');
  return comma != std::string::npos && comma >= 1 && comma <= 3 && digits.front() != '0' &&
         digits.size() == comma + 4 && digits.find('.') == std::string::npos;
}

/// "angle [rad]" -> name and unit, in small letters; the unit may stand in brackets of any kind.
TableColumn header_column(const std::string& text) {
  const std::string words = lower(text);
  const auto open = words.find_first_of("[(");
  if (open == std::string::npos) return {trimmed(words), ""};
  const auto close = words.find_first_of("])", open);
  return {trimmed(words.substr(0, open)),
          trimmed(words.substr(open + 1, close == std::string::npos ? close : close - open - 1))};
}

bool same_name(const std::string& given, const std::string& wanted) {
  return given == wanted || (wanted == "time" && given == "t");
}

bool same_unit(const std::string& given, const std::string& wanted) {
  const bool degrees = given == "°" || given == "degree" || given == "degrees";
  return given == wanted || (wanted == "deg" && degrees) || (wanted == "s" && given == "sec");
}

/// Reads one table.
class Reader {
 public:
  Reader(const std::filesystem::path& file, const std::vector<TableColumn>& columns)
      : file_(file.string()), columns_(columns), order_(columns.size()) {
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = k;
    std::string text = without_byte_order_mark(file_contents(file), file);
    require(text.find('\0') == std::string::npos, "{}: is no text", file_);
    lines_ = filled_lines(text);
  }

  Table read() {
    std::size_t first = 0;
    while (first < lines_.size() && is_header(lines_[first])) read_header(lines_[first++]);
    lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(first));
    find_decimal_commas();
    Table table;
    for (const Line& line : lines_) add_row(line, table);
    return table;
  }

 private:
  template <typename... Args>
  [[noreturn]] void refuse(const Line& line, fmt::format_string<Args...> message, Args&&... args) const {
    throw Error(
        fmt::format("{}:{}: {}", file_, line.number, fmt::format(message, std::forward<Args>(args)...)));
  }

  std::string expected() const {
    return fmt::format("must be {} numbers: {}", columns_.size(), describe(columns_));
  }

  static bool is_header(const Line& line) {
    return std::none_of(line.cells.begin(), line.cells.end(), looks_like_a_number) &&
           std::any_of(line.cells.begin(), line.cells.end(), [](const Cell& cell) {
             return !cell.text.empty() && std::isdigit(static_cast<unsigned char>(cell.text.front())) == 0;
           });
  }

  /// Names in their order, or units below the names.
  void read_header(const Line& line) {
    std::vector<TableColumn> given;
    for (const Cell& cell : line.cells) given.push_back(header_column(cell.text));
    std::vector<std::size_t> order;
    for (const TableColumn& column : columns_)
      for (std::size_t k = 0; k < given.size(); ++k)
        if (same_name(given[k].name, column.name)) order.push_back(k);
    const bool all_names = order.size() == columns_.size() && given.size() == columns_.size();
    if (all_names) order_ = order;
    if (!order.empty() && !all_names && line.separator != ' ')
      refuse(line, "{}; the header has the columns {}", expected(), names(given));
    for (std::size_t c = 0; c < columns_.size() && given.size() == columns_.size(); ++c)
      check_unit(line, given[order_[c]], columns_[c]);
  }

  static std::string names(const std::vector<TableColumn>& given) {
    std::vector<std::string> all;
    for (const TableColumn& column : given) all.push_back(column.name);
    return clipped(fmt::format("{}", fmt::join(all, ", ")), 200);
  }

  void check_unit(const Line& line, const TableColumn& given, const TableColumn& wanted) const {
    // A line of units alone has them without brackets, or nothing in front of them.
    static const std::vector<std::string> units = {"s",  "ms",  "min", "m", "mm",     "cm",
                                                   "in", "rad", "deg", "°", "degree", "degrees"};
    const bool bare = std::find(units.begin(), units.end(), given.name) != units.end() && given.unit.empty();
    const std::string unit = bare && !same_name(given.name, wanted.name) ? given.name : given.unit;
    if (!unit.empty() && !wanted.unit.empty() && !same_unit(unit, wanted.unit))
      refuse(line, "{} is in {}, must be in {}", wanted.name, clipped(unit), wanted.unit);
  }

  /// Decimal commas need one number that cannot be anything else.
  void find_decimal_commas() {
    bool shown = false;
    const Line* doubtful = nullptr;
    std::string doubt;
    for (const Line& line : lines_) {
      for (const Cell& cell : line.cells) {
        if (!may_have_comma(line, cell) || cell.text.find(',') == std::string::npos) continue;
        if (!may_be_thousands(cell.text)) {
          shown = true;
        } else if (doubtful == nullptr) {
          doubtful = &line;
          doubt = cell.text;
        }
      }
    }
    if (doubtful != nullptr && !shown)
      refuse(*doubtful, "\"{}\" can mean {} or {}; write numbers with a decimal point", doubt,
             with_point(doubt), without_comma(doubt));
  }

  static std::string without_comma(std::string text) {
    std::erase(text, ',');
    return text;
  }

  static bool may_have_comma(const Line& line, const Cell& cell) {
    return line.separator == ';' || cell.quoted;
  }

  void add_row(const Line& line, Table& table) const {
    std::vector<double> row;
    for (const Cell& cell : line.cells) row.push_back(value(line, cell));
    if (row.size() != columns_.size())
      refuse(line, "{}; this line has {}{}", expected(), row.size(),
             line.separator == ',' && row.size() == 2 * columns_.size()
                 ? " (separate numbers with decimal commas by semicolons)"
                 : "");
    for (const std::size_t k : order_) table.values.push_back(row[k]);
    table.lines.push_back(line.number);
  }

  double value(const Line& line, const Cell& cell) const {
    const bool comma = cell.text.find(',') != std::string::npos;
    const char* remedy = "write numbers with a decimal point, or separate them by semicolons";
    if (comma && !may_have_comma(line, cell))
      refuse(line, "{}; \"{}\" has a comma, but {} separate the numbers: {}", expected(), clipped(cell.text),
             line.separator == '\t' ? "tabs" : "blanks", remedy);
    if (line.separator == ',' && has_needless_zero(cell.text))
      refuse(line, "{}; \"{}\" looks like the end of a number with a decimal comma: {}", expected(),
             clipped(cell.text), remedy);
    const auto read = number(comma ? with_point(cell.text) : cell.text);
    if (!read && cell.text.empty()) refuse(line, "{}; one is missing", expected());
    if (!read) refuse(line, "{}; \"{}\" is not a number", expected(), clipped(cell.text));
    if (!std::isfinite(*read)) refuse(line, "{}; {} is not finite", expected(), clipped(cell.text));
    return *read;
  }

  std::string file_;
  std::vector<TableColumn> columns_;
  std::vector<std::size_t> order_;  // cell of each column
  std::vector<Line> lines_;
};

}  // namespace

std::string describe(const std::vector<TableColumn>& columns) {
  std::vector<std::string> all;
  for (const TableColumn& column : columns)
    all.push_back(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
  return fmt::format("{}", fmt::join(all, ", "));
}

Table read_table(const std::filesystem::path& file, const std::vector<TableColumn>& columns) {
  return Reader(file, columns).read();
}

}  // namespace cosurge
