// A case at several spacings: its runs, their quantities and their cost.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "coupler/converge/converge_command.hpp"
#include "coupler/converge/spacing_fit.hpp"
#include "coupler/study/quantity.hpp"
#include "coupler/study/runs.hpp"

namespace cosurge {

/// Runs a case at spacings that divide its boxes: H / k with whole numbers k, where H is the largest multiple
/// of the case's own spacing with which the case is valid.
class SpacingRuns {
 public:
  /// @throws Error with all that is wrong with case and quantities, or where the folder is not free.
  explicit SpacingRuns(const ConvergeOptions& options);

  /// The coarse spacings to begin with: about 2, 4/3 and 1 times the case's own; where no multiple of it is
  /// valid, the case's own and half of it.
  const std::vector<int>& first() const { return first_; }

  double spacing(int k) const { return coarsest_ / k; }    ///< [m]
  int at_least_as_fine(double spacing) const;              ///< the coarsest k of this spacing or finer
  int at_least_as_coarse(double spacing) const;            ///< the finest k of this spacing or coarser
  bool has(int k) const { return folders_.contains(k); }   ///< it has run
  int finest() const { return folders_.rbegin()->first; }  ///< the largest k that has run

  /// Runs the case at spacing k, from two starts if `twice`. @throws Error where a run fails.
  void run(int k, bool twice);

  int dimension() const { return dimension_; }
  const std::vector<Quantity>& quantities() const { return quantities_; }
  const std::vector<std::string>& units() const { return units_; }
  const std::string& folder(int k) const {
    return folders_.at(k);
  }  ///< results of the first start at spacing k

  /// All runs so far, for a quantity.
  const std::vector<SpacingSample>& samples(std::size_t quantity) const { return samples_[quantity]; }

 private:
  void find_coarsest(double own);
  std::vector<std::string> settings(double spacing) const;  // of all keys
  StudyPlan plan(int k, bool twice) const;

  ConvergeOptions options_;
  double coarsest_ = 0;  // H [m]
  std::vector<int> first_;
  std::vector<std::string> keys_;
  std::vector<double> key_spacings_;  // of the case, for each key [m]
  int dimension_ = 2;
  bool weighs_ = false;  // has gravity, which a second start changes
  std::vector<Quantity> quantities_;
  std::vector<std::string> units_;
  std::vector<std::vector<SpacingSample>> samples_;
  std::map<int, std::string> folders_;  // results of the first start, by k
  std::unique_ptr<StudyRuns> runs_;
};

}  // namespace cosurge
