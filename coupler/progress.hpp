// The progress line of a run.
#pragma once

#include <chrono>
#include <cstdio>

#include "coupler/coupler.hpp"

namespace cosurge {

/// One line that is written over on a terminal; a new line every few seconds elsewhere.
class Progress : public Observer {
 public:
  /// `members` and `columns` as the coupler has them; writes to `out`.
  Progress(const v1::Case& the_case, const std::vector<Member>& members, const std::vector<Column>& columns,
           std::FILE* out);
  ~Progress() override;

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override;

 private:
  using Clock = std::chrono::steady_clock;

  /// Where a quantity stands among the reports. Of a vector the length is shown.
  struct Quantity {
    std::string label;
    std::string unit;
    std::size_t member;
    std::size_t column;
    std::size_t components;
  };

  void find(const std::vector<Member>& members, const std::string& member, const std::string& column,
            const std::string& label, std::size_t components = 1);

  void tell_notes(const Reports& reports);
  std::string coupling_text(const std::vector<double>& values) const;

  double end_;
  std::vector<Column> columns_;  // columns of the coupler's own values
  std::vector<Quantity> quantities_;
  std::FILE* out_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  int unshown_ = 0;  // windows since then
  int told_ = 0;     // windows before then
};

}  // namespace cosurge
