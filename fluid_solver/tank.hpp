// The tank: its walls, and the domain that the particles live in.
#pragma once

#include "common/lattice.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// Adds wall and dummy particles around `tank`: floor and side walls, one layer with pressure and
/// `dummy_layers` behind it, corners filled; open at the top (the last coordinate).
template <int dim>
void add_tank(Particles<dim>& particles, const Box<dim>& tank, int dummy_layers, double spacing);

/// Where particles may be: the tank with its walls, and as much again above its open top.
template <int dim>
Box<dim> tank_domain(const Box<dim>& tank, int dummy_layers, double spacing);

}  // namespace cosurge::fluid
