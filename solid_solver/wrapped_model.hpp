// Base class of models that wrap another model.
#pragma once

#include <memory>
#include <utility>

#include "solid_solver/solid_model.hpp"

namespace cosurge {

/// Forwards all calls to the wrapped model; derived classes override those that they change.
class WrappedModel : public SolidModel {
 public:
  explicit WrappedModel(std::unique_ptr<SolidModel> model) : model_(std::move(model)) {}

  Eigen::Index nodes() const override { return model_->nodes(); }
  std::uint64_t particles() const override { return model_->particles(); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override {
    return model_->interpolation(position, body);
  }
  double substep() const override { return model_->substep(); }
  int advance(const Window& window, const NodalLoad& load) override { return model_->advance(window, load); }
  Field displacement() const override { return model_->displacement(); }
  Field velocity() const override { return model_->velocity(); }
  Field ramp_increment() const override { return model_->ramp_increment(); }
  Field acceleration_by(const Field& load) const override { return model_->acceleration_by(load); }
  NodeLayout layout() const override { return model_->layout(); }
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
  Snapshot frame() const override { return model_->frame(); }

 protected:
  std::unique_ptr<SolidModel> model_;
};

}  // namespace cosurge
