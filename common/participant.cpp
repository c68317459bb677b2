#include "common/participant.hpp"

namespace cosurge {

Surface Surface::at_rest(int dimension, Eigen::Index points) {
  const Field zero = Field::Zero(dimension, points);
  return {.displacement = zero,
          .velocity = zero,
          .ramp_increment = zero,
          .modes = {},
          .force = zero,
          .pressure = Eigen::VectorXd::Zero(points)};
}

}  // namespace cosurge
