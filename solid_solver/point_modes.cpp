#include "solid_solver/point_modes.hpp"

#include <Eigen/SVD>

#include "common/case/carriers.hpp"
#include "common/geometry/motion.hpp"
#include "solid_solver/models/make_model.hpp"
#include "solid_solver/oscillator.hpp"

namespace cosurge {

PointModes::PointModes(const v1::Case& the_case, const Interface& interface, const SolidModel& model,
                       int count)
    : case_(the_case), interface_(interface), count_(count), of_model_(!model.modes(count).empty()) {
  if (of_model_ || the_case.solid().model() == v1::SolidModel::rigid) return;
  v1::Case elements = the_case;
  elements.mutable_solid()->set_model(v1::SolidModel::modal);
  elements.mutable_solid()->mutable_modal()->set_modes(count);
  const auto made = make_model(elements);
  elements_ = modes_of(*made, made->interpolation(interface.position, interface.body));
}

std::vector<PointModes::PointMode> PointModes::modes_of(const SolidModel& model,
                                                        const Interpolation& H) const {
  std::vector<PointMode> modes;
  for (const NodalMode& mode : model.modes(count_))
    modes.push_back({mode.shape * H.transpose(), mode.mass, mode.omega_squared});
  return modes;
}

/// Rotation of a body at time t since its modes were found; empty if the modes do not rotate.
Eigen::MatrixXd PointModes::rotation(int body, double t, const Field& displacement) const {
  const v1::Body& its = case_.solid().body(body);
  const v1::WallMotion carrier = motion_of(case_, its);
  if (case_.dimension() == 2 && Motion<2>(carrier).moves()) return Motion<2>(carrier).turned(t);
  if (case_.dimension() == 3 && Motion<3>(carrier).moves()) return Motion<3>(carrier).turned(t);
  if (of_model_ || is_held(case_.solid(), its)) return {};
  std::vector<Eigen::Index> own;
  for (Eigen::Index p = 0; p < interface_.points(); ++p)
    if (interface_.body[static_cast<std::size_t>(p)] == body) own.push_back(p);
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
  for (int b = 0; b < case_.solid().body_size(); ++b)
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
