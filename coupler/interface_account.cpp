#include "coupler/interface_account.hpp"

namespace cosurge {

void InterfaceAccount::open(const Surface& surface) {
  displacement_ = surface.displacement;
  if (load_.size() == 0) load_ = Field::Zero(surface.force.rows(), surface.force.cols());
}

void InterfaceAccount::close(const Surface& surface, const Field& seen, const Window& window) {
  const Field moved = surface.displacement - displacement_;
  const Field& late = surface.ramp_increment;
  if (ramped_)
    work_ += load_.cwiseProduct(moved - late).sum() + surface.force.cwiseProduct(late).sum();
  else
    work_ += surface.force.cwiseProduct(moved).sum();
  seen_work_ += window.size * surface.force.cwiseProduct(seen).sum();
  load_ = surface.force;
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
  put_sized(state, load_);
}

void InterfaceAccount::restore(StateReader& state) {
  state.get(work_);
  state.get(seen_work_);
  get_sized(state, load_);
}

}  // namespace cosurge
