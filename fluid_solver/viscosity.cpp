#include "fluid_solver/viscosity.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace cosurge::fluid {

namespace {

/// The rotation with the angular momentum `momentum` of points of unit mass with these second moments.
Mat<2> rotation(const Mat<2>& momentum, const Mat<2>& moments) {
  const double spin = (momentum(1, 0) - momentum(0, 1)) / moments.trace();
  return (Mat<2>() << 0, -spin, spin, 0).finished();
}

Mat<3> rotation(const Mat<3>& momentum, const Mat<3>& moments) {
  const Vec<3> angular(momentum(2, 1) - momentum(1, 2), momentum(0, 2) - momentum(2, 0),
                       momentum(1, 0) - momentum(0, 1));
  const Mat<3> inertia = moments.trace() * Mat<3>::Identity() - moments;
  if (inertia.determinant() <= 1e-6 * std::pow(moments.trace(), 3)) return Mat<3>::Zero();  // all on a line
  const Vec<3> w = inertia.inverse() * angular;
  return (Mat<3>() << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0).finished();
}

/// Velocity gradient of the rigid rotation nearest to the motion of the points of walls and bodies around
/// point i of a first layer [1/s]; zero where they do not rotate.
template <int dim>
Mat<dim> spin_of_walls(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i) {
  int points = 1;
  Vec<dim> place = Vec<dim>::Zero(), velocity = particles.u[i];
  Mat<dim> moments = Mat<dim>::Zero(), momentum = Mat<dim>::Zero();  // sums of x x^T and u x^T
  neighbors.each(particles, i, [&](int j, const Vec<dim>& x_ij, double) {
    constexpr double same_face = 0.5;
    if (particles.kind[j] == Kind::fluid || particles.normal[j].dot(particles.normal[i]) < same_face) return;
    ++points;
    place += x_ij;
    velocity += particles.u[j];
    moments += x_ij * x_ij.transpose();
    momentum += particles.u[j] * x_ij.transpose();
  });
  if (momentum.isZero(0)) return Mat<dim>::Zero();
  moments -= place * place.transpose() / points;
  momentum -= velocity * place.transpose() / points;
  return rotation(momentum, moments);
}

}  // namespace

template <int dim>
FaceBefore<dim> face_before(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                            double spacing) {
  FaceBefore<dim> face;
  neighbors.each(particles, i, [&](int j, const Vec<dim>& x_ij, double) {
    if (particles.kind[j] == Kind::fluid || !has_pressure(particles.kind[j])) return;
    const double distance = std::max(-particles.normal[j].dot(x_ij) - spacing / 2, spacing / 2);
    if (distance < face.distance) face = {.place = j, .distance = distance};
  });
  if (face.place >= 0) face.spin = spin_of_walls(particles, neighbors, face.place);
  return face;
}

template <int dim>
BeyondFace<dim> beyond_face(const Particles<dim>& particles, int i, int j, const FaceBefore<dim>& face,
                            const Vec<dim>& kick) {
  const Vec<dim> u_ij = particles.u[j] + kick - particles.u[i];
  if (face.place < 0) return {.of_face = u_ij, .of_motion = u_ij};
  const Vec<dim> way = particles.x[i] - particles.x[j];
  const Vec<dim>& n = particles.normal[j];
  const double across = n.dot(way);
  const double factor = std::max(1.0, across / face.distance);
  return {.of_face = factor * (u_ij + face.spin * n * (across - face.distance)),
          .of_motion = factor * (u_ij + face.spin * way)};
}

template <int dim>
Vec<dim> velocity_laplacian(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                            const FaceBefore<dim>& face, const Vec<dim>& kick, double n0, double lambda0) {
  Vec<dim> sum = Vec<dim>::Zero();
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>&, double, double w) {
    sum += w * (particles.kind[j] == Kind::fluid ? Vec<dim>(particles.u[j] - particles.u[i])
                                                 : beyond_face(particles, i, j, face, kick).of_face);
  });
  return 2 * dim / (lambda0 * n0) * sum;
}

template FaceBefore<2> face_before<2>(const Particles<2>&, const Neighbors<2>&, int, double);
template FaceBefore<3> face_before<3>(const Particles<3>&, const Neighbors<3>&, int, double);
template BeyondFace<2> beyond_face<2>(const Particles<2>&, int, int, const FaceBefore<2>&, const Vec<2>&);
template BeyondFace<3> beyond_face<3>(const Particles<3>&, int, int, const FaceBefore<3>&, const Vec<3>&);
template Vec<2> velocity_laplacian<2>(const Particles<2>&, const Neighbors<2>&, int, const FaceBefore<2>&,
                                      const Vec<2>&, double, double);
template Vec<3> velocity_laplacian<3>(const Particles<3>&, const Neighbors<3>&, int, const FaceBefore<3>&,
                                      const Vec<3>&, double, double);

}  // namespace cosurge::fluid
