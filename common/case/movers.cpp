#include "common/case/movers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"

namespace cosurge {

template <int dim>
std::vector<Vec<dim>> corners_of(const Box<dim>& box) {
  std::vector<Vec<dim>> corners;
  for (int corner = 0; corner < 1 << dim; ++corner) {
    Vec<dim> x;
    for (int k = 0; k < dim; ++k) x[k] = (corner >> k & 1) != 0 ? box.max[k] : box.min[k];
    corners.push_back(x);
  }
  return corners;
}

template <int dim>
double Mover<dim>::speed(double t) const {
  double fastest = 0;
  for (const Vec<dim>& X : corners_of(box)) fastest = std::max(fastest, motion.velocity(X, t).norm());
  return fastest;
}

template <int dim>
std::vector<Mover<dim>> movers_of(const v1::Case& the_case) {
  std::vector<Mover<dim>> movers;
  const v1::Fluid& fluid = the_case.fluid();
  const auto add = [&](const std::string& key, const v1::WallMotion& motion, const Box<dim>& box) {
    Mover<dim> mover{.key = key, .prescribed = &motion, .motion = from_case<dim>(motion), .box = box};
    if (mover.motion.moves()) movers.push_back(std::move(mover));
  };
  if (fluid.has_tank_motion()) add("fluid.tank_motion", fluid.tank_motion(), from_case<dim>(fluid.tank()));
  for (int i = 0; i < fluid.obstacle_size(); ++i)
    if (fluid.obstacle(i).has_motion())
      add(fmt::format("fluid.obstacle.{}.motion", i), fluid.obstacle(i).motion(),
          from_case<dim>(fluid.obstacle(i).shape()).bounds());
  for (int i = 0; i < the_case.solid().body_size(); ++i)
    if (the_case.solid().body(i).has_motion())
      add(fmt::format("solid.body.{}.motion", i), the_case.solid().body(i).motion(),
          from_case<dim>(shape_of(the_case.solid().body(i))).bounds());
  return movers;
}

namespace {

template <int dim>
std::vector<double> speeds(const v1::Case& the_case) {
  constexpr int instants = 500;
  std::vector<Mover<dim>> movers = movers_of<dim>(the_case);
  std::erase_if(movers,
                [&](const auto& mover) { return mover.prescribed == &the_case.fluid().tank_motion(); });
  std::vector<double> fastest(movers.empty() ? 0 : instants, 0.0);
  for (std::size_t k = 0; k < fastest.size(); ++k)
    for (const Mover<dim>& mover : movers)
      fastest[k] = std::max(fastest[k],
                            mover.speed((static_cast<double>(k) + 0.5) / instants * the_case.time().end()));
  return fastest;
}

}  // namespace

std::vector<double> driven_speeds(const v1::Case& the_case) {
  return the_case.dimension() == 2 ? speeds<2>(the_case) : speeds<3>(the_case);
}

template std::vector<Vec<2>> corners_of<2>(const Box<2>&);
template std::vector<Vec<3>> corners_of<3>(const Box<3>&);
template struct Mover<2>;
template struct Mover<3>;
template std::vector<Mover<2>> movers_of<2>(const v1::Case&);
template std::vector<Mover<3>> movers_of<3>(const v1::Case&);

}  // namespace cosurge
