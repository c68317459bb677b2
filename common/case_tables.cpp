#include "common/case_tables.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "common/error.hpp"

namespace cosurge {
namespace {

using Numbers = google::protobuf::RepeatedField<double>;

std::string contents(const std::filesystem::path& file) {
  require(std::filesystem::is_regular_file(file), "{}: no such file", file.string());
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Rows of `columns` numbers each, separated by commas or blanks.
Numbers read_csv(const std::filesystem::path& file, int columns) {
  std::istringstream text(contents(file));
  Numbers numbers;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    for (char& c : line)
      if (c == ',' || c == '\r') c = ' ';
    std::istringstream fields(line);
    const int before = numbers.size();
    for (double value = 0; fields >> value;) numbers.Add(value);
    require(fields.eof() && numbers.size() - before == columns, "{}:{}: must be {} numbers", file.string(),
            number, columns);
  }
  return numbers;
}

/// Corners of the triangles, three a triangle.
Numbers read_stl(const std::filesystem::path& file) {
  const std::string bytes = contents(file);
  constexpr std::size_t head = 84, facet = 50;
  Numbers corners;
  std::uint32_t facets = 0;
  if (bytes.size() >= head) std::memcpy(&facets, bytes.data() + 80, sizeof facets);
  if (bytes.size() >= head && bytes.size() == head + facets * facet) {
    for (std::size_t k = 0; k < facets; ++k) {
      std::array<float, 12> values{};  // normal, and three corners
      std::memcpy(values.data(), bytes.data() + head + k * facet, sizeof values);
      for (std::size_t i = 3; i < values.size(); ++i) corners.Add(static_cast<double>(values[i]));
    }
  } else {
    require(bytes.starts_with("solid"), "{}: is neither a text nor a binary STL", file.string());
    std::istringstream words(bytes);
    for (std::string word; words >> word;) {
      if (word != "vertex") continue;
      double x = 0, y = 0, z = 0;
      require(static_cast<bool>(words >> x >> y >> z), "{}: a vertex must be three numbers", file.string());
      for (const double value : {x, y, z}) corners.Add(value);
    }
  }
  return corners;
}

void check_finite(const std::filesystem::path& file, const Numbers& numbers) {
  for (const double value : numbers)
    require(std::isfinite(value), "{}: {} is no finite number", file.string(), value);
}

void read_outline(v1::Shape& shape, const std::filesystem::path& folder, int dimension) {
  if (shape.outline().empty()) return;
  const auto file = folder / shape.outline();
  require(dimension == 3 || file.extension() != ".stl",
          "{}: a scene of two dimensions takes a polygon, x, y a line", file.string());
  require(dimension == 2 || file.extension() != ".csv", "{}: a scene of three dimensions takes an STL",
          file.string());
  *shape.mutable_vertex() = dimension == 2 ? read_csv(file, 2) : read_stl(file);
  check_finite(file, shape.vertex());
}

void read_motion(v1::WallMotion& motion, const std::filesystem::path& folder, int dimension) {
  if (motion.table().empty()) return;
  const auto file = folder / motion.table();
  const int columns = dimension + 2;
  *motion.mutable_row() = read_csv(file, columns);
  check_finite(file, motion.row());
  require(motion.row_size() >= 2 * columns && motion.row(0) == 0,
          "{}: must begin at time 0 and have two rows", file.string());
  for (int k = columns; k < motion.row_size(); k += columns)
    require(motion.row(k) > motion.row(k - columns), "{}: times must increase", file.string());
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
  for (int i = 0; i < c.solid().body_size(); ++i) {
    v1::Body& body = *c.mutable_solid()->mutable_body(i);
    const std::string key = fmt::format("solid.body.{}", i);
    if (body.has_shape())
      attempt(key + ".shape.outline", [&] { read_outline(*body.mutable_shape(), folder, c.dimension()); });
    for (int j = 0; j < body.clamp_size(); ++j)
      attempt(fmt::format("{}.clamp.{}.outline", key, j),
              [&] { read_outline(*body.mutable_clamp(j), folder, c.dimension()); });
  }
  if (!c.has_fluid()) return;
  v1::Fluid& fluid = *c.mutable_fluid();
  for (int i = 0; i < fluid.water_size(); ++i)
    attempt(fmt::format("fluid.water.{}.outline", i),
            [&] { read_outline(*fluid.mutable_water(i), folder, c.dimension()); });
  for (int i = 0; i < fluid.obstacle_size(); ++i) {
    v1::Obstacle& obstacle = *fluid.mutable_obstacle(i);
    attempt(fmt::format("fluid.obstacle.{}.shape.outline", i),
            [&] { read_outline(*obstacle.mutable_shape(), folder, c.dimension()); });
    attempt(fmt::format("fluid.obstacle.{}.motion.table", i),
            [&] { read_motion(*obstacle.mutable_motion(), folder, c.dimension()); });
  }
  attempt("fluid.tank_motion.table",
          [&] { read_motion(*fluid.mutable_tank_motion(), folder, c.dimension()); });
}

}  // namespace cosurge
