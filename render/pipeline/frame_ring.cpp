#include "render/pipeline/frame_ring.h"

namespace hazumi::render {

FrameRing::FrameRing(int width, int height) { images_.fill(Image(width, height)); }

Image* FrameRing::BeginDrawing() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return drawn_ - written_ < kPictures || writing_stopped_; });
  return writing_stopped_ ? nullptr : &images_[drawn_ % kPictures];
}

void FrameRing::EndDrawing() {
  const std::lock_guard lock(mutex_);
  ++drawn_;
  changed_.notify_all();
}

void FrameRing::CloseDrawing() {
  const std::lock_guard lock(mutex_);
  drawing_closed_ = true;
  changed_.notify_all();
}

const Image* FrameRing::BeginWriting() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return written_ < drawn_ || drawing_closed_; });
  return written_ < drawn_ ? &images_[written_ % kPictures] : nullptr;
}

void FrameRing::EndWriting() {
  const std::lock_guard lock(mutex_);
  ++written_;
  changed_.notify_all();
}

void FrameRing::StopWriting() {
  const std::lock_guard lock(mutex_);
  writing_stopped_ = true;
  changed_.notify_all();
}

}  // namespace hazumi::render
