// The solid solver as a participant of a coupled run.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "common/participant.hpp"
#include "common/phase_clock.hpp"
#include "solid_solver/point_modes.hpp"
#include "solid_solver/scene.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge {

/// Maps the loads to the unknowns of a model by H^T, advances the model in sub-steps, and maps the motion to
/// the points by H. The load of a window is held, or ramped from that of the last window
/// (docs/method_solid.md, S14 to S16). It sets no stability limit for the window, because models take
/// sub-steps; window_of() limits it for accuracy.
class SolidParticipant : public Solid {
 public:
  Identity identity() const override;

  Setup initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                   InterfaceMotion& motion) override;
  Report advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) override;
  std::string save() override;
  void restore(const std::string& state) override;
  Snapshot frame() override;

 private:
  /// A history of the displacement at a material point.
  struct Probes {
    std::vector<std::string> names;
    Interpolation H;
  };
  enum Phase : std::size_t { mapping, substeps, phases };

  template <int dim>
  Setup start(const Scene<dim>& scene, const Interface& interface, const InterfaceLoad& load,
              InterfaceMotion& motion);
  template <int dim>
  void place_probes(const std::vector<DisplacementProbe<dim>>& probes);
  std::vector<Mode> modes(const Window& window, const InterfaceLoad& load,
                          const InterfaceMotion& motion) const;
  std::vector<Column> columns() const;
  std::vector<double> values(int substeps_taken) const;

  std::unique_ptr<SolidModel> model_;
  int dimension_ = 0;
  double dry_window_ = std::numeric_limits<double>::infinity();  // longest window without load [s]
  double wet_window_ = std::numeric_limits<double>::infinity();  // longest window under load [s]
  double frequency_ = 0;  // slowest oscillation of the structure [rad/s]
  Exchange exchange_ = {.ramped = false, .end_velocity = false, .modes = 0};
  Interpolation H_;
  Probes probes_;

  Field displacement_;         // displacement of the nodes at the end of the last window
  Field load_;                 // load on the nodes in the last window [N]
  double interface_work_ = 0;  // work of the loads on the nodes since the start [J]
  std::optional<PointModes> modes_;
  std::string remembered_;  // state at the start of a window that may be repeated

  PhaseClock<phases> clock_;
  double cpu_seconds_at_start_ = 0;
};

}  // namespace cosurge
