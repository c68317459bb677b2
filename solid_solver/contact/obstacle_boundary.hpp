// The surface of an obstacle, at rest or in a prescribed motion, for contact with bodies.
#pragma once

#include <memory>

#include "common/geometry/motion.hpp"
#include "solid_solver/contact/facet_search.hpp"

namespace cosurge::contact {

/// Facets of an obstacle and the search for them, in the position of the obstacle at t = 0.
template <int dim>
class ObstacleBoundary {
 public:
  /// @param motion the obstacle's own, or the tank's
  /// @param longest edge of a facet [m]
  /// @param reach how far away a facet is found [m]
  ObstacleBoundary(const Shape<dim>& shape, const Motion<dim>& motion, double longest, double reach)
      : shape_(shape), motion_(motion), longest_(longest), reach_(reach) {}

  const Shape<dim>& shape() const { return shape_; }  ///< undeformed, at t = 0
  const Motion<dim>& motion() const { return motion_; }

  /// Facets and their grid where the obstacle is at the start; made when they are first asked for.
  const Boundary<dim>& boundary() const {
    make();
    return *boundary_;
  }
  const FacetSearch<dim>& search() const {
    make();
    return *search_;
  }

  /// A box that contains the obstacle at time t [s].
  Box<dim> box(double t) const {
    const Box<dim>& start = shape_.bounds();
    if (!motion_.moves()) return start;
    Box<dim> now(motion_.place(start.min, t), motion_.place(start.min, t));
    for (int corner = 1; corner < 1 << dim; ++corner) {
      Vec<dim> X;
      for (int k = 0; k < dim; ++k) X[k] = (corner >> k & 1) != 0 ? start.max[k] : start.min[k];
      now.min = now.min.cwiseMin(motion_.place(X, t));
      now.max = now.max.cwiseMax(motion_.place(X, t));
    }
    return now;
  }

 private:
  void make() const {
    if (boundary_) return;
    boundary_ = std::make_unique<Boundary<dim>>(shape_, longest_);
    search_ = std::make_unique<FacetSearch<dim>>(*boundary_, boundary_->position, reach_, shape_.bounds());
  }

  Shape<dim> shape_;
  Motion<dim> motion_;
  double longest_, reach_;
  mutable std::unique_ptr<Boundary<dim>> boundary_;
  mutable std::unique_ptr<FacetSearch<dim>> search_;
};

}  // namespace cosurge::contact
