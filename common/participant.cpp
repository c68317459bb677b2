#include "common/participant.hpp"

namespace cosurge {

InterfaceMotion InterfaceMotion::at_rest(int dimension, Eigen::Index points) {
  const Field zero = Field::Zero(dimension, points);
  return {.displacement = zero, .velocity = zero, .ramp_increment = zero, .modes = {}};
}

InterfaceLoad InterfaceLoad::zero(int dimension, Eigen::Index points) {
  return {.force = Field::Zero(dimension, points), .pressure = Eigen::VectorXd::Zero(points)};
}

}  // namespace cosurge
