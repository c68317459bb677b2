#include "fluid_solver/face_grid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace cosurge::fluid {
namespace {

constexpr double least_extent = 3;  // spacings: smaller faces have no room for a grid
constexpr int most_directions = 64;

/// The unit normal and the plane's distance from the origin along it; opposite normals differ.
template <int dim>
struct PlaneOf {
  Vec<dim> normal;
  double offset;
};

/// Numbers facets by the plane that they lie in. The first facet in a plane defines it.
template <int dim>
class PlaneGroups {
 public:
  explicit PlaneGroups(double spacing) : spacing_(spacing) {}

  std::size_t group_of(const Vec<dim>& normal, double offset) {
    const Key middle = key(normal, offset);
    constexpr int around = dim == 2 ? 27 : 81;
    for (int k = 0; k < around; ++k) {
      Key at = middle;
      for (int axis = 0, rest = k; axis <= dim; ++axis, rest /= 3) at[axis] += rest % 3 - 1;
      const auto found = groups_.find(number(at));
      if (found == groups_.end()) continue;
      for (const std::size_t g : found->second)
        if ((planes_[g].normal - normal).norm() < 1e-3 &&
            std::abs(planes_[g].offset - offset) < 1e-3 * spacing_)
          return g;
    }
    groups_[number(middle)].push_back(planes_.size());
    planes_.push_back({.normal = normal, .offset = offset});
    return planes_.size() - 1;
  }

  const std::vector<PlaneOf<dim>>& planes() const { return planes_; }

 private:
  using Key = Eigen::Matrix<std::int64_t, dim + 1, 1>;

  Key key(const Vec<dim>& normal, double offset) const {
    Key key;
    key.template head<dim>() = (normal / 1e-3).array().floor().template cast<std::int64_t>();
    key[dim] = static_cast<std::int64_t>(std::floor(offset / (1e-3 * spacing_)));
    return key;
  }

  static std::uint64_t number(const Key& key) {
    std::uint64_t number = 0;
    for (const std::int64_t part : key)
      number = number * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(part);
    return number;
  }

  double spacing_;
  std::vector<PlaneOf<dim>> planes_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> groups_;
};

template <int dim>
Eigen::Matrix<double, dim, dim - 1> axes_of(const Vec<dim>& normal, const Vec<dim>& along) {
  Eigen::Matrix<double, dim, dim - 1> axes;
  axes.col(0) = along.normalized();
  if constexpr (dim == 3) axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

}  // namespace

template <int dim>
std::vector<FaceGrid<dim>> FaceGrid<dim>::faces(const std::vector<Facet<dim>>& facets, double spacing) {
  std::vector<double> area(facets.size());
  std::vector<std::size_t> order(facets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = 0; k < facets.size(); ++k) area[k] = normal_of(facets[k]).norm();
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return area[a] > area[b]; });
  PlaneGroups<dim> groups(spacing);
  std::vector<std::vector<Facet<dim>>> members;
  for (const std::size_t k : order) {
    if (area[k] == 0) continue;
    const Vec<dim> normal = normal_of(facets[k]) / area[k];
    const std::size_t g = groups.group_of(normal, normal.dot(facets[k][0]));
    if (g == members.size()) members.emplace_back();
    members[g].push_back(facets[k]);
  }
  std::vector<FaceGrid> faces;
  for (std::size_t g = 0; g < members.size(); ++g) {
    const FaceGrid face(members[g], groups.planes()[g].normal);
    if (((face.extent_.high - face.extent_.low).array() >= least_extent * spacing).all())
      faces.push_back(face);
  }
  return faces;
}

/// The axes follow the edge with the smallest rectangle around the face.
template <int dim>
FaceGrid<dim>::FaceGrid(const std::vector<Facet<dim>>& facets, const Vec<dim>& normal)
    : origin_(facets[0][0]), normal_(normal) {
  double least = std::numeric_limits<double>::infinity();
  int directions = 0;
  for (const Facet<dim>& facet : facets)
    for (std::size_t k = 0; k < dim && directions < most_directions; ++k, ++directions) {
      const Vec<dim> edge = facet[(k + 1) % dim] - facet[k];
      if (edge.norm() == 0) continue;
      const Axes axes = axes_of<dim>(normal, edge);
      const Extent extent = extent_of(facets, axes, origin_);
      const double area = (extent.high - extent.low).prod();
      if (area > (1 - 1e-6) * least) continue;
      least = area;
      axes_ = axes;
      extent_ = extent;
    }
}

