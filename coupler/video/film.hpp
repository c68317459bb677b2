// The pictures of a run, one a frame of its results.
#pragma once

#include <memory>

#include "coupler/draw/canvas.hpp"
#include "coupler/results.hpp"

namespace cosurge {

/// Draws the scene at each frame, coloured by pressure and stress, above the history of the first probe.
class Film {
 public:
  /// `results` must live as long. @throws Error where there is no frame.
  explicit Film(const Results& results);
  ~Film();

  std::size_t pictures() const;
  int width() const;   ///< even
  int height() const;  ///< even

  Canvas picture(std::size_t frame) const;

 private:
  class Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace cosurge
