#include "solid_solver/models/fem/fem_body.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace cosurge::fem {
template <int dim>
FemBody<dim>::FemBody(const Body<dim>& body, std::size_t index, double longest, const Elasticity& material,
                      const Vec<dim>& gravity)
    : material_(material),
      linear_dilatation_(material.lambda() > 0 && !material.plane_stress),
      mesh_(body, index, longest) {
  make_quadratures();
  number_unknowns();
  make_pattern();
  integrate_mass(gravity);
}

template <int dim>
void FemBody<dim>::make_quadratures() {
  using Linear = Eigen::Matrix<double, dim + 1, 1>;
  const auto samples = Element::gauss();
  quadratures_.resize(mesh_.even() ? 1 : static_cast<std::size_t>(mesh_.elements()));
  for (std::size_t e = 0; e < quadratures_.size(); ++e) {
    Nodal X = mesh_.corners(static_cast<Eigen::Index>(e));
    X.colwise() -= X.rowwise().mean().eval();
    Eigen::Matrix<double, dim + 1, dim + 1> moments = Eigen::Matrix<double, dim + 1, dim + 1>::Zero();
    for (std::size_t g = 0; g < samples.size(); ++g) {
      const auto G = Element::gradients(samples[g].xi);
      const Mat<dim> J = mesh_.even() ? Mat<dim>((0.5 * mesh_.side()).asDiagonal()) : Mat<dim>(X * G);
      const Vec<dim> x = X * Element::values(samples[g].xi);
      Quadrature& q = quadratures_[e][g];
      q = {.gradients = G * J.inverse(), .volume = samples[g].weight * J.determinant(), .linear = {}};
      q.linear << 1, x.cwiseQuotient(mesh_.side());
      moments += q.volume * q.linear * q.linear.transpose();
    }
    const Eigen::LLT<Eigen::Matrix<double, dim + 1, dim + 1>> factors(moments);
    for (Quadrature& q : quadratures_[e]) q.linear = factors.matrixL().solve(Linear(q.linear));
  }
}

template <int dim>
typename FemBody<dim>::Strains FemBody<dim>::strains(const Nodal& u, const Quadratures& points) const {
  Strains all;
  for (std::size_t g = 0; g < points.size(); ++g) all.H[g] = u * points[g].gradients;
  for (std::size_t g = 0; g < points.size(); ++g) all.dilatation[g] = dilatation<dim>(all.H[g], material_);
  if (!linear_dilatation_) return all;
  Eigen::Matrix<double, dim + 1, 1> fit = Eigen::Matrix<double, dim + 1, 1>::Zero();
  for (std::size_t g = 0; g < points.size(); ++g)
    fit += points[g].volume * all.dilatation[g] * points[g].linear;
  for (std::size_t g = 0; g < points.size(); ++g) all.dilatation[g] = fit.dot(points[g].linear);
  return all;
}

template <int dim>
void FemBody<dim>::number_unknowns() {
  unknown_.assign(static_cast<std::size_t>(mesh_.nodes() * dim), -1);
  for (Eigen::Index c = 0; c < mesh_.nodes() * dim; ++c) {
    if (mesh_.held(c / dim)[static_cast<std::size_t>(c % dim)]) continue;
    unknown_[static_cast<std::size_t>(c)] = unknowns();
    component_.push_back(c);
  }
}

template <int dim>
void FemBody<dim>::make_pattern() {
  const auto entry = [&](Eigen::Index e, int i) {
    return unknown_[static_cast<std::size_t>(mesh_.node(e, i / dim) * dim + i % dim)];
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e)
    for (int i = 0; i < components; ++i)
      for (int j = 0; j < components; ++j)
        if (entry(e, j) >= 0 && entry(e, i) >= entry(e, j))
          entries.emplace_back(static_cast<int>(entry(e, i)), static_cast<int>(entry(e, j)), 0.0);
  mass_.resize(unknowns(), unknowns());
  mass_.setFromTriplets(entries.begin(), entries.end());
  const auto slot_of = [&](Eigen::Index row, Eigen::Index column) -> Eigen::Index {
    if (column < 0 || row < column) return -1;
    const int* rows = mass_.innerIndexPtr();
    return std::lower_bound(rows + mass_.outerIndexPtr()[column], rows + mass_.outerIndexPtr()[column + 1],
                            static_cast<int>(row)) -
           rows;
  };
  slot_.reserve(static_cast<std::size_t>(mesh_.elements() * components * components));
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e)
    for (int j = 0; j < components; ++j)
      for (int i = 0; i < components; ++i) slot_.push_back(slot_of(entry(e, i), entry(e, j)));
}

