// Regions and motions of a case as the geometry has them.
#pragma once

#include "common/geometry/motion.hpp"
#include "common/geometry/shape.hpp"
#include "common/geometry/tank.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// A vector of a checked case; zero where the case has none.
template <int dim>
Vec<dim> from_case(const google::protobuf::RepeatedField<double>& values);

template <int dim>
Box<dim> from_case(const v1::Box& box);

template <int dim>
Shape<dim> from_case(const v1::Shape& shape);

template <int dim>
Motion<dim> from_case(const v1::WallMotion& motion);

/// The tank of the water, and the obstacles in it, which move with the tank unless the case says otherwise.
template <int dim>
Tank<dim> tank_from_case(const v1::Fluid& fluid);

template <int dim>
std::vector<Obstacle<dim>> obstacles_from_case(const v1::Fluid& fluid);

}  // namespace cosurge
