#include "coupler/video/video_command.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "common/error.hpp"
#include "coupler/say.hpp"
#include "coupler/study/words.hpp"
#include "coupler/video/encoder.hpp"
#include "coupler/video/film.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr double duration = 10;              // s, about
constexpr double slowest = 4, fastest = 30;  // pictures a second

}  // namespace

void video_command(const std::vector<std::string>& results, const fs::path& file) {
  std::vector<std::string> wrong;
  const auto check = [&](bool right, const std::string& message) {
    if (!right) wrong.push_back(message);
  };
  check(results.size() == 1, "--video: shows one run; name one folder of results");
  check(file.extension() == ".mp4", fmt::format("--video {}: the name must end in .mp4", file.string()));
  check(!fs::exists(file), fmt::format("--video {}: exists already; choose another name", file.string()));
  const fs::path folder = fs::absolute(file).parent_path();
  check(fs::is_directory(folder),
        fmt::format("--video {}: there is no folder {}", file.string(), folder.string()));
  note_errors(wrong, [&] { Results::file_at(results.front()); });
  note_errors(wrong, Encoder::require_ffmpeg);
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));

  const Results run(results.front());
  const Film film(run);
  const double speed = std::clamp(static_cast<double>(film.pictures()) / duration, slowest, fastest);
  Encoder encoder(file, film.width(), film.height(), speed);
  for (std::size_t frame = 0; frame < film.pictures(); ++frame) encoder.add(film.picture(frame));
  encoder.finish();
  say("video: {} ({:.1f} MB, {} frames of the results, {:.1f} a second)\n", file.string(),
      1e-6 * static_cast<double>(fs::file_size(file)), film.pictures(), speed);
}

}  // namespace cosurge
