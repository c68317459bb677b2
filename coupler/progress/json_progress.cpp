#include "coupler/progress/json_progress.hpp"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/error.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;

constexpr double interval = 1;  // s between two lines

/// A number, or null if it is not finite, which JSON cannot represent.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void write_line(std::FILE* out, const Json& line) {
  std::fputs((line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n").c_str(), out);
  std::fflush(out);
}

}  // namespace

JsonLines::JsonLines() : out_(nullptr) {
  std::fflush(stdout);
  const int own = ::dup(STDOUT_FILENO);
  if (own >= 0 && ::dup2(STDERR_FILENO, STDOUT_FILENO) >= 0) out_ = ::fdopen(own, "w");
  require(out_ != nullptr, "--json-progress: the standard output cannot be used: {}", std::strerror(errno));
}

JsonLines::~JsonLines() { std::fclose(out_); }

void JsonLines::progress(const ProgressState& state, const std::vector<ProbeValue>& probes) {
  Json values = Json::object();
  for (const ProbeValue& probe : probes) values[probe.name] = number(probe.value);
  write_line(out_, {{"event", "progress"},
                    {"time", state.time},
                    {"end", state.end},
                    {"window", state.window},
                    {"window_size", state.window_size},
                    {"seconds", state.seconds},
                    {"seconds_left", number(state.seconds_left)},
                    {"iterations", state.iterations},
                    {"unconverged", state.unconverged},
                    {"added_mass_ratio", number(state.added_mass_ratio)},
                    {"probes", values}});
}

void JsonLines::note(const std::string& note) { write_line(out_, {{"event", "note"}, {"text", note}}); }

void JsonLines::end(const Outcome& outcome, double time, std::uint64_t windows,
                    const std::filesystem::path& results) {
  write_line(out_, {{"event", "end"},
                    {"status", outcome.status},
                    {"reason", outcome.reason},
                    {"time", time},
                    {"windows", windows},
                    {"results", results.string()}});
}

void JsonProgress::window(const Window& window, const Reports& reports, const std::vector<double>& coupling) {
  for (const Report& report : reports)
    for (const std::string& note : report.notes) lines_.note(note);
  if (meter_.count(window, interval))
    lines_.progress(meter_.state(reports, coupling), meter_.probes(reports));
}

}  // namespace cosurge
