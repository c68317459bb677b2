// A model far from the origin, computed near it.
#pragma once

#include <memory>

#include "common/error.hpp"
#include "proto/case.pb.h"
#include "solid_solver/wrapped_model.hpp"

namespace cosurge {

/// Where coordinates of a case's bodies are counted from [m], empty where the case's own origin serves:
/// bodies more than a hundred times as far from it as they are large lose digits. A multiple of the spacing.
std::vector<double> origin_near_bodies(const v1::Case& the_case, double spacing);

/// The case with its bodies, their clamps and supports, and pivots counted from `origin`.
v1::Case relocated(const v1::Case& the_case, const std::vector<double>& origin);

/// Result of `work`; messages of its errors say that their coordinates are relative to `origin`.
template <typename Work>
auto saying_origin(const std::vector<double>& origin, const Work& work) {
  const auto said = [&](const std::exception& error) {
    return fmt::format("{} (coordinates of the body are counted from ({:.10g}) m)", error.what(),
                       fmt::join(origin, ", "));
  };
  try {
    return work();
  } catch (const NumericalError& error) {
    throw NumericalError(said(error));
  } catch (const Error& error) {
    throw Error(said(error));
  }
}

/// Runs a model of the relocated case on positions of the case. Messages say what their coordinates mean.
class RelocatedModel : public WrappedModel {
 public:
  RelocatedModel(std::unique_ptr<SolidModel> model, const std::vector<double>& origin);

  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  int advance(const Window& window, const NodalLoad& load) override;
  NodeLayout layout() const override;
  Snapshot frame() const override;

 private:
  std::vector<double> origin_;
};

}  // namespace cosurge
