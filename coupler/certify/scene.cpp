#include "coupler/certify/scene.hpp"

#include <fstream>

#include "common/case/case_file.hpp"
#include "common/case/from_case.hpp"

namespace cosurge::certify {
namespace {

constexpr const char* scene = R"(title = "Certification"
gravity = [0.0, 0.0]
time = { end = 0.01, window = 1e-4 }
[fluid]
spacing = 0.004
source = "mixed"
tank = { min = [0.0, 0.0], max = [0.3, 0.2] }
water = [{ min = [0.0, 0.0], max = [0.1, 0.1] }]
[solid]
density = 2500.0
young_modulus = 1e6
[[solid.body]]
box = { min = [0.148, 0.0], max = [0.16, 0.08] }
clamp = [{ min = [0.148, -0.016], max = [0.16, 0.0] }]
)";

}  // namespace

v1::Case scene_for(const CertifyOptions& options, const std::filesystem::path& folder) {
  const auto file = folder / "case.toml";
  std::ofstream(file) << scene;
  std::vector<std::string> overrides = options.overrides;
  if (options.role == Role::fluid) overrides.emplace_back("gravity.1=-9.81");
  return load_case(file.string(), overrides);
}

Interface points_of_plate(const v1::Case& c) {
  const auto box = from_case<2>(c.solid().body(0).box());
  const double l0 = c.fluid().spacing();
  const std::vector<Vec<2>> sites = fill(box, l0);
  const auto count = static_cast<Eigen::Index>(sites.size());
  Interface points{.dimension = 2, .position = Field(2, count), .area = Field::Zero(2, count), .body = {}};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec<2>& x = sites[static_cast<std::size_t>(k)];
    points.position.col(k) = x;
    points.area(0, k) = x[0] < box.min[0] + l0 ? -l0 : x[0] > box.max[0] - l0 ? l0 : 0;
    points.area(1, k) = x[1] > box.max[1] - l0 ? l0 : 0;
    points.body.push_back(0);
  }
  return points;
}

}  // namespace cosurge::certify
