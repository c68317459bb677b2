#include "coupler/report/scene.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t frames_a_chunk = 16;
constexpr std::size_t fewest_frames = 100;  // before particles are left out
constexpr double bytes_a_coordinate = 1.3;  // packed, as measured for dam breaks
constexpr double bytes_a_quantity = 1.1;
constexpr int water = 0, wall = 1, dummy = 2;     // kinds of the frames
constexpr double fraction_of_spacing = 1.0 / 64;  // positions of water need not be finer

/// Kinds of the fluid's particles at the start; other solvers may have water only, without kinds.
std::vector<float> kinds_of(const FrameSource& fluid) {
  return fluid.has("kind") ? fluid.read("kind", 0) : std::vector<float>(fluid.particles(), water);
}

bool in_tank(const v1::Box& tank, const float* x, int dimension) {
  for (int axis = 0; axis < dimension; ++axis)
    if (x[axis] < tank.min(axis) || x[axis] > tank.max(axis)) return false;
  return true;
}

std::vector<std::string> quantities_of(const FrameSource& source) {
  std::vector<std::string> names;
  for (const std::string name : {"pressure", "von_mises"})
    if (source.has(name)) names.push_back(name);
  if (source.has("velocity")) names.push_back("speed");
  return names;
}

/// Keeps about one particle in `every`. Every tenth particle by number would leave rows and planes of the
/// lattice; fractional parts of multiples of the golden ratio are spread evenly (Knuth, The Art of Computer
/// Programming 3, section 6.4).
bool is_kept(std::uint32_t number, std::size_t every) {
  constexpr std::uint32_t golden = 2654435769;  // golden ratio times 2^32
  const std::uint32_t mixed = number * golden;
  return std::uint64_t{mixed} * every < (std::uint64_t{1} << 32);
}

Cast fluid_cast(const v1::Case& the_case, const FrameSource& fluid, std::size_t every) {
  Cast cast{.member = "fluid",
            .particles = {},
            .finest = fraction_of_spacing * the_case.fluid().spacing(),
            .quantities = quantities_of(fluid)};
  const std::vector<float> kind = kinds_of(fluid), position = fluid.read("position", 0);
  const int dimension = the_case.dimension();
  std::uint32_t seen = 0;
  for (std::size_t k = 0; k < kind.size(); ++k) {
    const int is = static_cast<int>(kind[k]);
    const float* x = position.data() + k * static_cast<std::size_t>(dimension);
    if (is == water && is_kept(seen++, every)) cast.particles.push_back(k);
    if (is == wall && (dimension == 2 || in_tank(the_case.fluid().tank(), x, dimension)))
      cast.particles.push_back(k);
    if (is == dummy && dimension == 2) cast.particles.push_back(k);
  }
  return cast;
}

std::size_t water_in(const FrameSource& fluid) {
  const std::vector<float> kind = kinds_of(fluid);
  return static_cast<std::size_t>(std::count(kind.begin(), kind.end(), static_cast<float>(water)));
}

}  // namespace

SceneChoice choose(const v1::Case& the_case, const FrameSource& fluid, const FrameSource& solid,
                   std::size_t frames, double megabytes) {
  SceneChoice choice;
  const double in_a_frame = the_case.dimension() * bytes_a_coordinate + 2 * bytes_a_quantity;
  double particles = 0;
  if (solid.has("position")) {
    Cast cast{.member = "solid", .particles = {}, .finest = 0, .quantities = quantities_of(solid)};
    for (std::size_t k = 0; k < solid.particles(); ++k) cast.particles.push_back(k);
    choice.casts.push_back(std::move(cast));
    particles += static_cast<double>(solid.particles());
  }
  if (fluid.has("position")) choice.water = water_in(fluid);
  particles += static_cast<double>(choice.water);
  const double share = 4.0 / 3 * in_a_frame * particles * static_cast<double>(frames) / (1e6 * megabytes);
  const double most = std::max(1.0, std::floor(static_cast<double>(frames) / fewest_frames));
  choice.every_frame = static_cast<std::size_t>(std::clamp(std::ceil(share), 1.0, most));
  choice.every_particle =
      static_cast<std::size_t>(std::max(1.0, std::ceil(share / static_cast<double>(choice.every_frame))));
  if (fluid.has("position"))
    choice.casts.insert(choice.casts.begin(), fluid_cast(the_case, fluid, choice.every_particle));
  return choice;
}

Json chunks(const SceneChoice& choice, const FrameSource& fluid, const FrameSource& solid, std::size_t first,
            std::size_t last) {
  Json out = Json::array();
  const std::size_t every = choice.every_frame;
  std::size_t shown = (first + every - 1) / every;
  while (shown * every < last) {
    std::vector<std::size_t> frames;
    for (std::size_t k = shown; k * every < last && frames.size() < frames_a_chunk; ++k)
      frames.push_back(k * every);
    for (const Cast& cast : choice.casts) {
      Json chunk = pack_frames(cast.member == "fluid" ? fluid : solid, cast, frames);
      chunk["first"] = shown;
      out.push_back(std::move(chunk));
    }
    shown += frames.size();
  }
  return out;
}

}  // namespace cosurge
