// The progress of a run for a person: a line on a terminal, lines elsewhere.
#pragma once

#include <cstdio>

#include "coupler/progress/progress_meter.hpp"

namespace cosurge {

/// One line that is written over on a terminal, never wider than it; a new line every few seconds elsewhere.
/// Notes of the solvers have lines of their own.
class Progress : public Observer {
 public:
  /// `members` and `columns` as the coupler has them; writes to `out`.
  Progress(const v1::Case& the_case, const std::vector<Member>& members, const std::vector<Column>& columns,
           std::FILE* out);
  ~Progress() override;

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override;

 private:
  ProgressMeter meter_;
  std::FILE* out_;
  bool terminal_;
};

/// Only the notes of the solvers.
class Notes : public Observer {
 public:
  explicit Notes(std::FILE* out) : out_(out) {}

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override;

 private:
  std::FILE* out_;
};

}  // namespace cosurge
