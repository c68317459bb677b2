// Scenes in which bodies touch other objects, in two and three dimensions, with every model.
#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"
#include "solid_solver/solid_participant.hpp"
#include "tests/support/outlines.hpp"

namespace cosurge::test {

/// A case in a tank of 0.4 m with a lattice of 10 mm, whose models have no damping of their own.
class ContactScene {
 public:
  static constexpr double spacing = 0.01;
  static constexpr double window = 1e-3;
  static constexpr double density = 1000;

  ContactScene(v1::SolidModel::Word model, int dimension) : dimension_(dimension) {
    the_case.set_title("contact");
    the_case.set_dimension(dimension);
    the_case.mutable_time()->set_end(1);
    the_case.mutable_time()->set_window(window);
    the_case.mutable_fluid()->set_spacing(spacing);
    *the_case.mutable_fluid()->mutable_tank()->mutable_min() = repeated(at(0, 0));
    *the_case.mutable_fluid()->mutable_tank()->mutable_max() = repeated(at(0.4, 0.4, 0.4));
    v1::Solid& solid = *the_case.mutable_solid();
    solid.set_model(model);
    solid.set_density(density);
    solid.set_young_modulus(1e6);
    solid.mutable_mps()->set_viscosity(0);
    solid.mutable_hamiltonian()->set_viscosity(0);
    solid.mutable_fem()->set_element(0.04);
    solid.mutable_fem()->set_rho_infinity(1);
    solid.mutable_modal()->set_modes(dimension == 2 ? 8
                                                    : 12);  // three and six of them move a body as a whole
    for (int k = 0; k < dimension; ++k)
      solid.mutable_sprung()->add_spring()->set_motion(static_cast<v1::Spring::Motion>(k));
  }

  /// A point of the plane, or the same in space with another coordinate between.
  std::vector<double> at(double x, double up, double between = 0) const {
    return dimension_ == 2 ? std::vector<double>{x, up} : std::vector<double>{x, between, up};
  }
  /// Downwards.
  void gravity(double along_x, double along_up) {
    *the_case.mutable_gravity() = repeated(at(along_x, along_up));
  }

  /// In space 0.04 m deep, from y = 0.1 m on.
  v1::Body& add_block(double x, double up, double width, double height) {
    v1::Body& body = *the_case.mutable_solid()->add_body();
    *body.mutable_box()->mutable_min() = repeated(at(x, up, 0.1));
    *body.mutable_box()->mutable_max() = repeated(at(x + width, up + height, 0.14));
    return body;
  }
  /// A polygon in the plane of x and up; in space from y = `from` to `to`.
  v1::Shape outline(const std::vector<Vec<2>>& corners, double from = 0.1, double to = 0.14) const {
    if (dimension_ == 2) return test::outline<2>(corners);
    v1::Shape shape = extruded(corners, to - from);
    for (int v = 0; v < shape.vertex_size(); v += 3) {
      shape.mutable_vertex()->SwapElements(v + 1, v + 2);
      shape.set_vertex(v + 1, shape.vertex(v + 1) + from);
    }
    return shape;
  }
  void probe(const std::string& name, double x, double up) {
    v1::Probe& probe = *the_case.mutable_output()->add_probe();
    probe.set_name(name);
    probe.set_quantity(v1::Probe::displacement);
    *probe.mutable_position() = repeated(at(x, up, 0.12));
  }
  /// On the sites of body 0.
  Interface points() const {
    const v1::Body& body = the_case.solid().body(0);
    return dimension_ == 2 ? points_on<2>(body, spacing) : points_on<3>(body, spacing);
  }
  double depth() const { return dimension_ == 2 ? 1 : 0.04; }

  v1::Case the_case;

 private:
  static google::protobuf::RepeatedField<double> repeated(const std::vector<double>& values) {
    return {values.begin(), values.end()};
  }
  int dimension_;
};

/// A participant that computes such a case window by window, and the account of its energy.
struct ContactRun {
  SolidParticipant solid;
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  Setup setup;
  Report report;
  std::vector<std::string> notes;
  std::uint64_t windows = 0;
  double time = 0;

  ContactRun(const v1::Case& c, const Interface& points)
      : interface(points), load(InterfaceLoad::zero(c.dimension(), points.points())) {
    setup = solid.initialize(c, interface, load, motion);
  }
  explicit ContactRun(const v1::Case& c)
      : ContactRun(
            c,
            {.dimension = c.dimension(), .position = Field::Zero(c.dimension(), 0), .area = {}, .body = {}}) {
  }

  void advance(double size = ContactScene::window) {
    report = solid.advance({.index = windows++, .start = time, .size = size}, load, motion);
    time += size;
    notes.insert(notes.end(), report.notes.begin(), report.notes.end());
  }
  double value(const std::string& name) const {
    for (std::size_t k = 0; k < setup.columns.size(); ++k)
      if (setup.columns[k].name == name) return report.values.at(k);
    throw Error("no column " + name);
  }
  /// Energy of the bodies minus the work of water and contact.
  double unaccounted() const {
    return value("kinetic_energy") + value("elastic_energy") + value("gravity_energy") -
           value("interface_work") - value("contact_work");
  }
  /// Energy of the contact springs minus the work on them.
  double made_by_contact() const { return value("contact_work") + value("contact_energy"); }
};

}  // namespace cosurge::test
