#include "coupler/video/film.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/case/bodies.hpp"
#include "common/case/probe_columns.hpp"
#include "common/error.hpp"
#include "coupler/draw/axes.hpp"
#include "coupler/draw/color_bar.hpp"
#include "coupler/draw/history_strip.hpp"
#include "coupler/draw/parts.hpp"
#include "coupler/draw/scene_clouds.hpp"
#include "coupler/report/outlines.hpp"

namespace cosurge {
namespace {

constexpr int film_width = 1280;
constexpr double left = 66, right = 24, top = 60, highest = 560, lowest = 200;
constexpr double bars_height = 74, strip_height = 130, strip_space = 80;
constexpr double longest = 5;        // film_width over height of a scene that is shown as a whole
constexpr std::size_t samples = 12;  // frames that scales and region are taken from
constexpr double overlap = 1.25;     // size of particles over their spacing: disordered water has no gaps
constexpr double outliers = 0.003;   // share of particles and values beyond region and scale
const Color ink = hex(0x111827);

/// The quantile of the values for the given share. Reorders the values.
double quantile(std::vector<float>& values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<std::size_t> sampled(std::size_t frames) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < std::min(frames, samples); ++k)
    chosen.push_back(frames <= samples ? k : k * (frames - 1) / (samples - 1));
  return chosen;
}

/// The quantity by which a solver's particles are coloured; empty if its frames have none. In three
/// dimensions the surface of the water is visible, where the pressure is zero; it is coloured by speed.
std::string quantity_of(const FrameSource& source, int dimension) {
  if (dimension == 2 && source.has("pressure")) return "pressure";
  if (source.has("von_mises")) return "von_mises";
  return source.has("velocity") ? "speed" : "";
}

}  // namespace

class Film::Scene {
 public:
  explicit Scene(const Results& results)
      : case_(results.the_case()),
        fluid_(results, "fluid"),
        solid_(results, "solid"),
        times_(results.frame_times()) {
    require(!times_.empty(), "{}: has no frame yet", results.file().string());
    constexpr double unlimited = 1e9;
    choice_ = choose(case_, fluid_, solid_, 1, unlimited);
    parts_ = read_parts(outlines(case_, times_));
    std::erase_if(parts_, [](const Part& part) {
      return part.kind == "water" || part.kind == "body" || part.kind == "probe";
    });
    for (const Cast& cast : choice_.casts) shades_.push_back(shade_of(cast));
    const Region region = region_of_frames();
    const double wide = film_width - left - right;
    const double high = std::clamp(wide * View::aspect(region), lowest, highest);
    view_.emplace(region, Rectangle{left, top, wide, high});
    height_ = static_cast<int>(top + high + bars_height);
    add_strip(results);
    height_ += height_ % 2;
  }

  std::size_t pictures() const { return times_.size(); }
  int height() const { return height_; }

  Canvas picture(std::size_t frame) const {
    Canvas canvas(film_width, height_);
    canvas.text({left, 30}, case_.title(), 18, ink, Align::left, true);
    canvas.text({film_width - right, 30}, fmt::format("t = {:.4f} s", times_[frame]), 18, ink, Align::right,
                true);
    canvas.clip(view_->area());
    std::vector<Cloud> clouds;
    for (std::size_t k = 0; k < choice_.casts.size(); ++k)
      clouds.push_back(cloud_of(choice_.casts[k], shades_[k], frame));
    draw_particles(canvas, *view_, clouds);
    for (const Part& part : parts_) draw_part(canvas, *view_, part, frame);
    canvas.unclip();
    view_->dimension() == 2 ? draw_axes(canvas, *view_) : draw_directions(canvas, *view_);
    double x = left;
    for (std::size_t k = 0; k < shades_.size(); ++k) {
      if (shades_[k].scale == nullptr) continue;
      const std::string label = choice_.casts[k].member == "fluid" ? "water" : "structure";
      draw_color_bar(canvas, shades_[k], label, {x, view_->area().bottom() + 46, 260, 10});
      x += 320;
    }
    if (strip_) strip_->draw(canvas, times_[frame]);
    return canvas;
  }

 private:
  const FrameSource& source(const Cast& cast) const {
    return cast.member == "fluid" ? static_cast<const FrameSource&>(fluid_) : solid_;
  }

  /// Colours between 0 and nearly the largest value of the sampled frames.
  Shade shade_of(const Cast& cast) const {
    const std::string quantity = quantity_of(source(cast), case_.dimension());
    if (quantity.empty()) return {};
    std::vector<float> values;
    for (const std::size_t frame : sampled(times_.size())) {
      const ShownFrame shown = read_shown(source(cast), cast, frame, quantity);
      for (std::size_t k = 0; k < shown.values.size(); ++k)
        if (shown.kinds[k] == Kind::water && std::isfinite(shown.values[k]))
          values.push_back(shown.values[k]);
    }
    const double most = quantile(values, 1 - outliers);
    std::string name = quantity == "von_mises" ? "von Mises stress" : quantity;
    return {.name = std::move(name),
            .unit = quantity == "speed" ? "m/s" : source(cast).unit(quantity),
            .scale = cast.member == "fluid" ? &viridis : &stress_scale,
            .low = 0,
            .high = most > 0 ? most : 1};
  }

