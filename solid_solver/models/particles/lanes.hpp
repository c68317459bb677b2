// Several particles at a time.
#pragma once

#include <Eigen/Core>
#include <array>

namespace cosurge::particles {

/// One value for each of several particles; arithmetic is elementwise in vector registers.
using Lanes = Eigen::Array<double, 8, 1>;

template <int dim>
using LaneVec = std::array<Lanes, dim>;

/// x * y, in the plane its one component.
inline std::array<Lanes, 1> cross(const LaneVec<2>& x, const LaneVec<2>& y) {
  return {x[0] * y[1] - x[1] * y[0]};
}

inline LaneVec<3> cross(const LaneVec<3>& x, const LaneVec<3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// One value for every slot of a BodyGrid.
using Slots = Eigen::ArrayXd;

inline Eigen::Map<const Lanes> at(const Slots& values, Eigen::Index i) {
  return Eigen::Map<const Lanes>(values.data() + i);
}

inline Eigen::Map<Lanes> at(Slots& values, Eigen::Index i) { return Eigen::Map<Lanes>(values.data() + i); }

}  // namespace cosurge::particles
