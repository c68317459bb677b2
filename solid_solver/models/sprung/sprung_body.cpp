#include "solid_solver/models/sprung/sprung_body.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "solid_solver/shape_moments.hpp"

namespace cosurge::sprung {
namespace {

constexpr double resolved = 0.05;  // rad of the rotation's oscillation a sub-step: its period is 2e-4 long
constexpr int most_substeps = 1000;

template <int dim>
Vec<dim> pivot_of(const v1::SolidSprung& parameters, const ShapeMoments<dim>& moments) {
  if (parameters.pivot_size() == 0) return moments.centre;
  require(parameters.pivot_size() == dim, "solid.sprung.pivot: has {} components, must have {}",
          parameters.pivot_size(), dim);
  return Eigen::Map<const Vec<dim>>(parameters.pivot().data());
}

}  // namespace

template <int dim>
SprungBody<dim>::SprungBody(const v1::Body& body, int index, const v1::SolidSprung& parameters,
                            double density, const Vec<dim>& gravity)
    : shape_(shape_of(body)), gravity_(gravity) {
  const ShapeMoments<dim> moments(shape_);
  pivot_ = pivot_of(parameters, moments);
  arm_to_centre_ = moments.centre - pivot_;
  length_ = (shape_.bounds().max - shape_.bounds().min).maxCoeff();
  mass_ = parameters.has_mass() ? parameters.mass() : density * moments.volume;
  Eigen::Matrix<double, dim, nodes> slopes =
      Eigen::Matrix<double, dim, nodes>::Zero();  // of the coefficients [1/m]
  slopes.col(0).setConstant(-1 / length_);
  slopes.template rightCols<dim>().diagonal().setConstant(1 / length_);
  const Coefficients centre = coefficients(moments.centre);
  nodal_mass_ =
      mass_ * (centre * centre.transpose() + slopes.transpose() * moments.second * slopes / moments.volume);
  const double inertia = mass_ * (moments.second.trace() / moments.volume + arm_to_centre_.squaredNorm());
  require(parameters.spring_size() > 0, "solid.sprung.spring: missing; choose solid.model = \"rigid\"");
  for (const v1::Spring& spring : parameters.spring()) free_motion(spring, inertia, index);
  const bool moves =
      std::any_of(translations_.begin(), translations_.end(), [](const auto& t) { return t.free; });
  require(!turning_ || !moves || arm_to_centre_.isZero(1e-9 * length_),
          "solid.sprung.pivot: solid.body.{} must turn about its centre of mass where it is free to move "
          "along x or y",
          index);
}

template <int dim>
void SprungBody<dim>::free_motion(const v1::Spring& spring, double inertia, int index) {
  const std::string& word = v1::Spring::Motion_Name(spring.motion());
  if (spring.motion() == v1::Spring::turn) {
    require(dim == 2, "solid.sprung: bodies turn in scenes of two dimensions only");
    require(!turning_, "solid.sprung.spring: two for \"{}\"", word);
    turning_ = Turning{.inertia = inertia,
                       .stiffness = spring.stiffness(),
                       .damping = spring.damping(),
                       .preload = spring.preload()};
    return;
  }
  require(spring.motion() < dim, "solid.sprung.spring: \"{}\" in a scene of {} dimensions (solid.body.{})",
          word, dim, index);
  Translation& translation = translations_[static_cast<std::size_t>(spring.motion())];
  require(!translation.free, "solid.sprung.spring: two for \"{}\"", word);
  translation = {.free = true,
                 .stiffness = spring.stiffness(),
                 .damping = spring.damping(),
                 .preload = spring.preload(),
                 .state = {}};
}

template <int dim>
typename SprungBody<dim>::Coefficients SprungBody<dim>::coefficients(const Vec<dim>& x) const {
  Coefficients c;
  c.template tail<dim>() = (x - pivot_) / length_;
  c[0] = 1 - c.template tail<dim>().sum();
  return c;
}

template <int dim>
Field SprungBody<dim>::position() const {
  Field at = pivot_.replicate(1, nodes);
  for (int k = 0; k < dim; ++k) at(k, 1 + k) += length_;
  return at;
}

template <int dim>
int SprungBody<dim>::advance(double window, const Nodal& first, const Nodal& last) {
  ramp_increment_.setZero();
  for (int k = 0; k < dim; ++k) {
    Translation& t = translations_[static_cast<std::size_t>(k)];
    if (!t.free) continue;
    const double steady = t.preload / mass_ + gravity_[k];
    OscillatorStep(t.stiffness / mass_, t.damping / mass_, window)
        .advance(t.state, first.row(k).sum() / mass_ + steady, last.row(k).sum() / mass_ + steady);
    ramp_increment_.row(k).setConstant(t.state.ramp_increment);
  }
  return turning_ ? turn(window, first, last) : 1;
}

template <int dim>
int SprungBody<dim>::turn(double window, const Nodal& first, const Nodal& last) {
  const double omega = std::sqrt(turning_->stiffness / turning_->inertia);
  const int substeps =
      static_cast<int>(std::clamp(std::ceil(omega * window / resolved), 1.0, 1.0 * most_substeps));
  for (int k = 0; k < substeps; ++k) {
    const double s = (k + 0.5) / substeps;
    const Nodal before = turned_arms();
    turning_->step(couple(first + s * (last - first)), window / substeps);
    ramp_increment_ += s * (turned_arms() - before);
  }
  return substeps;
}

template <int dim>
Couple SprungBody<dim>::couple(const Nodal& load) const {
  Couple sum;
  if constexpr (dim == 2) {
    const auto add = [&](const Vec<2>& X, const Vec<2>& f) {
      sum.across += X[0] * f[1] - X[1] * f[0];
      sum.along += X.dot(f);
    };
    for (int k = 0; k < dim; ++k) add(length_ * Vec<dim>::Unit(k), load.col(1 + k));
    add(arm_to_centre_, mass_ * gravity_);
  }
  return sum;
}

template <int dim>
typename SprungBody<dim>::Nodal SprungBody<dim>::turned_arms() const {
  Nodal moved = Nodal::Zero();
  if constexpr (dim == 2) {
    if (!turning_) return moved;
    const double sine = std::sin(turning_->angle), half = std::sin(0.5 * turning_->angle);
    const double lag = -2 * half * half;  // cos - 1
    moved.col(1) << length_ * lag, length_ * sine;
    moved.col(2) << -length_ * sine, length_ * lag;
  }
  return moved;
}

template <int dim>
std::vector<NodalMode> SprungBody<dim>::modes() const {
  std::vector<NodalMode> all;
  for (int k = 0; k < dim; ++k) {
    const Translation& translation = translations_[static_cast<std::size_t>(k)];
    if (!translation.free) continue;
    Field shape = Field::Zero(dim, nodes);
    shape.row(k).setOnes();
    all.push_back({.shape = shape, .mass = mass_, .omega_squared = translation.stiffness / mass_});
  }
  if (turning_) {
    Field shape = Field::Zero(dim, nodes);  // of the arms, by a small angle
    shape(1, 1) = length_;
    shape(0, 2) = -length_;
    all.push_back({.shape = shape,
                   .mass = turning_->inertia,
                   .omega_squared = turning_->stiffness / turning_->inertia});
  }
  return all;
}

template <int dim>
Field SprungBody<dim>::displacement() const {
  Nodal moved = turned_arms();
  for (int k = 0; k < dim; ++k)
    moved.row(k).array() += translations_[static_cast<std::size_t>(k)].state.position;
  return moved;
}

template <int dim>
Field SprungBody<dim>::velocity() const {
  Nodal v = Nodal::Zero();
  if constexpr (dim == 2) {
    if (turning_) {
      const double c = length_ * turning_->speed * std::cos(turning_->angle);
      const double s = length_ * turning_->speed * std::sin(turning_->angle);
      v.col(1) << -s, c;
      v.col(2) << -c, -s;
    }
  }
  for (int k = 0; k < dim; ++k) v.row(k).array() += translations_[static_cast<std::size_t>(k)].state.velocity;
  return v;
}

template <int dim>
Energies SprungBody<dim>::energies() const {
  const auto spring = [](double stiffness, double preload, double x) {
    return 0.5 * stiffness * x * x - preload * x;
  };
  Energies sum;
  for (const Translation& t : translations_) {
    sum.kinetic += 0.5 * mass_ * t.state.velocity * t.state.velocity;
    sum.elastic += spring(t.stiffness, t.preload, t.state.position);
  }
  if (turning_) {
    sum.kinetic += 0.5 * turning_->inertia * turning_->speed * turning_->speed;
    sum.elastic += spring(turning_->stiffness, turning_->preload, turning_->angle);
  }
  sum.gravity = -mass_ * gravity_.dot(displacement() * coefficients(pivot_ + arm_to_centre_));
  return sum;
}

template <int dim>
double SprungBody<dim>::max_speed() const {
  const Field v = velocity();
  double fastest = 0;
  for (const auto& facet : shape_.facets())
    for (const Vec<dim>& x : facet) fastest = std::max(fastest, (v * coefficients(x)).norm());
  if (!shape_.is_box()) return fastest;
  const Box<dim>& box = shape_.bounds();
  for (int corner = 0; corner < 1 << dim; ++corner) {
    Vec<dim> x;
    for (int k = 0; k < dim; ++k) x[k] = (corner >> k & 1) != 0 ? box.max[k] : box.min[k];
    fastest = std::max(fastest, (v * coefficients(x)).norm());
  }
  return fastest;
}

template <int dim>
void SprungBody<dim>::save(StateWriter& state) const {
  for (const Translation& t : translations_) {
    state.put(t.state.position);
    state.put(t.state.velocity);
  }
  state.put(turning_ ? turning_->angle : 0.0);
  state.put(turning_ ? turning_->speed : 0.0);
  state.put(ramp_increment_);
}

template <int dim>
void SprungBody<dim>::restore(StateReader& state) {
  for (Translation& t : translations_) {
    state.get(t.state.position);
    state.get(t.state.velocity);
  }
  double angle = 0, speed = 0;
  state.get(angle);
  state.get(speed);
  if (turning_) {
    turning_->angle = angle;
    turning_->speed = speed;
  }
  state.get(ramp_increment_);
}

template class SprungBody<2>;
template class SprungBody<3>;

}  // namespace cosurge::sprung
