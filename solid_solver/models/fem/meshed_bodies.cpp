#include "solid_solver/models/fem/meshed_bodies.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/geometry/body_sites.hpp"

namespace cosurge::fem {
namespace {

constexpr double rounding = 1e-6;  // [spacings]

}  // namespace

template <int dim>
MeshedBodies<dim>::MeshedBodies(const Structure<dim>& structure)
    : material_(structure.material), spacing_(structure.spacing) {
  first_.push_back(0);
  for (std::size_t b = 0; b < structure.bodies.size(); ++b) {
    const Body<dim>& body = structure.bodies[b];
    bodies_.emplace_back(body, b, structure.element, material_, structure.gravity);
    const Mesh<dim>& mesh = bodies_.back().mesh();
    first_.push_back(first_.back() + mesh.nodes());
    const BodySites<dim> sites(body.shape, spacing_);
    for (const Vec<dim>& x : sites.all())
      sites_.push_back({.body = b, .position = x, .place = mesh.place(x)});
  }
}

template <int dim>
Interpolation MeshedBodies<dim>::interpolation(const Field& position, const std::vector<int>& body) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index point = 0; point < position.cols(); ++point) {
    const Vec<dim> x = position.col(point);
    const auto b = static_cast<std::size_t>(body[static_cast<std::size_t>(point)]);
    const Mesh<dim>& mesh = bodies_.at(b).mesh();
    if (mesh.only_in_clamp(x)) continue;
    require(mesh.outside(x) <= (0.5 + rounding) * spacing_,
            "solid: the interface point ({}) lies {:.3g} m outside its body {}",
            fmt::join(x.begin(), x.end(), ", "), mesh.outside(x), b);
    const auto place = mesh.place(x);
    const auto N = QuadraticElement<dim>::values(place.xi);
    for (int a = 0; a < N.size(); ++a)
      entries.emplace_back(static_cast<int>(point), static_cast<int>(first_[b] + mesh.node(place.element, a)),
                           N[a]);
  }
  Interpolation H(position.cols(), nodes());
  H.setFromTriplets(entries.begin(), entries.end());
  return H;
}

template <int dim>
Vector MeshedBodies<dim>::of_body(std::size_t b, const Field& nodal) const {
  return bodies_[b].from_nodes(nodal.middleCols(first_[b], first_[b + 1] - first_[b]));
}

template <int dim>
Field MeshedBodies<dim>::to_nodes(const Vectors& values) const {
  Field all(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    all.middleCols(first_[b], first_[b + 1] - first_[b]) = bodies_[b].to_nodes(values[b]);
  return all;
}

template <int dim>
NodeLayout MeshedBodies<dim>::layout() const {
  NodeLayout layout{.position = Field(dim, nodes()), .body = {}, .particle_body = {}};
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Eigen::Index count = first_[b + 1] - first_[b];
    layout.position.middleCols(first_[b], count) = bodies_[b].mesh().position();
    layout.body.insert(layout.body.end(), static_cast<std::size_t>(count), static_cast<int>(b));
  }
  for (const Site& site : sites_) layout.particle_body.push_back(static_cast<int>(site.body));
  return layout;
}

template <int dim>
Field MeshedBodies<dim>::acceleration_by(const Field& load) const {
  Vectors all;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Eigen::ConjugateGradient<Matrix, Eigen::Lower> mass(bodies_[b].mass());
    all.emplace_back(mass.solve(of_body(b, load)));
  }
  return to_nodes(all);
}

template <int dim>
Field MeshedBodies<dim>::inertia(const Field& acceleration) const {
  Field all(dim, nodes());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Eigen::Index count = first_[b + 1] - first_[b];
    all.middleCols(first_[b], count) = bodies_[b].inertia(acceleration.middleCols(first_[b], count));
  }
  return all;
}

template <int dim>
typename FemBody<dim>::Deformation MeshedBodies<dim>::deformation(const Vectors& u) const {
  typename FemBody<dim>::Deformation largest;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto one = bodies_[b].deformation(u[b]);
    largest.rotation = std::max(largest.rotation, one.rotation);
    largest.strain = std::max(largest.strain, one.strain);
  }
  return largest;
}

template <int dim>
double MeshedBodies<dim>::max_speed(const Vectors& v) const {
  return to_nodes(v).colwise().norm().maxCoeff();
}

template <int dim>
void MeshedBodies<dim>::check_motion(const Window& window, const Vectors& v) const {
  const double limit = material_.pressure_speed();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Field velocity = bodies_[b].to_nodes(v[b]);
    const Vec<dim> mean = velocity.rowwise().mean();
    for (Eigen::Index n = 0; n < velocity.cols(); ++n) {
      const double speed = (velocity.col(n) - mean).norm();
      if (speed <= limit) continue;  // false for NaN
      const Vec<dim> x = bodies_[b].mesh().position().col(n);
      throw NumericalError(
          fmt::format("solid: the node at ({:.6g}) of body {}, when undeformed, moves at {:.4g} m/s relative "
                      "to the body's mean in the window from t = {:.6g} s; the limit is {:.4g} m/s, the wave "
                      "speed of the material. The load may alternate from window to window (coupling.load = "
                      "\"ramped\", a shorter time.window), or the body is too soft or too light",
                      fmt::join(x.begin(), x.end(), ", "), b, speed, window.start, limit));
    }
  }
}

template <int dim>
Snapshot MeshedBodies<dim>::frame(const Vectors& u, const Vectors& v) const {
  Array position{.name = "solid_position", .unit = "m", .components = dim, .values = {}};
  Array velocity{.name = "solid_velocity", .unit = "m/s", .components = dim, .values = {}};
  Array stress{.name = "solid_von_mises", .unit = "Pa", .components = 1, .values = {}};
  const Field q = to_nodes(u), qdot = to_nodes(v);
  for (const Site& site : sites_) {
    const FemBody<dim>& body = bodies_[site.body];
    const auto N = QuadraticElement<dim>::values(site.place.xi);
    Vec<dim> x = site.position, xdot = Vec<dim>::Zero();
    for (int a = 0; a < N.size(); ++a) {
      const Eigen::Index node = first_[site.body] + body.mesh().node(site.place.element, a);
      x += N[a] * q.col(node);
      xdot += N[a] * qdot.col(node);
    }
    for (int k = 0; k < dim; ++k) {
      position.values.push_back(static_cast<float>(x[k]));
      velocity.values.push_back(static_cast<float>(xdot[k]));
    }
    const Mat<dim> F = Mat<dim>::Identity() + body.displacement_gradient(u[site.body], site.place);
    stress.values.push_back(static_cast<float>(von_mises_stress<dim>(F, material_)));
  }
  return {std::move(position), std::move(velocity), std::move(stress)};
}

template class MeshedBodies<2>;
template class MeshedBodies<3>;

}  // namespace cosurge::fem
