#include "coupler/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double terminal_interval = 0.2;  // s between two states of the line
constexpr double plain_interval = 5;       // s between two lines

std::string clock_text(double seconds) {
  const long whole = std::lround(seconds);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(const v1::Case& the_case, const std::vector<Member>& members,
                   const std::vector<Column>& columns, std::FILE* out)
    : end_(the_case.time().end()), columns_(columns), out_(out), terminal_(isatty(fileno(out)) != 0) {
  find(members, "fluid", "ppe_iterations", "ppe");
  find(members, "fluid", "max_speed", "speed");
  find(members, "solid", "substeps", "substeps");
  for (const v1::Probe& probe : the_case.output().probe())
    if (probe.quantity() == v1::Probe::displacement)
      find(members, "solid", probe.name() + "_x", probe.name(),
           static_cast<std::size_t>(the_case.dimension()));
}

Progress::~Progress() {
  if (terminal_) std::fputc('\n', out_);
}

void Progress::find(const std::vector<Member>& members, const std::string& member, const std::string& column,
                    const std::string& label, std::size_t components) {
  for (std::size_t m = 0; m < members.size(); ++m) {
    const auto& columns = members[m].setup.columns;
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (members[m].name == member && columns[c].name == column)
        quantities_.push_back(
            {.label = label, .unit = columns[c].unit, .member = m, .column = c, .components = components});
  }
}

void Progress::window(const Window& window, const Reports& reports, const std::vector<double>& coupling) {
  tell_notes(reports);
  const auto now = Clock::now();
  ++unshown_;
  const double time = window.start + window.size;
  const bool last = time >= end_;
  if (Seconds(now - shown_).count() < (terminal_ ? terminal_interval : plain_interval) && !last) return;
  const double elapsed = Seconds(now - start_).count();
  told_ += unshown_;
  // Schemes that may go back tell several windows at once: the last line has the mean of the whole run.
  const double each = last ? elapsed / told_ : Seconds(now - shown_).count() / unshown_;
  unshown_ = 0;
  shown_ = now;
  std::string line =
      fmt::format("t {:.4f}/{:g} s  window {}  dt {:.2e} s", time, end_, window.index + 1, window.size);
  for (const Quantity& q : quantities_) {
    const std::vector<double>& values = reports[q.member].values;
    double value = values[q.column];
    if (q.components > 1)
      value = Eigen::Map<const Eigen::VectorXd>(&values[q.column], static_cast<Eigen::Index>(q.components))
                  .norm();
    line += q.unit == "-"   ? fmt::format("  {} {:.0f}", q.label, value)
            : q.unit == "m" ? fmt::format("  {} {:.2f} mm", q.label, 1e3 * value)
                            : fmt::format("  {} {:.2f} {}", q.label, value, q.unit);
  }
  if (reports.size() > 1) line += coupling_text(coupling);
  line += fmt::format("  {:.1f} ms/window  {} left", 1e3 * each, clock_text(elapsed * (end_ - time) / time));
  line = printable(line);
  std::fputs((terminal_ ? "\r\x1b[K" + line : line + "\n").c_str(), out_);
  std::fflush(out_);
}

/// On lines of their own, also where the progress line is not due.
void Progress::tell_notes(const Reports& reports) {
  for (const Report& report : reports)
    for (const std::string& note : report.notes)
      std::fputs(((terminal_ ? "\r\x1b[K" : "") + printable(note) + "\n").c_str(), out_);
}

/// Work at the interface, iterations and added-mass ratio.
std::string Progress::coupling_text(const std::vector<double>& values) const {
  std::string text;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string& name = columns_[k].name;
    if (name == "work_points") text += fmt::format("  work {:.3g} J", values[k]);
    if (name == "work_created") text += fmt::format(" ({:+.1g} created)", values[k]);
    if (name == "iterations" && values[k] > 1) text += fmt::format("  iterations {:.0f}", values[k]);
    if (name == "unconverged" && values[k] > 0) text += fmt::format("  {:.0f} not converged", values[k]);
    if (name == "added_mass_ratio") text += fmt::format("  mu {:.2f}", values[k]);
  }
  return text;
}

}  // namespace cosurge
