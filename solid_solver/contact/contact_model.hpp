// A solid model whose bodies touch each other, the tank and obstacles.
#pragma once

#include <memory>

#include "solid_solver/contact/neighborhood.hpp"
#include "solid_solver/wrapped_model.hpp"

namespace cosurge::contact {

/// Any model with frictionless contact (docs/method_solid.md, section 12). Vertices of the bodies' boundaries
/// that are beyond a facet or a wall are pushed back by springs with the energy k A g^2 / 2 (S44). While
/// anything touches or can touch in the window, the window is computed in sub-steps with constant spring
/// forces. If nothing is near, the model computes the window as without contact, with bit-identical results.
template <int dim>
class ContactModel : public WrappedModel {
 public:
  ContactModel(std::unique_ptr<SolidModel> model, const Structure<dim>& structure,
               const Surroundings<dim>& surroundings);

  int advance(const Window& window, const NodalLoad& load) override;
  Field ramp_increment() const override { return touching_ ? ramp_increment_ : model_->ramp_increment(); }

  /// Energy of the springs, their work on the bodies so far, the mean force of tank and obstacles in the
  /// window, and the number of vertices in contact at its end.
  std::vector<Column> columns() const override;
  std::vector<double> values() const override;
  std::vector<std::string> take_notes() override;

  std::string save() const override;
  void restore(const std::string& state) override;

 private:
  using Touches = std::vector<Touch<dim>>;

  Field positions(double t) const;
  Field velocities(double t) const;
  template <typename Visit>
  void each_carried(const Visit& visit) const;
  bool may_touch(const Window& window) const;
  double stiffness(const Touch<dim>& touch) const;
  void find_stiffness();
  Touches pressed(const Field& x, double t) const;
  Field forces(const Touches& touches) const;
  Vec<dim> from_outside(const Touches& touches) const;
  void note(const Touches& touches, const Field& v, double t);
  void check_depth(const Touches& touches, double t) const;
  int step(const Window& part, const NodalLoad& load, double before, double share);

  Neighborhood<dim> neighborhood_;
  Interpolation H_;                   // H of the boundaries' vertices; matrix rows of held vertices are empty
  std::vector<Motion<dim>> carrier_;  // motion of each body's carrier
  double step_;                       // longest sub-step while bodies touch [s]
  std::vector<double> stiffness_;     // stiffness of each body over its area [N/m^dim]; empty: unknown

  bool touching_ = false;                // whether the last window was computed in sub-steps
  Field ramp_increment_;                 // z of the last window, if it was computed in sub-steps
  double energy_ = 0;                    // energy of the springs [J]
  double work_ = 0;                      // work of the springs on the bodies [J]
  double pressed_ = 0;                   // number of vertices in contact
  Vec<dim> load_ = Vec<dim>::Zero();     // mean force of tank and obstacles in the last window [N]
  std::vector<std::array<int, 2>> met_;  // pairs (body, other object) that have touched
  std::vector<std::string> notes_;
};

/// Adds contact to a model, unless its bodies cannot move or there is nothing to touch.
template <int dim>
std::unique_ptr<SolidModel> with_contact(std::unique_ptr<SolidModel> model, const Structure<dim>& structure,
                                         const Surroundings<dim>& surroundings);

}  // namespace cosurge::contact
