#include "coupler/study/quantity.hpp"

#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "common/case/probe_columns.hpp"
#include "common/error.hpp"
#include "coupler/interface_account.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

using Kind = Quantity::Kind;

constexpr std::array<std::pair<const char*, Kind>, 4> kinds = {{{"peak", Kind::peak},
                                                                {"time_of_peak", Kind::time_of_peak},
                                                                {"impulse", Kind::impulse},
                                                                {"rms", Kind::rms}}};

constexpr const char* form =
    "must be peak(H), time_of_peak(H), impulse(H) or rms(H), where H is a probe's column (P01, tip.x), a "
    "column of the results (fluid/front) or the difference of two (left-right); a range of time may follow: "
    "peak(tip.x, 0.1..0.4)";

/// The column of the results that a name means: "solid/tip_x" for "tip.x"; empty if there is none. Only
/// columns that every run of the case writes, whatever its structural model.
std::string column_of(const std::string& name, const v1::Case& the_case) {
  for (const v1::Probe& probe : the_case.output().probe())
    for (const std::string& column : probe_columns(probe, the_case.dimension())) {
      const std::string whole = probe_group(probe) + "/" + column;
      const std::string component = probe.name() + "." + column.back();
      if (name == whole || name == column || (column != probe.name() && name == component)) return whole;
    }
  for (const char* own : {"front", "max_speed", "kinetic_energy", "gravity_energy"})
    if (the_case.has_fluid() && name == std::string("fluid/") + own) return name;
  if (the_case.has_fluid() && the_case.has_solid())
    for (const Column& column : InterfaceAccount::columns(the_case.dimension()))
      if (name == "coupling/" + column.name) return name;
  return "";
}

std::vector<std::string> names_of_probes(const v1::Case& the_case) {
  std::vector<std::string> names;
  for (const v1::Probe& probe : the_case.output().probe())
    for (const std::string& column : probe_columns(probe, the_case.dimension()))
      names.push_back(column == probe.name() ? column : probe.name() + "." + column.back());
  return names;
}

std::vector<std::string> columns_of(const std::string& history, const std::string& text,
                                    const v1::Case& the_case) {
  std::vector<std::string> columns;
  const auto minus = history.find('-');
  std::vector<std::string> names = {history.substr(0, minus)};
  if (minus != std::string::npos) names.push_back(history.substr(minus + 1));
  for (const std::string& name : names) {
    columns.push_back(column_of(name, the_case));
    require(!columns.back().empty(),
            "--quantity {}: the case has no column {}; its probes have {}; other columns are fluid/front, "
            "fluid/max_speed, fluid/kinetic_energy, fluid/gravity_energy and coupling/force_x",
            text, name, fmt::join(names_of_probes(the_case), ", "));
  }
  return columns;
}

TimeRange range_of(const std::string& words, const std::string& text, double end) {
  const auto dots = words.find("..");
  require(dots != std::string::npos, "--quantity {}: {}", text, form);
  const auto number = [&](const std::string& digits) {
    const std::optional<double> value = number_of(digits);
    require(value.has_value(), "--quantity {}: {} is not a time", text, digits);
    return *value;
  };
  const TimeRange range{.from = number(words.substr(0, dots)), .to = number(words.substr(dots + 2))};
  require(range.from >= 0 && range.from < range.to,
          "--quantity {}: a range must be two times FROM..TO, "
          "0 <= FROM < TO",
          text);
  require(range.to <= end * (1 + 1e-9),
          "--quantity {}: the range ends at {:g} s, the run at {:g} s "
          "(time.end)",
          text, range.to, end);
  return range;
}

}  // namespace

Quantity Quantity::read(const std::string& text, const v1::Case& the_case) {
  const std::string plain = without_blanks(text);
  const auto open = plain.find('(');
  require(open != std::string::npos && plain.back() == ')', "--quantity {}: {}", text, form);
  Quantity quantity;
  quantity.text_ = plain;
  const std::string word = plain.substr(0, open);
  const auto* const kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& entry) { return word == entry.first; });
  require(kind != kinds.end(), "--quantity {}: {}", text, form);
  quantity.kind_ = kind->second;
  const std::string inside = plain.substr(open + 1, plain.size() - open - 2);
  const auto comma = inside.find(',');
  quantity.history_ = inside.substr(0, comma);
  quantity.columns_ = columns_of(quantity.history_, text, the_case);
  if (comma != std::string::npos)
    quantity.range_ = range_of(inside.substr(comma + 1), text, the_case.time().end());
  return quantity;
}

std::string Quantity::unit(const std::string& unit) const {
  if (kind_ == Kind::time_of_peak) return "s";
  return kind_ == Kind::impulse ? unit + " s" : unit;
}

double Quantity::value(const Curve& history) const {
  const Curve part = range_ ? cut(history, *range_) : history;
  switch (kind_) {
    case Kind::peak:
      return peak_of(part).value;
    case Kind::time_of_peak:
      return peak_of(part).time;
    case Kind::impulse:
      return integral_of(part);
    case Kind::rms:
      return rms_of(part);
  }
  return 0;
}

}  // namespace cosurge