  Cloud cloud_of(const Cast& cast, const Shade& shade, std::size_t frame) const {
    const bool is_fluid = cast.member == "fluid";
    const ShownFrame shown =
        read_shown(source(cast), cast, frame,
                   shade.scale == nullptr ? "" : quantity_of(source(cast), case_.dimension()));
    Cloud cloud{.spacing = overlap * (is_fluid ? case_.fluid().spacing() : solid_spacing(case_)),
                .positions = shown.positions,
                .colors = {}};
    for (std::size_t k = 0; k < shown.kinds.size(); ++k)
      cloud.colors.push_back(shown.kinds[k] != Kind::water ? wall_color(shown.kinds[k])
                             : shade.scale == nullptr      ? hex(0xf0a35e)
                                                           : shade.color(shown.values[k]));
    return cloud;
  }

  /// Region of water and structures in the sampled frames, without a few drops; for a long scene the part
  /// around the bodies.
  Region region_of_frames() const {
    const auto dimension = static_cast<std::size_t>(case_.dimension());
    std::vector<std::vector<float>> places(dimension);
    Region region(case_.dimension()), bodies(case_.dimension());
    for (const Cast& cast : choice_.casts)
      for (const std::size_t frame : sampled(times_.size())) {
        const ShownFrame shown = read_shown(source(cast), cast, frame);
        for (std::size_t k = 0; k < shown.kinds.size(); ++k) {
          const Place place(shown.positions.begin() + static_cast<std::ptrdiff_t>(k * dimension),
                            shown.positions.begin() + static_cast<std::ptrdiff_t>((k + 1) * dimension));
          if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); })) continue;
          if (cast.member == "solid") bodies.add(place);
          if (cast.member == "fluid" && shown.kinds[k] == Kind::water)
            for (std::size_t axis = 0; axis < dimension; ++axis)
              places[axis].push_back(static_cast<float>(place[axis]));
        }
      }
    if (!bodies.empty()) region.add(bodies.min), region.add(bodies.max);
    if (!places[0].empty()) {
      Place low, high;
      for (auto& values : places)
        low.push_back(quantile(values, outliers)), high.push_back(quantile(values, 1 - outliers));
      region.add(low), region.add(high);
    }
    require(!region.empty(), "the frames have no particles that could be drawn");
    const double spacing = case_.has_fluid() ? case_.fluid().spacing() : solid_spacing(case_);
    region = region.grown(std::max(0.04 * region.largest_size(), 3.5 * spacing));
    const double most = longest * region.size(dimension - 1);
    if (dimension == 2 && !bodies.empty() && region.size(0) > most) {
      const double middle = std::clamp(0.5 * (bodies.min[0] + bodies.max[0]), region.min[0] + most / 2,
                                       region.max[0] - most / 2);
      region.min[0] = middle - most / 2, region.max[0] = middle + most / 2;
    }
    return region;
  }

  /// The columns of the first probe that the results have.
  void add_strip(const Results& results) {
    if (case_.output().probe_size() == 0) return;
    const v1::Probe& probe = case_.output().probe(0);
    std::vector<Series> columns;
    const std::vector<std::string> known = results.histories();
    for (const std::string& column : probe_columns(probe, case_.dimension()))
      if (const std::string name = probe_group(probe) + "/" + column;
          std::find(known.begin(), known.end(), name) != known.end())
        columns.push_back(results.history(name));
    const std::vector<double> time = results.history("time").values;
    if (columns.empty() || time.empty()) return;
    const double end = std::max(time.back(), times_.back());
    strip_.emplace(time, columns, end,
                   Rectangle{left, height_ + 30.0, film_width - left - right, strip_height});
    height_ += static_cast<int>(strip_height + strip_space);
  }

  v1::Case case_;
  RecordedFrames fluid_, solid_;
  std::vector<double> times_;
  SceneChoice choice_;
  std::vector<Part> parts_;
  std::vector<Shade> shades_;  // colouring of each cast
  std::optional<View> view_;
  std::optional<HistoryStrip> strip_;
  int height_ = 0;
};

Film::Film(const Results& results) : scene_(std::make_unique<Scene>(results)) {}
Film::~Film() = default;

std::size_t Film::pictures() const { return scene_->pictures(); }
int Film::width() const { return film_width; }
int Film::height() const { return scene_->height(); }
Canvas Film::picture(std::size_t frame) const { return scene_->picture(frame); }

}  // namespace cosurge
