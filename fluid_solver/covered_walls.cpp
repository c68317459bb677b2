#include "fluid_solver/covered_walls.hpp"

namespace cosurge::fluid {

template <int dim>
std::vector<Cover> cover_walls(Particles<dim>& particles, const Neighbors<dim>& neighbors,
                               const Walls<dim>& walls, double spacing) {
  constexpr double touching = 1.1;  // spacings between centres; diagonal neighbours do not touch
  std::vector<Cover> covers;
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::wall) continue;
    const bool of_tank = walls.of_tank(particles.id[i]);
    Cover nearest{.wall = i, .by = -1};
    double least = touching * spacing;
    neighbors.each(particles, i, [&](int j, const Vec<dim>&, double r) {
      if (r >= least || particles.kind[j] == Kind::fluid) return;
      if (!of_body(particles.kind[j]) && !(of_tank && walls.moves_in_tank(particles.id[j]))) return;
      least = r;
      nearest.by = j;
    });
    if (nearest.by >= 0) covers.push_back(nearest);
  }
  for (const Cover& cover : covers)
    if (particles.kind[cover.by] != Kind::body_surface) particles.kind[cover.wall] = Kind::dummy;
  return covers;
}

template <int dim>
void follow_covers(Particles<dim>& particles, const std::vector<Cover>& covers) {
  for (const Cover& cover : covers) {
    particles.u[cover.wall] = particles.u[cover.by];
    particles.normal[cover.wall] = particles.normal[cover.by];
  }
}

template std::vector<Cover> cover_walls(Particles<2>&, const Neighbors<2>&, const Walls<2>&, double);
template std::vector<Cover> cover_walls(Particles<3>&, const Neighbors<3>&, const Walls<3>&, double);
template void follow_covers(Particles<2>&, const std::vector<Cover>&);
template void follow_covers(Particles<3>&, const std::vector<Cover>&);

}  // namespace cosurge::fluid
