#include "common/case/case_tables.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "common/case/table.hpp"
#include "common/error.hpp"
#include "common/geometry/stl.hpp"
#include "common/geometry/triangles.hpp"

namespace cosurge {
namespace {

constexpr double degree = std::numbers::pi / 180;

bool has_extension(const std::filesystem::path& file, const std::string& wanted) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == wanted;
}

/// Corners of the polygon, each once.
std::vector<double> read_polygon(const std::filesystem::path& file, bool scaled) {
  const std::string unit = scaled ? "" : "m";
  std::vector<double> corners = read_table(file, {{"x", unit}, {"y", unit}}).values;
  std::vector<double> different;
  for (std::size_t k = 0; k + 1 < corners.size(); k += 2) {
    const std::size_t n = different.size();
    if (n >= 2 && different[n - 2] == corners[k] && different[n - 1] == corners[k + 1]) continue;
    different.insert(different.end(), {corners[k], corners[k + 1]});
  }
  const std::size_t n = different.size();
  if (n > 2 && different[0] == different[n - 2] && different[1] == different[n - 1]) different.resize(n - 2);
  return different;
}

/// Sine and cosine, exact for quarters of a turn: faces along the axes stay so.
std::pair<double, double> sine_and_cosine(double degrees) {
  const double quarters = degrees / 90;
  if (quarters != std::round(quarters)) return {std::sin(degrees * degree), std::cos(degrees * degree)};
  constexpr std::array<double, 4> sine = {0, 1, 0, -1};
  const auto turn = static_cast<std::size_t>(std::fmod(std::fmod(quarters, 4) + 4, 4));
  return {sine[turn], sine[(turn + 1) % 4]};
}

/// Turns corners of `dimension` coordinates in the plane from one axis to another.
void turn(std::vector<double>& corners, std::size_t dimension, std::size_t from, std::size_t to,
          double degrees) {
  const auto [s, c] = sine_and_cosine(degrees);
  for (std::size_t k = 0; k + dimension <= corners.size(); k += dimension) {
    const double a = corners[k + from], b = corners[k + to];
    corners[k + from] = c * a - s * b;
    corners[k + to] = s * a + c * b;
  }
}

/// Scales, turns and moves corners as the shape says.
void place(const v1::Shape& shape, std::size_t dimension, std::vector<double>& corners) {
  for (double& value : corners) value *= shape.has_scale() ? shape.scale() : 1;
  if (shape.rotate_size() == 1) turn(corners, 2, 0, 1, shape.rotate(0));
  for (std::size_t axis = 0; axis < 3 && shape.rotate_size() == 3; ++axis)
    turn(corners, 3, (axis + 1) % 3, (axis + 2) % 3, shape.rotate(static_cast<int>(axis)));
  for (std::size_t k = 0; k < corners.size() && shape.shift_size() > 0; ++k)
    corners[k] += shape.shift(static_cast<int>(k % dimension));
}

void read_outline(v1::Shape& shape, const std::filesystem::path& folder, int dimension) {
  const bool placed = shape.has_scale() || shape.rotate_size() > 0 || shape.shift_size() > 0;
  require(!placed || !shape.outline().empty(), "scale, rotate and shift are for an outline only");
  if (shape.outline().empty()) return;
  const auto file = folder / shape.outline();
  require(dimension == 3 || !has_extension(file, ".stl"),
          "{}: a scene of two dimensions needs a polygon, with one corner x, y per line", file.string());
  require(dimension == 2 || !has_extension(file, ".csv"), "{}: a scene of three dimensions needs an STL file",
          file.string());
  const int angles = dimension == 2 ? 1 : 3;
  require(shape.rotate_size() == 0 || shape.rotate_size() == angles, "rotate has {} angles, must have {}",
          shape.rotate_size(), angles);
  std::vector<double> corners =
      dimension == 2 ? read_polygon(file, shape.has_scale()) : orient(weld(read_stl(file)));
  place(shape, static_cast<std::size_t>(dimension), corners);
  shape.mutable_vertex()->Assign(corners.begin(), corners.end());
}

/// The columns of a motion's table.
std::vector<TableColumn> motion_columns(const v1::WallMotion& motion, int dimension) {
  const std::string angle_unit = v1::AngleUnit::Word_Name(motion.angle_unit());
  std::vector<TableColumn> columns = {{"time", "s"}};
  if (motion.has_along()) {
    const bool angle = motion.along() == v1::Along::angle;
    columns.push_back({v1::Along::Word_Name(motion.along()), angle ? angle_unit : "m"});
    return columns;
  }
  for (int k = 0; k < dimension; ++k) columns.push_back({std::string(1, "xyz"[k]), "m"});
  columns.push_back({"angle", angle_unit});
  return columns;
}

void read_motion(v1::WallMotion& motion, const std::filesystem::path& folder, int dimension) {
  if (motion.table().empty()) {
    require(!motion.has_along() && !motion.has_angle_unit(),
            "along and angle_unit are for a table only; angle and phase of a formula are in rad");
    return;
  }
  require(!motion.has_along() || motion.along() != v1::Along::z || dimension == 3,
          "along = \"z\" is for scenes of three dimensions");
  const auto file = folder / motion.table();
  const std::vector<TableColumn> columns = motion_columns(motion, dimension);
  const Table table = read_table(file, columns);
  require(table.lines.size() >= 2, "{}: has {} rows of {}; needs at least two", file.string(),
          table.lines.size(), describe(columns));
  const double angle = motion.angle_unit() == v1::AngleUnit::deg ? degree : 1;
  const auto last = static_cast<std::size_t>(dimension);  // column of the angle, without the time
  for (std::size_t r = 0; r < table.lines.size(); ++r) {
    const double* row = table.values.data() + r * columns.size();
    require(r == 0 || row[0] > row[-static_cast<std::ptrdiff_t>(columns.size())],
            "{}:{}: times must increase: {} s after {} s", file.string(), table.lines[r], row[0],
            r == 0 ? 0 : row[-static_cast<std::ptrdiff_t>(columns.size())]);
    std::vector<double> pose(last + 1, 0.0);
    if (motion.has_along())
      pose[motion.along() == v1::Along::angle ? last : static_cast<std::size_t>(motion.along())] = row[1];
    else
      std::copy_n(row + 1, pose.size(), pose.begin());
    pose[last] *= angle;
    motion.add_row(row[0]);
    for (const double value : pose) motion.add_row(value);
  }
}

}  // namespace

