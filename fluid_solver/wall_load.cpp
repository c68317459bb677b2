#include "fluid_solver/wall_load.hpp"

#include "fluid_solver/gauges.hpp"
#include "fluid_solver/particles_around.hpp"
#include "fluid_solver/point_hash.hpp"

namespace cosurge::fluid {
namespace {

template <int dim>
std::vector<FacePiece<dim>> pieces_of_mount(const Walls<dim>& walls, const ProbeMount& mount,
                                            double longest) {
  if (mount.on == ProbeMount::On::obstacle) return pieces_of(walls.obstacle(mount.number), longest);
  return pieces_of(walls.tank(), mount.axis, mount.upper, longest);
}

/// Whether a wall particle at x lies behind the face. Behind an edge of the tank it counts for the side
/// across the first of its axes, so that all sides together have every particle once.
template <int dim>
bool behind(const Walls<dim>& walls, const ProbeMount& mount, const Vec<dim>& x) {
  if (mount.on == ProbeMount::On::obstacle) return true;
  const Box<dim>& tank = walls.tank();
  for (int axis = 0; axis < mount.axis; ++axis)
    if (x[axis] < tank.min[axis] || x[axis] > tank.max[axis]) return false;
  return mount.upper ? x[mount.axis] > tank.max[mount.axis] : x[mount.axis] < tank.min[mount.axis];
}

}  // namespace

template <int dim>
WallLoad<dim>::WallLoad(const Mps<dim>& mps, const ProbeMount& mount, const Vec<dim>& about)
    : part_(mount.on == ProbeMount::On::obstacle ? static_cast<std::size_t>(mount.number) + 1 : 0),
      about_(about),
      spacing_(mps.spacing()) {
  const std::vector<WallParticle<dim>> sites = mps.walls().sites(part_);
  for (const WallParticle<dim>& site : sites)
    if (behind(mps.walls(), mount, site.place)) ids_.push_back(site.id);
  PointHash<dim> around(spacing_);
  for (const WallParticle<dim>& site : sites) around.add(site.place);
  for (const FacePiece<dim>& face : pieces_of_mount(mps.walls(), mount, 0.5 * spacing_)) {
    Piece piece{face, {}};
    const Vec<dim> centre = face.place - 0.5 * spacing_ * face.area.normalized();
    double sum = 0;
    around.near(centre, [&](std::int32_t k, double r) {
      const double share = (1 - r / spacing_) * (1 - r / spacing_);
      piece.behind.emplace_back(sites[static_cast<std::size_t>(k)].id, share);
      sum += share;
    });
    for (auto& [id, share] : piece.behind) share /= sum;
    pieces_.push_back(std::move(piece));
  }
}

template <int dim>
double WallLoad<dim>::pressure(const Mps<dim>& mps, const std::vector<std::int32_t>& place,
                               const Piece& piece, const Vec<dim>& x) const {
  if (piece.behind.empty()) return pressure_at(mps, x);
  const Particles<dim>& particles = mps.particles();
  const Vec<dim> slope = mps.slope_to_faces();
  double sum = 0;
  for (const auto& [id, share] : piece.behind) {
    const std::int32_t i = place[static_cast<std::size_t>(id)];
    sum += share * (particles.p[i] + mps.wetness(particles.p[i]) * slope.dot(x - particles.x[i]));
  }
  return sum;
}

/// Whether another wall, or a body, lies before the face at x.
template <int dim>
bool WallLoad<dim>::dry(const Mps<dim>& mps, const Vec<dim>& x, const Vec<dim>& normal, double t) const {
  constexpr double touching = 0.72;  // spacings: a lattice that the face touches has a site as near
  if (mps.walls().inside_other(part_, x + 0.25 * spacing_ * normal, t)) return true;
  if (mps.bodies().points() == 0) return false;
  bool touched = false;
  each_around(mps, Vec<dim>(x + 0.5 * spacing_ * normal), [&](int j, const Vec<dim>&, double r) {
    touched = touched || (of_body(mps.particles().kind[j]) && r < touching * spacing_);
  });
  return touched;
}

template <int dim>
Load<dim> WallLoad<dim>::read(const Mps<dim>& mps, const std::vector<std::int32_t>& place, double t) const {
  const Motion<dim>& motion = mps.walls().motion(part_);
  const Vec<dim> about = motion.place(about_, t);
  const Mat<dim> turned = motion.turned(t);
  Load<dim> load;
  for (const Piece& piece : pieces_) {
    const Vec<dim> x = motion.place(piece.place, t);
    const Vec<dim> area = turned * piece.area;
    if (const double p = pressure(mps, place, piece, x); p != 0 && !dry(mps, x, area.normalized(), t))
      load.add(x - about, -p * area);
  }
  for (const std::int32_t id : ids_) {
    const std::int32_t i = place[static_cast<std::size_t>(id)];
    if (const Vec<dim> force = mps.direct_force(i); !force.isZero())
      load.add(mps.particles().x[i] - about, force);
  }
  return load;
}

template class WallLoad<2>;
template class WallLoad<3>;

}  // namespace cosurge::fluid
