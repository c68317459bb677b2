// A tank with water and a body in it, for the pressure equation.
#pragma once

#include "common/case/from_case.hpp"
#include "fluid_solver/bodies.hpp"
#include "fluid_solver/pressure/poisson_equation.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid::test {

constexpr double l0 = 0.01;
constexpr double rho = 1000;
constexpr double g = 9.81;
constexpr double dt = 1e-3;
constexpr double single = 2e-7;  // relative rounding of a sum of weights in single precision

struct SceneParameters {
  double water = 0.16;  ///< depth [m]
  double disorder = 0;  ///< [l0]
  double compressibility = 1e-20;
  const v1::Solid* solid = nullptr;
  bool open_surface = false;
};

/// A tank with water and a body in it, its free surface found and its pressure equation with no source.
template <int dim>
struct Tank {
  explicit Tank(const SceneParameters& p)
      : box(Vec<dim>::Zero(), Vec<dim>::Constant(0.12)),
        cloud{.particles = {}, .neighbors = Neighbors<dim>(domain(p), 2.1 * l0)},
        equation({.spacing = l0,
                  .re = 4 * l0,
                  .density = rho,
                  .compressibility = p.compressibility,
                  .gravity = -g * Vec<dim>::Unit(dim - 1),
                  .open_surface = p.open_surface}) {
    box.max[dim - 1] = p.water + 0.04;
    fill_with_water(p);
    walls_of<dim>(box, l0).add_to(cloud.particles);
    first_body = cloud.particles.size();
    if (p.solid != nullptr) bodies = bodies_of<dim>(*p.solid, box, l0);
    for (int k = 0; k < bodies.points(); ++k)
      cloud.particles.add(bodies.wet(k) ? Kind::body_surface : Kind::body_inner, bodies.position(k));
    cloud.neighbors.rebuild(cloud.particles);
    if (p.open_surface)
      density_and_lone_particles(cloud.particles, cloud.neighbors);
    else
      density_and_free_surface(cloud.particles, cloud.neighbors, reference_values<dim>(2.1 * l0, l0).n0,
                               {.beta = 0.97, .delta = 0.2 * l0});
    const auto size = static_cast<std::size_t>(cloud.particles.size());
    areas.assign(size, Vec<dim>::Zero());
    const Interface interface = bodies.interface();
    for (int i = 0; i < cloud.particles.size(); ++i)
      if (cloud.particles.id[i] >= first_body)
        areas[i] = interface.area.col(cloud.particles.id[i] - first_body);
    equation.assemble(cloud.particles, cloud.neighbors.grid(), areas, dt);
    equation.set_source(std::vector<double>(size, 0.0));
  }

  Box<dim> domain(const SceneParameters& p) const {
    Box<dim> inner = box;
    inner.max[dim - 1] = p.water + 0.04;
    return walls_of<dim>(inner, l0).domain();
  }

  void fill_with_water(const SceneParameters& p) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-p.disorder * l0, p.disorder * l0);
    Box<dim> water = box;
    water.max[dim - 1] = p.water;
    for (Vec<dim> x : fill(water, l0)) {
      if (p.solid != nullptr && from_case<dim>(p.solid->body(0).box()).contains(x)) continue;
      if (p.disorder > 0)
        for (double& coordinate : x) coordinate += shift(random);
      cloud.particles.add(Kind::fluid, x);
    }
  }

  Box<dim> box;
  Cloud<dim> cloud;
  Bodies<dim> bodies;
  int first_body = 0;
  std::vector<Vec<dim>> areas;
  PoissonEquation<dim> equation;
};

}  // namespace cosurge::fluid::test
