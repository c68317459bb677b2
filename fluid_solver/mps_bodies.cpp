// The structures in the water: where their points are, and the load on them.
#include <algorithm>

#include "common/error.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

template <int dim>
void Mps<dim>::move_bodies(const Field& displacement, const Field& velocity) {
  faces_ = bodies_.deformed(displacement);
  last_body_velocity_.resize(dim, bodies_.points());
  for (int k = 0; k < bodies_.points(); ++k) last_body_velocity_.col(k) = particles_.u[body_place_[k]];
  for (int k = 0; k < bodies_.points(); ++k) {
    particles_.x[body_place_[k]] = bodies_.position(k) + displacement.col(k);
    if (open_surface()) particles_.normal[body_place_[k]] = faces_.normal[k];
  }
  set_body_velocity(velocity);
}

template <int dim>
void Mps<dim>::set_body_velocity(const Field& velocity) {
  max_body_speed_ = 0;
  for (int k = 0; k < bodies_.points(); ++k) {
    particles_.u[body_place_[k]] = velocity.col(seen_[k]);
    max_body_speed_ = std::max(max_body_speed_, velocity.col(k).norm());
  }
  follow_covers(particles_, covers_);
}

/// Gives the bodies' points the velocity that the pressure was solved for: the predicted velocity plus the
/// response of the modes.
template <int dim>
void Mps<dim>::add_answer_of_modes() {
  const Field& change = added_mass_.velocity_change();
  for (Eigen::Index k = 0; k < change.cols(); ++k)
    particles_.u[body_place_[static_cast<std::size_t>(k)]] += change.col(seen_[static_cast<std::size_t>(k)]);
}

template <int dim>
void Mps<dim>::load(InterfaceLoad& load) const {
  for (int k = 0; k < bodies_.points(); ++k) {
    if (particles_.kind[body_place_[k]] != Kind::body_surface) {
      load.pressure[k] = 0;
      load.force.col(k) = film_pressure_.load(k) + direct_force(body_place_[k]);
      continue;
    }
    const double p = particles_.p[body_place_[k]];
    load.force.col(k) =
        -p * faces_.area[k] + face_load_[k] + film_pressure_.load(k) + direct_force(body_place_[k]);
    const double area = faces_.area[k].norm();
    load.pressure[k] = area > 0 ? p - face_load_[k].dot(faces_.normal[k]) / area : p;
  }
}

template <int dim>
Vec<dim> Mps<dim>::slope_to_faces() const {
  return open_surface() ? Vec<dim>(water_.density * water_.gravity) : Vec<dim>::Zero();
}

template <int dim>
double Mps<dim>::wetness(double p) const {
  const double full = 0.5 * water_.spacing * slope_to_faces().norm();
  return full > 0 ? std::clamp(p / full, 0.0, 1.0) : 0;
}

/// Sets the second term of eq. (15). The computed pressure belongs to the centre of a point, half a spacing
/// inside its face. Between the centre and a face at rest it changes by rho g . n l0 / 2. For an accelerating
/// face nothing is added: the source of the outermost points contains half of the jump of the Neumann
/// condition.
template <int dim>
void Mps<dim>::set_face_load() {
  const Vec<dim> change = 0.5 * water_.spacing * slope_to_faces();
  face_load_.assign(static_cast<std::size_t>(bodies_.points()), Vec<dim>::Zero());
  for (int k = 0; k < bodies_.points(); ++k) {
    if (particles_.kind[body_place_[k]] != Kind::body_surface) continue;
    face_load_[k] = -wetness(particles_.p[body_place_[k]]) * (faces_.spread[k] * change);
  }
}

/// Treats points that a wall or another body covers as inner points in this step.
template <int dim>
void Mps<dim>::close_covered_faces() {
  if (faces_.area.empty()) return;
  const std::vector<Openness<dim>> open =
      covered_faces_.find(bodies_, faces_, body_place_, particles_, neighbors_, water_.spacing);
  film_pressure_.find(bodies_, faces_, open, covered_faces_.film());
  bodies_.set_open(open, faces_);
  for (int k = 0; k < bodies_.points(); ++k) {
    const int i = body_place_[k];
    areas_[i] = faces_.area[k];
    if (bodies_.wet(k) && faces_.open[k] == 0) particles_.kind[i] = Kind::body_inner;
  }
}

template <int dim>
void Mps<dim>::locate_bodies() {
  body_place_.assign(static_cast<std::size_t>(bodies_.points()), -1);
  if (bodies_.points() > 0) areas_.resize(static_cast<std::size_t>(particles_.size()));
  for (int i = 0; i < particles_.size(); ++i) {
    const int point = particles_.id[i] - first_body_id_;
    if (point < 0) continue;
    body_place_[point] = i;
    if (!faces_.area.empty()) areas_[i] = faces_.area[point];
  }
  if (const auto gone = std::count(body_place_.begin(), body_place_.end(), -1); gone > 0)
    throw NumericalError(
        fmt::format("{} of {} points of the bodies have left the fluid's domain: the solid has become "
                    "unstable, or fluid.tank is too small",
                    gone, bodies_.points()));
}

template void Mps<2>::move_bodies(const Field&, const Field&);
template void Mps<3>::move_bodies(const Field&, const Field&);
template void Mps<2>::set_body_velocity(const Field&);
template void Mps<3>::set_body_velocity(const Field&);
template void Mps<2>::add_answer_of_modes();
template void Mps<3>::add_answer_of_modes();
template void Mps<2>::load(InterfaceLoad&) const;
template void Mps<3>::load(InterfaceLoad&) const;
template Vec<2> Mps<2>::slope_to_faces() const;
template Vec<3> Mps<3>::slope_to_faces() const;
template double Mps<2>::wetness(double) const;
template double Mps<3>::wetness(double) const;
template void Mps<2>::set_face_load();
template void Mps<3>::set_face_load();
template void Mps<2>::close_covered_faces();
template void Mps<3>::close_covered_faces();
template void Mps<2>::locate_bodies();
template void Mps<3>::locate_bodies();

}  // namespace cosurge::fluid
