// The model `auto`: modes while they are valid, finite elements otherwise.
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "solid_solver/models/automatic/linear_theory.hpp"
#include "solid_solver/models/fem/fem_model.hpp"
#include "solid_solver/models/modal/modal_model.hpp"

namespace cosurge::automatic {

/// Computes with `modal` as long as its two assumptions hold, and otherwise with `fem` on the same elements
/// (docs/method_solid.md, section 14). The assumptions are measured relative to the largest displacement:
/// nonlinearity, the difference from the nonlinear displacement under the same forces, and truncation, the
/// part of the static deflection that the modes lack. A window in which nonlinearity exceeds its limit, or
/// truncation has exceeded it for a period, is computed again by `fem`, from the state at its start. `modal`
/// takes over again after both have been small for a period. Bodies that can move as a whole are computed by
/// `fem`.
template <int dim>
class AutomaticModel : public SolidModel {
 public:
  AutomaticModel(const Structure<dim>& structure, const AutomaticParameters& parameters);

  Eigen::Index nodes() const override { return modal_.nodes(); }
  std::uint64_t particles() const override { return modal_.particles(); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override {
    return modal_.interpolation(position, body);
  }
  double substep() const override { return parameters_.fem.substep; }
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return active().displacement(); }
  Field velocity() const override { return active().velocity(); }
  Field ramp_increment() const override { return active().ramp_increment(); }
  Field acceleration_by(const Field& load) const override { return modal_.bodies().acceleration_by(load); }
  NodeLayout layout() const override { return modal_.layout(); }
  Field inertia(const Field& acceleration) const override { return modal_.inertia(acceleration); }
  double max_speed() const override { return active().max_speed(); }
  Energies energies() const override { return active().energies(); }

  /// Modes of held bodies; none of free ones, as for `fem`.
  std::vector<NodalMode> modes(int count) const override;

  /// `model`: 0 for `modal`, 1 for `fem`; nonlinearity and truncation when they were last measured.
  std::vector<Column> columns() const override {
    return {{"model", "-"}, {"nonlinearity", "-"}, {"truncation", "-"}};
  }
  std::vector<double> values() const override;
  std::vector<std::string> take_notes() override { return std::exchange(notes_, {}); }

  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override { return active().frame(); }

 private:
  using Vectors = typename fem::MeshedBodies<dim>::Vectors;

  /// The last measurement of the assumptions.
  struct Watch {
    double nonlinearity = 0;
    double truncation = 0;
    double energy = 0;              // elastic energy at which it is repeated [J]
    double force = 0;               // largest force on a node at which it is repeated [N]
    int windows = 0;                // windows since the measurement
    double quiet = 0;               // time for which both have been small [s]
    double lacking = 0;             // time for which truncation has exceeded its limit [s]
    double energy_before = 0;       // largest kinetic and elastic energy while elements computed [J]
    fem::Vector deflection = {};    // largest static deflection of each body so far [m]
    fem::Vector displacement = {};  // largest displacement of each body while elements computed [m]

    /// Visits all members of a saved state, in its order.
    template <typename Self, typename Visit>
    static void each(Self& self, Visit&& visit) {
      visit(self.nonlinearity);
      visit(self.truncation);
      visit(self.energy);
      visit(self.force);
      visit(self.quiet);
      visit(self.lacking);
      visit(self.energy_before);
      visit(self.windows);
      visit(self.deflection);
      visit(self.displacement);
    }
  };

  const SolidModel& active() const {
    return fem_ ? static_cast<const SolidModel&>(*fem_) : static_cast<const SolidModel&>(modal_);
  }
  bool is_due(const NodalLoad& load) const;
  void measure(const Vectors& displacements, const NodalLoad& load);
  std::string exceeded() const;
  void take_elements(const Window& window, const std::string& reason);
  /// At the start of a window.
  void take_modes_if_valid(const Window& window, const NodalLoad& load);
  bool loses_little(const Vectors& u);

  Structure<dim> structure_;
  AutomaticParameters parameters_;
  modal::ModalModel<dim> modal_;  // its bodies are also those of theories_
  std::deque<LinearTheory<dim>> theories_;
  std::optional<fem::FemModel<dim>> fem_;  // set while elements compute
  bool only_elements_;                     // a body can move as a whole, so that modes are never used
  double period_ = 0;                      // longest of all bodies [s]
  Watch watch_;
  std::vector<std::string> notes_;
};

}  // namespace cosurge::automatic
