#include "common/case/from_case.hpp"

#include "common/case/carriers.hpp"

namespace cosurge {

template <int dim>
Vec<dim> from_case(const google::protobuf::RepeatedField<double>& values) {
  if (values.empty()) return Vec<dim>::Zero();
  return Eigen::Map<const Vec<dim>>(values.data());
}

template <int dim>
Box<dim> from_case(const v1::Box& box) {
  return {from_case<dim>(box.min()), from_case<dim>(box.max())};
}

template <int dim>
Shape<dim> from_case(const v1::Shape& shape) {
  if (shape.vertex().empty())
    return Shape<dim>(Box<dim>(from_case<dim>(shape.min()), from_case<dim>(shape.max())));
  std::vector<Vec<dim>> corners;
  for (int v = 0; v + dim <= shape.vertex_size(); v += dim)
    corners.emplace_back(Eigen::Map<const Vec<dim>>(shape.vertex().data() + v));
  return Shape<dim>(corners);
}

template <int dim>
Motion<dim> from_case(const v1::WallMotion& motion) {
  const Vec<dim> pivot = from_case<dim>(motion.pivot());
  if (!motion.row().empty()) {
    PoseTable<dim> table;
    for (int k = 0; k < motion.row_size(); k += dim + 2) {
      table.time.push_back(motion.row(k));
      table.row.emplace_back(Eigen::Map<const Pose<dim>>(motion.row().data() + k + 1));
    }
    return Motion<dim>(std::move(table), pivot);
  }
  Pose<dim> amplitude;
  amplitude << from_case<dim>(motion.amplitude()), motion.angle();
  return Motion<dim>({.amplitude = amplitude,
                      .frequency = motion.frequency(),
                      .phase = motion.phase(),
                      .ramp = motion.ramp()},
                     pivot);
}

template <int dim>
Tank<dim> tank_from_case(const v1::Fluid& fluid) {
  return {.box = from_case<dim>(fluid.tank()), .motion = from_case<dim>(fluid.tank_motion())};
}

template <int dim>
std::vector<Obstacle<dim>> obstacles_from_case(const v1::Fluid& fluid) {
  std::vector<Obstacle<dim>> obstacles;
  for (const v1::Obstacle& obstacle : fluid.obstacle())
    obstacles.push_back({.shape = from_case<dim>(obstacle.shape()),
                         .motion = from_case<dim>(motion_of(fluid, obstacle)),
                         .with_tank = !obstacle.has_motion()});
  return obstacles;
}

template Vec<2> from_case<2>(const google::protobuf::RepeatedField<double>&);
template Vec<3> from_case<3>(const google::protobuf::RepeatedField<double>&);
template Box<2> from_case<2>(const v1::Box&);
template Box<3> from_case<3>(const v1::Box&);
template Shape<2> from_case<2>(const v1::Shape&);
template Shape<3> from_case<3>(const v1::Shape&);
template Motion<2> from_case<2>(const v1::WallMotion&);
template Motion<3> from_case<3>(const v1::WallMotion&);
template Tank<2> tank_from_case<2>(const v1::Fluid&);
template Tank<3> tank_from_case<3>(const v1::Fluid&);
template std::vector<Obstacle<2>> obstacles_from_case<2>(const v1::Fluid&);
template std::vector<Obstacle<3>> obstacles_from_case<3>(const v1::Fluid&);

}  // namespace cosurge
