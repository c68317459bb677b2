#include "solid_solver/point_modes.hpp"

#include <Eigen/SVD>

#include "solid_solver/models/make_model.hpp"
#include "solid_solver/oscillator.hpp"

namespace cosurge {

template <int dim>
PointModes::PointModes(const Structure<dim>& structure, const Interface& interface, const SolidModel& model,
                       int count)
    : interface_(interface), count_(count), of_model_(!model.modes(count).empty()) {
  for (const Body<dim>& body : structure.bodies) {
    Turning& turning =
        turnings_.emplace_back(Turning{.with_carrier = {}, .with_points = !of_model_ && !body.held});
    if (body.carrier.moves())
      turning.with_carrier = [carrier = body.carrier](double t) -> Eigen::MatrixXd {
        return carrier.turned(t);
      };
  }
  if (of_model_ || structure.template is<RigidParameters>()) return;
  Structure<dim> elements = structure;
  elements.model = ModalParameters{.modes = count, .rho_infinity = 1};
  const auto made = make_model(elements);
  elements_ = modes_of(*made, made->interpolation(interface.position, interface.body));
}

template PointModes::PointModes(const Structure<2>&, const Interface&, const SolidModel&, int);
template PointModes::PointModes(const Structure<3>&, const Interface&, const SolidModel&, int);

std::vector<PointModes::PointMode> PointModes::modes_of(const SolidModel& model,
                                                        const Interpolation& H) const {
  std::vector<PointMode> modes;
  for (const NodalMode& mode : model.modes(count_))
    modes.push_back({mode.shape * H.transpose(), mode.mass, mode.omega_squared});
  return modes;
}

/// Rotation of a body at time t since its modes were found; empty if the modes do not rotate.
Eigen::MatrixXd PointModes::rotation(std::size_t body, double t, const Field& displacement) const {
  const Turning& turning = turnings_[body];
  if (turning.with_carrier) return turning.with_carrier(t);
  if (!turning.with_points) return {};
  std::vector<Eigen::Index> own;
  for (Eigen::Index p = 0; p < interface_.points(); ++p)
    if (interface_.body[static_cast<std::size_t>(p)] == static_cast<int>(body)) own.push_back(p);
  if (own.empty()) return {};
  Field X = interface_.position(Eigen::all, own);
  Field x = X + displacement(Eigen::all, own);
  X.colwise() -= Eigen::VectorXd(X.rowwise().mean());
  x.colwise() -= Eigen::VectorXd(x.rowwise().mean());
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(x * X.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  return parts.matrixU() * parts.matrixV().transpose();
}

Field PointModes::turned(const Field& shape, const std::vector<Eigen::MatrixXd>& rotations) const {
  Field now = shape;
  for (Eigen::Index p = 0; p < shape.cols(); ++p) {
    const Eigen::MatrixXd& R =
        rotations[static_cast<std::size_t>(interface_.body[static_cast<std::size_t>(p)])];
    if (R.size() > 0) now.col(p) = R * shape.col(p);
  }
  return now;
}

std::vector<Mode> PointModes::answers(const SolidModel& model, const Window& window, const Interpolation& H,
                                      const Field& displacement, const Field& force,
                                      std::size_t order) const {
  std::vector<Eigen::MatrixXd> rotations;
  for (std::size_t b = 0; b < turnings_.size(); ++b)
    rotations.push_back(rotation(b, window.start + 0.5 * window.size, displacement));
  std::vector<Mode> answers;
  for (const PointMode& mode : of_model_ ? modes_of(model, H) : elements_) {
    const double c = stumpff(mode.omega_squared * window.size * window.size)[order];
    const Field shape = turned(mode.shape, rotations);
    answers.push_back(
        {.shape = shape, .mobility = window.size * c / mode.mass, .load = shape.cwiseProduct(force).sum()});
  }
  return answers;
}

}  // namespace cosurge
