#include "coupler/schemes/strong/iqn_ils.hpp"

#include <algorithm>

namespace cosurge {
namespace {

// Least share of a column's length that must remain after its projection on newer columns is subtracted: the
// pressure is known to about four digits, so that a smaller remainder is noise.
constexpr double filter = 1e-2;

// Number of steps in a window that increase the residual, from which on its older columns are dropped.
// Without suction one or two such steps occur on the way to the solution.
constexpr int few = 3;

constexpr double longest = 1.5;  // [residuals] above 1: (1 + M)^-1 is symmetric in another norm

}  // namespace

Eigen::VectorXd IqnIls::next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual) {
  const Eigen::VectorXd output = x + residual;
  if (last_residual_.size() > 0) {
    changes_.push_front({.residual = residual - last_residual_, .output = output - last_output_});
    ++counts_.front();
    if (residual.norm() > last_residual_.norm()) forget();
  }
  last_residual_ = residual;
  last_output_ = output;

  // Gram-Schmidt: orthonormal directions q of the residuals, each with its change of the output
  std::vector<Change> basis;
  for (const Change& change : changes_) {
    Change rest = change;
    for (const Change& q : basis) {
      const double share = q.residual.dot(rest.residual);
      rest.residual -= share * q.residual;
      rest.output -= share * q.output;
    }
    const double length = rest.residual.norm();
    if (!(length > filter * change.residual.norm())) continue;
    basis.push_back({.residual = rest.residual / length, .output = rest.output / length});
    if (static_cast<Eigen::Index>(basis.size()) == x.size()) break;
  }
  if (basis.empty()) return x + first_ * residual;
  Eigen::VectorXd step = residual;
  for (const Change& q : basis) step -= q.residual.dot(residual) * q.output;
  const double excess = step.norm() / (longest * residual.norm());
  return x + step / std::max(1.0, excess);
}

void IqnIls::forget() {
  const int kept = ++growths_ < few ? counts_.front() : 1;
  changes_.resize(static_cast<std::size_t>(kept));
  counts_ = {kept};
}

void IqnIls::end_window() {
  last_residual_.resize(0);
  last_output_.resize(0);
  counts_.push_front(0);
  growths_ = 0;
  while (static_cast<int>(counts_.size()) > reuse_ + 1) {
    changes_.resize(changes_.size() - static_cast<std::size_t>(counts_.back()));
    counts_.pop_back();
  }
}

void IqnIls::save(StateWriter& state) const {
  state.put(std::vector<int>(counts_.begin(), counts_.end()));
  for (const Change& change : changes_) {
    put_sized(state, change.residual);
    put_sized(state, change.output);
  }
}

void IqnIls::restore(InterfaceReader& state) {
  std::vector<int> counts;
  state.get(counts);
  const bool possible = !counts.empty() && static_cast<int>(counts.size()) <= reuse_ + 1 &&
                        *std::min_element(counts.begin(), counts.end()) >= 0;
  require(possible,
          "saved state: the interface quasi-Newton scheme has columns of {} windows, must have them of 1 to "
          "{}, and none fewer than 0; it belongs to another case or is damaged",
          counts.size(), reuse_ + 1);
  counts_.assign(counts.begin(), counts.end());
  changes_.clear();
  for (const int count : counts)
    for (int k = 0; k < count; ++k) {
      Change& change = changes_.emplace_back();
      state.get_column(change.residual);
      state.get_column(change.output);
    }
}

}  // namespace cosurge