template <int dim>
auto FaceGrid<dim>::extent_of(const std::vector<Facet<dim>>& facets, const Axes& axes, const Vec<dim>& origin)
    -> Extent {
  Extent extent{.low = Plane::Constant(std::numeric_limits<double>::max()),
                .high = Plane::Constant(std::numeric_limits<double>::lowest())};
  for (const Facet<dim>& facet : facets)
    for (const Vec<dim>& corner : facet) {
      const Plane at = axes.transpose() * (corner - origin);
      extent.low = extent.low.cwiseMin(at);
      extent.high = extent.high.cwiseMax(at);
    }
  return extent;
}

template <int dim>
Vec<dim> FaceGrid<dim>::at(const Plane& in_plane, double depth) const {
  return origin_ + axes_ * in_plane - depth * normal_;
}

namespace {

/// Calls visit(point) for the points of a grid with `counts` pitches between two corners, the first axis
/// fastest.
template <typename Plane, typename Visit>
void each_of_grid(const Plane& low, const Plane& high,
                  const Eigen::Array<int, Plane::RowsAtCompileTime, 1>& counts, Visit&& visit) {
  const int rows = counts.size() > 1 ? counts[counts.size() - 1] : 0;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= counts[0]; ++i) {
      Plane at = counts[0] > 0 ? Plane(low + (high - low) * i / counts[0]) : Plane(0.5 * (low + high));
      if (counts.size() > 1) {
        const auto last = counts.size() - 1;
        at[last] =
            rows > 0 ? low[last] + (high[last] - low[last]) * j / rows : 0.5 * (low[last] + high[last]);
      }
      visit(at);
    }
}

}  // namespace

/// Extent of the face at this depth, where neighbouring faces shorten or lengthen it.
template <int dim>
auto FaceGrid<dim>::extent_at(const OutlineDepth<dim>& outline, double depth, double spacing) const
    -> std::optional<Extent> {
  const double pitch = 0.25 * spacing;
  std::array<std::optional<Plane>, 2 * flat> ends;
  const Eigen::Array<int, flat, 1> counts =
      ((extent_.high - extent_.low) / pitch).array().ceil().template cast<int>();
  each_of_grid<Plane>(extent_.low, extent_.high, counts, [&](const Plane& x) {
    if (!outline.is_at_depth(at(x, depth), std::abs(depth))) return;
    for (int axis = 0; axis < flat; ++axis) {
      auto& low = ends[static_cast<std::size_t>(2 * axis)];
      auto& high = ends[static_cast<std::size_t>(2 * axis + 1)];
      if (!low || x[axis] < (*low)[axis]) low = x;
      if (!high || x[axis] > (*high)[axis]) high = x;
    }
  });
  if (!ends[0]) return std::nullopt;
  Extent extent;
  for (int axis = 0; axis < flat; ++axis)
    for (const int side : {0, 1}) {
      Plane in = *ends[static_cast<std::size_t>(2 * axis + side)], out = in;
      out[axis] += side == 0 ? -pitch : pitch;
      for (int halving = 0; halving < 20; ++halving) {
        const Plane middle = 0.5 * (in + out);
        (outline.is_at_depth(at(middle, depth), std::abs(depth)) ? in : out) = middle;
      }
      (side == 0 ? extent.low : extent.high)[axis] = in[axis];
    }
  return extent;
}

template <int dim>
std::vector<Vec<dim>> FaceGrid<dim>::points(const OutlineDepth<dim>& outline, double depth,
                                            double spacing) const {
  std::vector<Vec<dim>> points;
  for (const double below : {depth, -depth}) {  // the normal may point inwards
    const std::optional<Extent> extent = extent_at(outline, below, spacing);
    if (!extent) continue;
    const Eigen::Array<int, flat, 1> counts =
        ((extent->high - extent->low) / spacing).array().round().template cast<int>();
    each_of_grid<Plane>(extent->low, extent->high, counts, [&](const Plane& in_plane) {
      const Vec<dim> x = at(in_plane, below);
      if (outline.is_at_depth(x, depth)) points.push_back(x);
    });
  }
  return points;
}

template class FaceGrid<2>;
template class FaceGrid<3>;

}  // namespace cosurge::fluid