void read_tables(v1::Case& c, const std::filesystem::path& folder, CaseErrors& errors) {
  const auto attempt = [&](const std::string& key, auto&& read) {
    try {
      read();
    } catch (const Error& error) {
      errors.add(key, error.what());
    }
  };
  const auto read_bodies = [&](const std::string& solid_key, v1::Solid& solid) {
    for (int i = 0; i < solid.body_size(); ++i) {
      v1::Body& body = *solid.mutable_body(i);
      const std::string key = fmt::format("{}.body.{}", solid_key, i);
      if (body.has_shape())
        attempt(key + ".shape.outline", [&] { read_outline(*body.mutable_shape(), folder, c.dimension()); });
      if (body.has_motion())
        attempt(key + ".motion.table", [&] { read_motion(*body.mutable_motion(), folder, c.dimension()); });
      for (int j = 0; j < body.clamp_size(); ++j)
        attempt(fmt::format("{}.clamp.{}.outline", key, j),
                [&] { read_outline(*body.mutable_clamp(j), folder, c.dimension()); });
    }
  };
  if (c.has_solid()) read_bodies("solid", *c.mutable_solid());
  for (int k = 0; k < c.solids_size(); ++k) read_bodies(fmt::format("solid.{}", k), *c.mutable_solids(k));
  if (!c.has_fluid()) return;
  v1::Fluid& fluid = *c.mutable_fluid();
  for (int i = 0; i < fluid.water_size(); ++i)
    attempt(fmt::format("fluid.water.{}.outline", i),
            [&] { read_outline(*fluid.mutable_water(i), folder, c.dimension()); });
  for (int i = 0; i < fluid.obstacle_size(); ++i) {
    v1::Obstacle& obstacle = *fluid.mutable_obstacle(i);
    attempt(fmt::format("fluid.obstacle.{}.shape.outline", i),
            [&] { read_outline(*obstacle.mutable_shape(), folder, c.dimension()); });
    if (obstacle.has_motion())
      attempt(fmt::format("fluid.obstacle.{}.motion.table", i),
              [&] { read_motion(*obstacle.mutable_motion(), folder, c.dimension()); });
  }
  if (fluid.has_tank_motion())
    attempt("fluid.tank_motion.table",
            [&] { read_motion(*fluid.mutable_tank_motion(), folder, c.dimension()); });
}

}  // namespace cosurge
