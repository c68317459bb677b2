// A model far from the origin, computed near it.
#pragma once

#include <memory>

#include "common/error.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge {

/// Where coordinates of a case's bodies are counted from [m], empty where the case's own origin serves:
/// bodies more than a hundred times as far from it as they are large lose digits. A multiple of the spacing.
std::vector<double> origin_near_bodies(const v1::Case& the_case, double spacing);

/// The case with its bodies, their clamps and supports, and pivots counted from `origin`.
v1::Case relocated(const v1::Case& the_case, const std::vector<double>& origin);

/// What `work` returns; messages of its errors say that their coordinates are counted from `origin`.
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
class RelocatedModel : public SolidModel {
 public:
  RelocatedModel(std::unique_ptr<SolidModel> model, const std::vector<double>& origin);

  Eigen::Index nodes() const override { return model_->nodes(); }
  std::uint64_t particles() const override { return model_->particles(); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  double substep() const override { return model_->substep(); }
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return model_->displacement(); }
  Field velocity() const override { return model_->velocity(); }
  Field ramp_increment() const override { return model_->ramp_increment(); }
  Field acceleration_by(const Field& load) const override { return model_->acceleration_by(load); }
  NodeLayout layout() const override;
  Field inertia(const Field& acceleration) const override { return model_->inertia(acceleration); }
  double force_instant() const override { return model_->force_instant(); }
  double max_speed() const override { return model_->max_speed(); }
  Energies energies() const override { return model_->energies(); }
  std::vector<NodalMode> modes(int count) const override { return model_->modes(count); }
  std::vector<Column> columns() const override { return model_->columns(); }
  std::vector<double> values() const override { return model_->values(); }
  std::vector<std::string> take_notes() override { return model_->take_notes(); }
  std::string save() const override { return model_->save(); }
  void restore(const std::string& state) override { model_->restore(state); }
  Snapshot frame() const override;

 private:
  std::unique_ptr<SolidModel> model_;
  std::vector<double> origin_;
};

}  // namespace cosurge
