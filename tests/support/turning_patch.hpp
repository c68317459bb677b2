// A rotating square patch of water without gravity (Colagrossi 2005), which needs suction.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/state_bytes.hpp"
#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid::test {

/// Area of the cells around the water's particles inside a box, over the box's: 1 where the water has its
/// density.
inline double filled(const Mps<2>& mps, double spacing, const Box<2>& box) {
  double area = 0;
  for (int i = 0; i < mps.particles().size(); ++i) {
    if (mps.particles().kind[i] != Kind::fluid) continue;
    const Vec<2> low = (mps.particles().x[i].array() - spacing / 2).max(box.min.array());
    const Vec<2> high = (mps.particles().x[i].array() + spacing / 2).min(box.max.array());
    area += (high - low).cwiseMax(0).prod();
  }
  return area / (box.max - box.min).prod();
}

/// A square with a side of 1 m that rotates at 1 rad/s, in windows of 4 ms. The pressure inside is negative,
/// initially -0.1473 rho omega^2 L^2 in the middle. Without it every particle moves straight, and the density
/// falls as 1 / (1 + (omega t)^2).
class TurningPatch {
 public:
  struct Choice {
    int particles;  ///< along a side
    v1::Fluid::Gradient gradient = v1::Fluid::corrected;
    double shifting = 0;
    double lowest_pressure = 0;
  };

  explicit TurningPatch(const Choice& choice)
      : spacing_(1.0 / choice.particles), mps_(mps_of<2>(fluid_of(choice), nullptr, Vec<2>::Zero())) {
    Particles<2> turning = mps_.particles();
    for (int i = 0; i < turning.size(); ++i)
      if (turning.kind[i] == Kind::fluid)
        turning.u[i] = Vec<2>(turning.x[i][1] - middle, middle - turning.x[i][0]);
    StateWriter before, after;  // a state begins with positions and velocities
    before.put(mps_.particles().x);
    before.put(mps_.particles().u);
    after.put(turning.x);
    after.put(turning.u);
    mps_.restore(after.take() + mps_.save().substr(before.take().size()));
    angular_momentum_ = sums()[0];
    energy_ = sums()[1];
  }

  void step() { (void)mps_.step(time(), dt), ++steps_; }
  double time() const { return steps_ * dt; }

  double filled() const {  ///< filled share of the middle
    return test::filled(mps_, spacing_, {Vec<2>::Constant(middle - 0.2), Vec<2>::Constant(middle + 0.2)});
  }
  double angular_momentum() const { return sums()[0] / angular_momentum_; }  ///< relative to the start
  double energy() const { return sums()[1] / energy_; }                      ///< likewise

  /// Around the middle [Pa].
  double pressure() const {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < mps_.particles().size(); ++i)
      if ((mps_.particles().x[i].array() - middle).matrix().norm() < 0.1)
        sum += mps_.particles().p[i], ++count;
    return count > 0 ? sum / count : 0;
  }

 private:
  static constexpr double middle = 2, dt = 0.004;

  static v1::Fluid fluid_of(const Choice& choice) {
    v1::Fluid fluid = tank_of_water(1.0 / choice.particles, box_of({0, 0}, {2 * middle, 2 * middle}),
                                    {box_of({middle - 0.5, middle - 0.5}, {middle + 0.5, middle + 0.5})});
    fluid.set_source(v1::Fluid::mixed);
    fluid.set_gradient(choice.gradient);
    fluid.set_shifting(choice.shifting);
    fluid.set_kinematic_viscosity(0);
    fluid.set_lowest_pressure(choice.lowest_pressure);
    return fluid;
  }

  Vec<2> sums() const {  // angular momentum and energy per particle mass
    Vec<2> sum = Vec<2>::Zero();
    for (int i = 0; i < mps_.particles().size(); ++i) {
      if (mps_.particles().kind[i] != Kind::fluid) continue;
      const Vec<2> x = mps_.particles().x[i].array() - middle, u = mps_.particles().u[i];
      sum += Vec<2>(x[1] * u[0] - x[0] * u[1], u.squaredNorm() / 2);
    }
    return sum;
  }

  double spacing_;
  Mps<2> mps_;
  int steps_ = 0;
  double angular_momentum_ = 0, energy_ = 0;
};

}  // namespace cosurge::fluid::test