template <int dim>
void FemBody<dim>::integrate_mass(const Vec<dim>& gravity) {
  const auto samples = Element::gauss();
  Field weight = Field::Zero(dim, mesh_.nodes());
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e) {
    Stiffness part = Stiffness::Zero();
    typename Element::Values share = Element::Values::Zero();
    for (std::size_t g = 0; g < samples.size(); ++g) {
      const typename Element::Values N = Element::values(samples[g].xi);
      const double mass = material_.density * quadratures(e)[g].volume;
      share += mass * N;
      for (int a = 0; a < Element::nodes; ++a)
        for (int b = 0; b < Element::nodes; ++b)
          for (int k = 0; k < dim; ++k) part(a * dim + k, b * dim + k) += mass * N[a] * N[b];
    }
    scatter(part, e, mass_);
    for (int a = 0; a < Element::nodes; ++a) weight.col(mesh_.node(e, a)) += share[a] * gravity;
  }
  weight_ = from_nodes(weight);
}

template <int dim>
void FemBody<dim>::scatter(const Stiffness& part, Eigen::Index element, Matrix& whole) const {
  const Eigen::Index* slot = slot_.data() + element * components * components;
  for (Eigen::Index k = 0; k < part.size(); ++k)
    if (slot[k] >= 0) whole.valuePtr()[slot[k]] += part.data()[k];
}

template <int dim>
typename FemBody<dim>::Nodal FemBody<dim>::gather(const Vector& u, Eigen::Index element) const {
  Nodal values;
  for (int a = 0; a < Element::nodes; ++a) {
    for (int k = 0; k < dim; ++k) {
      const Eigen::Index i = unknown_[static_cast<std::size_t>(mesh_.node(element, a) * dim + k)];
      values(k, a) = i < 0 ? 0 : u[i];
    }
  }
  return values;
}

template <int dim>
typename FemBody<dim>::InternalForce FemBody<dim>::internal_force(const Vector& u) const {
  InternalForce result{.force = Vector::Zero(unknowns()),
                       .gross = 0,
                       .least_volume = std::numeric_limits<double>::infinity(),
                       .flattest = 0};
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e) {
    const Strains strained = strains(gather(u, e), quadratures(e));
    Nodal force = Nodal::Zero();
    for (std::size_t g = 0; g < strained.H.size(); ++g) {
      const Quadrature& q = quadratures(e)[g];
      const Mat<dim> F = Mat<dim>::Identity() + strained.H[g];
      const Mat<dim> S = respond<dim>(strained.H[g], strained.dilatation[g], material_).S;
      force += q.volume * (F * S) * q.gradients.transpose();
      const double volume = F.determinant();
      if (volume < result.least_volume) result.flattest = e;
      result.least_volume = std::min(result.least_volume, volume);
    }
    result.gross = std::max(result.gross, force.cwiseAbs().maxCoeff());
    for (int a = 0; a < Element::nodes; ++a) {
      for (int k = 0; k < dim; ++k) {
        const Eigen::Index i = unknown_[static_cast<std::size_t>(mesh_.node(e, a) * dim + k)];
        if (i >= 0) result.force[i] += force(k, a);
      }
    }
  }
  return result;
}

template <int dim>
typename FemBody<dim>::Stiffness FemBody<dim>::element_tangent(const Nodal& u, Eigen::Index element) const {
  Stiffness part = Stiffness::Zero();
  const Strains strained = strains(u, quadratures(element));
  Eigen::Matrix<double, components, dim + 1> slope = Eigen::Matrix<double, components, dim + 1>::Zero();
  for (std::size_t g = 0; g < strained.H.size(); ++g) {
    const Quadrature& q = quadratures(element)[g];
    const Mat<dim> F = Mat<dim>::Identity() + strained.H[g];
    const Response<dim> material = respond<dim>(strained.H[g], strained.dilatation[g], material_);
    const double a_volume = linear_dilatation_ ? 0 : q.volume * material.a, b_volume = q.volume * material.b;
    const Mat<dim> FB = F * material.B, FBF = b_volume * FB * F.transpose();
    const Nodal turned = FB * q.gradients.transpose();  // F B g_a
    const typename Element::Gradients raised = q.gradients * material.B,
                                      pulled = q.volume * q.gradients * material.S;
    if (linear_dilatation_)
      slope += Eigen::Map<const Eigen::Matrix<double, components, 1>>(turned.data()) *
               (q.volume * q.linear.transpose());
    for (int b = 0; b < Element::nodes; ++b) {
      for (int a = b; a < Element::nodes; ++a) {
        Mat<dim> block = a_volume * turned.col(a) * turned.col(b).transpose() +
                         b_volume * turned.col(b) * turned.col(a).transpose() +
                         raised.row(a).dot(q.gradients.row(b)) * FBF;
        block.diagonal().array() += pulled.row(a).dot(q.gradients.row(b));
        part.template block<dim, dim>(a * dim, b * dim) += block;
      }
    }
  }
  if (linear_dilatation_) part += material_.lambda() * slope * slope.transpose();
  // Nodes of an element ascend as their unknowns do, so that the lower triangle needs no other block.
  return part;
}

