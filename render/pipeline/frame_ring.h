#pragma once

#include <array>
#include <condition_variable>
#include <mutex>

#include "engine/picture/image.h"

namespace hazumi::render {

// Three pictures passed in order from the thread that draws to the one that writes.
class FrameRing {
 public:
  FrameRing(int width, int height);

  // Drawing side. Waits for a free picture; null once the writer has stopped.
  Image* BeginDrawing();
  void EndDrawing();
  void CloseDrawing();  // no more pictures will come

  // Writing side. Waits for a drawn picture; null when all are written and drawing is closed.
  const Image* BeginWriting();
  void EndWriting();
  void StopWriting();  // after a failure: nothing more will be written

 private:
  static constexpr int kPictures = 3;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::array<Image, kPictures> images_;
  long drawn_ = 0, written_ = 0;
  bool drawing_closed_ = false, writing_stopped_ = false;
};

}  // namespace hazumi::render
