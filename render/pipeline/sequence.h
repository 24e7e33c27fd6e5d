#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/base/result.h"
#include "engine/picture/image.h"
#include "render/gl/renderer.h"
#include "render/image/png.h"
#include "render/scene/scene.h"

namespace hazumi::render {

struct SequenceOptions {
  int width = 1280;  // [px]
  int height = 720;
  RendererOptions renderer;
  int threads = 2;  // 1: draw and write in turn; 2: write beside drawing. The same bytes either way
};

// What to draw and where. `frame` counts from 0.
struct Sequence {
  int frame_count = 0;
  std::function<Result<Scene>(int frame)> scene;            // called on the calling thread
  std::function<std::filesystem::path(int frame)> path;     // called on either thread
  std::function<std::vector<PngText>(int frame)> metadata;  // either thread; may be empty
  // Takes each picture in place of a PNG file, in order, on the writing thread; may be empty.
  std::function<Result<Done>(int frame, const Image& image)> write;
  std::function<void(int written)> progress;  // after each picture, in order, on the writing
                                              // thread; may be empty
  const std::atomic<bool>* cancel = nullptr;  // set it to stop after the frame at hand
};

// Renders a sequence of PNG files without a screen. Stops at the first error and returns it. Files
// written until then stay, each of them whole; cancelling is no error.
// Returns the number of files written.
Result<int> RenderSequence(const SequenceOptions& options, const Sequence& sequence);

}  // namespace hazumi::render
