// Several particles at a time.
#pragma once

#include <Eigen/Core>
#include <array>

namespace cosurge::particles {

/// The same number of several particles; arithmetic goes element by element in the machine's vector
/// registers.
using Lanes = Eigen::Array<double, 8, 1>;

template <int dim>
using LaneVec = std::array<Lanes, dim>;

/// A number of every slot of a BodyGrid.
using Slots = Eigen::ArrayXd;

inline Eigen::Map<const Lanes> at(const Slots& values, Eigen::Index i) {
  return Eigen::Map<const Lanes>(values.data() + i);
}

inline Eigen::Map<Lanes> at(Slots& values, Eigen::Index i) { return Eigen::Map<Lanes>(values.data() + i); }

}  // namespace cosurge::particles
