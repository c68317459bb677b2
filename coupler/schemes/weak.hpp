// Conventional serial staggered coupling.
#pragma once

#include "coupler/scheme.hpp"

namespace cosurge {

/// The paper's: the fluid steps with the motion that the solid had at the end of the last window, then the
/// solid goes through the same window, in sub-cycles, under the load that came out. One exchange a window.
/// Unstable where the added mass exceeds the solid's, whatever the window (Causin, Gerbeau & Nobile 2005,
/// doi 10.1016/j.cma.2004.12.005).
class Weak : public Scheme {
 public:
  explicit Weak(Participants participants) : participants_(participants) {}

  Reports advance(const Window& window, Surface& surface, InterfaceAccount& account) override {
    Reports reports;
    account.open(surface);
    if (participants_.fluid != nullptr) reports.push_back(participants_.fluid->advance(window, surface));
    if (participants_.solid != nullptr) reports.push_back(participants_.solid->advance(window, surface));
    account.close(surface);
    return reports;
  }

 private:
  Participants participants_;
};

}  // namespace cosurge
