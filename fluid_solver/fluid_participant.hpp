// The fluid solver as a participant of a coupled run.
#pragma once

#include <memory>

#include "common/participant.hpp"

namespace cosurge::fluid {

/// The participant for scenes of two and three dimensions; which one is known when the case arrives.
class FluidParticipant : public Fluid {
 public:
  FluidParticipant();
  ~FluidParticipant() override;

  Identity identity() const override;
  Setup initialize(const v1::Case& the_case, Interface& interface, InterfaceLoad& load) override;
  Report advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) override;
  std::string save() override;
  void restore(const std::string& state) override;
  Snapshot frame() override;

 private:
  class Scene;
  template <int dim>
  class SceneOf;
  std::unique_ptr<Scene> scene_;
};

}  // namespace cosurge::fluid
