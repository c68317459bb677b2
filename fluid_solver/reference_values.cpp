#include "fluid_solver/reference_values.hpp"

#include <cmath>

#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {

template <int dim>
ReferenceValues reference_values(double re, double spacing) {
  static_assert(dim == 2 || dim == 3);
  constexpr double edge = 1e-9;  // tolerance for sites on the edge [r_e]
  const int reach = static_cast<int>(std::ceil(re / spacing));
  const int reach_z = dim == 3 ? reach : 0;
  double sum_w = 0;
  double sum_r2w = 0;
  double sum_x2w = 0;
  double sum_xw = 0;
  double smooth = 1;
  for (int k = -reach_z; k <= reach_z; ++k) {
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        const double r = spacing * std::sqrt(static_cast<double>(i * i + j * j + k * k));
        if (r >= re * (1 - edge)) continue;
        sum_w += weight(r, re);
        sum_r2w += r * r * weight(r, re);
        sum_x2w += i * i * weight(r, re);
        sum_xw += std::abs(i) * weight(r, re);
        smooth += smooth_share(weight(r, re));
      }
    }
  }
  return {.n0 = sum_w, .lambda0 = sum_r2w / sum_w, .smooth0 = smooth, .face_factor = sum_x2w / sum_xw};
}

template ReferenceValues reference_values<2>(double, double);
template ReferenceValues reference_values<3>(double, double);

}  // namespace cosurge::fluid
