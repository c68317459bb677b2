#include "coupler/interface_account.hpp"

#include <cmath>

namespace cosurge {

void InterfaceAccount::open(const InterfaceState& interface) {
  displacement_ = interface.motion.displacement;
  if (load_.size() == 0) load_ = Field::Zero(interface.load.force.rows(), interface.load.force.cols());
}

void InterfaceAccount::close(const InterfaceState& interface, const Field& seen, const Window& window) {
  const Field moved = interface.motion.displacement - displacement_;
  const Field& late = interface.motion.ramp_increment;
  const double work =
      ramped_ ? load_.cwiseProduct(moved - late).sum() + interface.load.force.cwiseProduct(late).sum()
              : interface.load.force.cwiseProduct(moved).sum();
  work_ += work;
  passed_ += std::abs(work);
  seen_work_ += window.size * interface.load.force.cwiseProduct(seen).sum();
  load_ = interface.load.force;
}

std::vector<Column> InterfaceAccount::columns(int dimension) {
  std::vector<Column> columns = {{"work_points", "J"}, {"work_seen", "J"}, {"work_created", "J"}};
  for (int k = 0; k < dimension; ++k) columns.push_back({std::string("force_") + "xyz"[k], "N"});
  return columns;
}

std::vector<double> InterfaceAccount::values() const {
  std::vector<double> values = {work(), seen_work(), created()};
  const Eigen::VectorXd total = force();
  values.insert(values.end(), total.data(), total.data() + total.size());
  return values;
}

void InterfaceAccount::save(StateWriter& state) const {
  state.put(work_);
  state.put(seen_work_);
  state.put(passed_);
  put_sized(state, load_);
}

void InterfaceAccount::restore(InterfaceReader& state) {
  state.get(work_);
  state.get(seen_work_);
  state.get(passed_);
  state.get_field(load_);
}

}  // namespace cosurge