template <int dim>
Matrix FemBody<dim>::tangent(const Vector& u) const {
  Matrix whole = mass_;
  whole.coeffs().setZero();
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e) scatter(element_tangent(gather(u, e), e), e, whole);
  return whole;
}

template <int dim>
double FemBody<dim>::elastic_energy(const Vector& u) const {
  double energy = 0;
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e) {
    const Strains strained = strains(gather(u, e), quadratures(e));
    for (std::size_t g = 0; g < strained.H.size(); ++g)
      energy +=
          quadratures(e)[g].volume * respond<dim>(strained.H[g], strained.dilatation[g], material_).energy;
  }
  return energy;
}

template <int dim>
Vector FemBody<dim>::momentum(const Vector& v) const {
  return mass_.template selfadjointView<Eigen::Lower>() * v;
}

template <int dim>
Field FemBody<dim>::inertia(const Field& acceleration) const {
  const auto samples = Element::gauss();
  Field force = Field::Zero(dim, mesh_.nodes());
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e) {
    Nodal a, f = Nodal::Zero();
    for (int n = 0; n < Element::nodes; ++n) a.col(n) = acceleration.col(mesh_.node(e, n));
    for (std::size_t g = 0; g < samples.size(); ++g) {
      const typename Element::Values N = Element::values(samples[g].xi);
      f += material_.density * quadratures(e)[g].volume * (a * N) * N.transpose();
    }
    for (int n = 0; n < Element::nodes; ++n)
      for (int k = 0; k < dim; ++k) force(k, mesh_.node(e, n)) += f(k, n);
  }
  return force;
}

template <int dim>
typename FemBody<dim>::Deformation FemBody<dim>::deformation(const Vector& u) const {
  const Vec<dim> scale = 2 / mesh_.side().array();
  std::vector<typename Element::Gradients> at_nodes;
  for (int a = 0; a < Element::nodes && mesh_.even(); ++a)
    at_nodes.push_back(Element::gradients(Element::place(a).template cast<double>().array() - 1) *
                       scale.asDiagonal());
  Deformation largest;
  double rotation_squared = 0;
  const auto add = [&](const Mat<dim>& H) {
    const Mat<dim> turn = 0.5 * (H - H.transpose()), strain = 0.5 * (H + H.transpose());
    rotation_squared = std::max(rotation_squared, 0.5 * turn.squaredNorm());
    // No principal strain is larger than this norm.
    if (strain.squaredNorm() <= largest.strain * largest.strain) return;
    const auto principal =
        Eigen::SelfAdjointEigenSolver<Mat<dim>>().computeDirect(strain, Eigen::EigenvaluesOnly).eigenvalues();
    largest.strain = std::max(largest.strain, principal.cwiseAbs().maxCoeff());
  };
  for (Eigen::Index e = 0; e < mesh_.elements(); ++e) {
    const Nodal moved = gather(u, e);
    for (const auto& G : at_nodes) add(moved * G);
    for (const Quadrature& q : quadratures(e))
      if (!mesh_.even()) add(moved * q.gradients);
  }
  largest.rotation = std::sqrt(rotation_squared);
  return largest;
}

template <int dim>
Mat<dim> FemBody<dim>::displacement_gradient(const Vector& u, const typename Mesh<dim>::Place& place) const {
  const Nodal moved = gather(u, place.element);
  if (mesh_.even())
    return moved * Element::gradients(place.xi) * Vec<dim>(2 / mesh_.side().array()).asDiagonal();
  const double outermost = std::sqrt(0.6);
  const auto G = Element::gradients(place.xi.cwiseMax(-outermost).cwiseMin(outermost));
  return moved * G * Mat<dim>(mesh_.corners(place.element) * G).inverse();
}

template <int dim>
Vector FemBody<dim>::from_nodes(const Eigen::Ref<const Field>& values) const {
  Vector vector(unknowns());
  for (Eigen::Index i = 0; i < unknowns(); ++i) {
    const Eigen::Index c = component_[static_cast<std::size_t>(i)];
    vector[i] = values(c % dim, c / dim);
  }
  return vector;
}

template <int dim>
Field FemBody<dim>::to_nodes(const Vector& values) const {
  Field field = Field::Zero(dim, mesh_.nodes());
  for (Eigen::Index i = 0; i < unknowns(); ++i)
    field.data()[component_[static_cast<std::size_t>(i)]] = values[i];
  return field;
}

template class FemBody<2>;
template class FemBody<3>;

}  // namespace cosurge::fem
