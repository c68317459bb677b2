// The fastest motion of a body, which limits explicit steps.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace cosurge::particles {

/// Highest angular frequency [rad/s] of x'' = -K x by Lanczos iteration, at most a factor 1 + 1e-4 too high
/// and never too low: explicit steps are stable up to 2 / omega.
/// @param unknowns length of x
/// @param stiffness x -> K x, symmetric
/// @throws NumericalError where the iteration finds none
double highest_frequency(std::size_t unknowns,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& stiffness);

}  // namespace cosurge::particles
