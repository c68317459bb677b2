#include "coupler/draw/colors.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge {

const Scale viridis = {hex(0x440154), hex(0x472d7b), hex(0x3b528b), hex(0x2c728e), hex(0x21918c),
                       hex(0x28ae80), hex(0x5ec962), hex(0xaddc30), hex(0xfde725)};
const Scale speed_scale = {hex(0x0d2a5c), hex(0x14539a), hex(0x2f7fc1), hex(0x5ca6d6), hex(0x93c8e4),
                           hex(0xc5e2ee), hex(0xf3e9a9), hex(0xf0a54a), hex(0xc8402a)};
const Scale stress_scale = {hex(0xfff3c4), hex(0xfee391), hex(0xfec44f), hex(0xfe9929), hex(0xec7014),
                            hex(0xcc4c02), hex(0xa63603), hex(0x7f2704), hex(0x4a1502)};

Color color_of(const Scale& scale, double value, double low, double high) {
  const double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0;
  const double place = (std::isnan(share) ? 0 : share) * (scale.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double rest = place - static_cast<double>(k);
  const Color &a = scale[k], &b = scale[k + 1];
  return {a.red + rest * (b.red - a.red), a.green + rest * (b.green - a.green),
          a.blue + rest * (b.blue - a.blue)};
}

}  // namespace cosurge
