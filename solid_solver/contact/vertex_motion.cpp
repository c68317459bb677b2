#include "solid_solver/contact/vertex_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/error.hpp"

namespace cosurge::contact {
namespace {

constexpr double rounding = 1e-6;  // [spacings] tolerance: vertices on a clamp's face are held by it
constexpr int iterations = 40;

template <int dim>
std::vector<char> in_clamps(const Structure<dim>& structure, const Field& position,
                            const std::vector<int>& body) {
  std::vector<char> held(body.size(), 0);
  for (std::size_t v = 0; v < body.size(); ++v)
    for (const Shape<dim>& clamp : structure.bodies[static_cast<std::size_t>(body[v])].clamps)
      if (clamp.outside(position.col(static_cast<Eigen::Index>(v))) <= rounding * structure.spacing)
        held[v] = 1;
  return held;
}

/// The matrix rows one by one; an empty one is replaced by that of the nearest vertex of the same body.
Interpolation row_by_row(const SolidModel& model, const Field& position, const std::vector<int>& body) {
  std::vector<Eigen::Index> source(body.size(), -1);
  for (Eigen::Index v = 0; v < position.cols(); ++v) {
    try {
      static_cast<void>(model.interpolation(position.col(v), {body[static_cast<std::size_t>(v)]}));
      source[static_cast<std::size_t>(v)] = v;
    } catch (const std::exception&) {
      source[static_cast<std::size_t>(v)] = -1;
    }
  }
  const std::vector<Eigen::Index> reached = source;
  for (std::size_t v = 0; v < source.size(); ++v) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < source.size() && reached[v] < 0; ++w) {
      if (reached[w] < 0 || body[w] != body[v]) continue;
      const double distance =
          (position.col(static_cast<Eigen::Index>(w)) - position.col(static_cast<Eigen::Index>(v))).norm();
      if (distance < least) source[v] = static_cast<Eigen::Index>(w);
      least = std::min(least, distance);
    }
    require(source[v] >= 0, "solid.body.{}: no node lies near its surface; make solid.spacing smaller",
            body[v]);
  }
  Field followed(position.rows(), position.cols());
  for (Eigen::Index v = 0; v < position.cols(); ++v)
    followed.col(v) = position.col(source[static_cast<std::size_t>(v)]);
  return model.interpolation(followed, body);
}

}  // namespace

template <int dim>
Interpolation vertex_interpolation(const SolidModel& model, const Structure<dim>& structure,
                                   const Field& position, const std::vector<int>& body) {
  Interpolation H;
  try {
    H = model.interpolation(position, body);
  } catch (const std::exception&) {
    H = row_by_row(model, position, body);
  }
  const std::vector<char> held = in_clamps(structure, position, body);
  H.prune([&](Eigen::Index row, Eigen::Index, double) { return held[static_cast<std::size_t>(row)] == 0; });
  return H;
}

std::vector<char> empty_rows(const Interpolation& H) {
  std::vector<char> empty;
  for (Eigen::Index row = 0; row < H.rows(); ++row)
    empty.push_back(H.outerIndexPtr()[row] == H.outerIndexPtr()[row + 1] ? 1 : 0);
  return empty;
}

std::vector<double> fastest_per_stiffness(const SolidModel& model, const Interpolation& H,
                                          const std::vector<double>& area, const std::vector<int>& body,
                                          int bodies, int dimension) {
  std::vector<double> fastest(static_cast<std::size_t>(bodies), 0.0);
  const Eigen::Map<const Eigen::ArrayXd> areas(area.data(), static_cast<Eigen::Index>(area.size()));
  // All bodies at once, because their motions are independent.
  Field x(dimension, H.rows());
  for (Eigen::Index k = 0; k < x.size(); ++k) x.data()[k] = 1 + 0.5 * std::sin(1.7 * static_cast<double>(k));
  for (int k = 0; k < iterations; ++k) {
    std::vector<double> before(fastest.size(), 0.0), after(fastest.size(), 0.0);
    const Field force = x * areas.sqrt().matrix().asDiagonal() * H;
    const Field next = model.acceleration_by(force) * H.transpose() * areas.sqrt().matrix().asDiagonal();
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      before[static_cast<std::size_t>(body[static_cast<std::size_t>(v)])] += x.col(v).squaredNorm();
      after[static_cast<std::size_t>(body[static_cast<std::size_t>(v)])] += next.col(v).squaredNorm();
    }
    for (std::size_t b = 0; b < fastest.size(); ++b)
      fastest[b] = before[b] > 0 ? std::sqrt(after[b] / before[b]) : 0;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      const double scale = std::sqrt(after[static_cast<std::size_t>(body[static_cast<std::size_t>(v)])]);
      x.col(v) = scale > 0 ? Field(next.col(v) / scale) : Field::Zero(dimension, 1);
    }
  }
  return fastest;
}

template Interpolation vertex_interpolation<2>(const SolidModel&, const Structure<2>&, const Field&,
                                               const std::vector<int>&);
template Interpolation vertex_interpolation<3>(const SolidModel&, const Structure<3>&, const Field&,
                                               const std::vector<int>&);

}  // namespace cosurge::contact
