#pragma once

#include <memory>
#include <optional>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Lets the project's sound be heard: in time with playback, and for a moment on each frame that is
// gone to. Opens the sound device when there is first something to hear; without one the editor
// says so once.
class SoundPlayer {
 public:
  SoundPlayer();
  ~SoundPlayer();
  SoundPlayer(const SoundPlayer&) = delete;
  SoundPlayer& operator=(const SoundPlayer&) = delete;

  // To be called for every picture, and at every change of frame.
  void Follow(Editor* editor);
  // Where in the sound it is [s]; nothing while it is silent.
  std::optional<double> position() const;

 private:
  class Device;
  bool IsReady(Editor* editor);
  void Play(Editor* editor, double frame);
  void Scrub(Editor* editor);

  std::unique_ptr<Device> device_;
  const Sound* sound_ = nullptr;  // that the device has
  bool has_failed_ = false;
  double frame_ = 0.0;  // seen last
};

}  // namespace hazumi::ui
