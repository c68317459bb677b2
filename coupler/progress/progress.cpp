#include "coupler/progress/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

constexpr double terminal_interval = 0.2;  // s between two states of the line
constexpr double plain_interval = 5;       // s between two lines
constexpr const char* clear_line = "\r\x1b[K";

/// Columns of a terminal: the smaller of its own width and COLUMNS; 80 where neither is known.
std::size_t columns_of(std::FILE* terminal) {
  constexpr long unknown = std::numeric_limits<long>::max();
  winsize size{};
  const bool known = ioctl(fileno(terminal), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const char* text = std::getenv("COLUMNS");
  const long told = text == nullptr ? 0 : std::strtol(text, nullptr, 10);
  const long least = std::min(known ? long{size.ws_col} : unknown, told > 0 ? told : unknown);
  return static_cast<std::size_t>(least == unknown ? 80 : least);
}

/// On lines of their own, also where the progress line is not due.
void tell_notes(const Reports& reports, std::FILE* out, const char* before) {
  for (const Report& report : reports)
    for (const std::string& note : report.notes) std::fputs((before + printable(note) + "\n").c_str(), out);
}

}  // namespace

Progress::Progress(const v1::Case& the_case, const std::vector<Member>& members,
                   const std::vector<Column>& columns, std::FILE* out)
    : meter_(the_case, members, columns), out_(out), terminal_(isatty(fileno(out)) != 0) {}

Progress::~Progress() {
  if (terminal_) std::fputc('\n', out_);
}

void Progress::window(const Window& window, const Reports& reports, const std::vector<double>& coupling) {
  tell_notes(reports, out_, terminal_ ? clear_line : "");
  if (!meter_.count(window, terminal_ ? terminal_interval : plain_interval)) return;
  const ProgressState state = meter_.state(reports, coupling);
  // The last column stays free: some terminals begin a new line once it is written.
  const std::size_t width = terminal_ ? std::max<std::size_t>(columns_of(out_), 2) - 1 : std::string::npos;
  const std::string line = printable(progress_line(state, width));
  std::fputs((terminal_ ? clear_line + line : line + "\n").c_str(), out_);
  std::fflush(out_);
}

void Notes::window(const Window&, const Reports& reports, const std::vector<double>&) {
  tell_notes(reports, out_, "");
  std::fflush(out_);
}

}  // namespace cosurge
