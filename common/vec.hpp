// Small vectors and matrices of a scene's dimension.
#pragma once

#include <Eigen/Core>

namespace cosurge {

template <int dim>
using Vec = Eigen::Matrix<double, dim, 1>;

template <int dim>
using Mat = Eigen::Matrix<double, dim, dim>;

}  // namespace cosurge
