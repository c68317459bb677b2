// Encodes pictures as a video file with the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "coupler/draw/canvas.hpp"

namespace cosurge {

/// Writes an MP4 file (H.264), which gets its name when it is complete.
class Encoder {
 public:
  /// @throws Error where there is no ffmpeg: the message names its package.
  static void require_ffmpeg();

  /// All pictures have this size, in even numbers of pixels. @throws Error where ffmpeg cannot be started.
  Encoder(const std::filesystem::path& file, int width, int height, double pictures_a_second);
  ~Encoder();  ///< without finish(): removes what was written
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  /// @throws Error if ffmpeg has ended, with its output.
  void add(const Canvas& picture);

  /// Waits for the end of ffmpeg. @throws Error where it failed, with its words.
  void finish();

 private:
  /// Ends ffmpeg's input and waits; returns whether it succeeded.
  bool close();
  std::string last_words() const;

  std::filesystem::path file_, unfinished_, log_;
  int input_ = -1;
  pid_t ffmpeg_ = -1;
};

}  // namespace cosurge
