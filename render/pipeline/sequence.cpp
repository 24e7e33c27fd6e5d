#include "render/pipeline/sequence.h"

#include <thread>

#include "engine/base/memory.h"
#include "render/pipeline/frame_ring.h"
#include "render/pipeline/offscreen.h"

namespace hazumi::render {
namespace {

bool IsCancelled(const Sequence& sequence) {
  return sequence.cancel != nullptr && sequence.cancel->load();
}

Result<Done> WriteFile(const Sequence& sequence, int frame, const Image& image) {
  const auto texts = sequence.metadata ? sequence.metadata(frame) : std::vector<PngText>{};
  return WritePng(sequence.path(frame), image, texts);
}

Result<Done> WriteFrame(const Sequence& sequence, int frame, const Image& image) {
  Result<Done> written =
      sequence.write ? sequence.write(frame, image) : WriteFile(sequence, frame, image);
  if (written.ok() && sequence.progress) sequence.progress(frame + 1);
  return written;
}

Result<int> RenderInTurn(OffscreenRenderer& renderer, const SequenceOptions& options,
                         const Sequence& sequence) {
  Image image(options.width, options.height);
  int frame = 0;
  for (; frame < sequence.frame_count && !IsCancelled(sequence); ++frame) {
    const Result<Scene> scene = sequence.scene(frame);
    if (!scene.ok()) return scene.error();
    const Result<Done> drawn = renderer.Draw(scene.value(), image);
    if (!drawn.ok()) return drawn.error();
    const Result<Done> written = WriteFrame(sequence, frame, image);
    if (!written.ok()) return written.error();
  }
  return frame;
}

Result<Done> DrawAll(OffscreenRenderer& renderer, const Sequence& sequence, FrameRing& ring) {
  for (int frame = 0; frame < sequence.frame_count && !IsCancelled(sequence); ++frame) {
    const Result<Scene> scene = sequence.scene(frame);
    if (!scene.ok()) return scene.error();
    Image* image = ring.BeginDrawing();
    if (image == nullptr) break;
    Result<Done> drawn = renderer.Draw(scene.value(), *image);
    if (!drawn.ok()) return drawn;
    ring.EndDrawing();
  }
  return Done{};
}

Result<int> WriteFrames(const Sequence& sequence, FrameRing& ring) {
  int frame = 0;
  while (const Image* image = ring.BeginWriting()) {
    const Result<Done> written = WriteFrame(sequence, frame, *image);
    if (!written.ok()) {
      ring.StopWriting();
      return written.error();
    }
    ring.EndWriting();
    ++frame;
  }
  return frame;
}

Result<int> RenderSideBySide(OffscreenRenderer& renderer, const SequenceOptions& options,
                             const Sequence& sequence) {
  FrameRing ring(options.width, options.height);
  Result<int> written = 0;
  std::thread writer([&] {
    written = WithinMemory([&] { return WriteFrames(sequence, ring); });
    if (!written.ok()) ring.StopWriting();
  });
  const Result<Done> drawn = WithinMemory([&] { return DrawAll(renderer, sequence, ring); });
  ring.CloseDrawing();
  writer.join();
  if (!drawn.ok()) return drawn.error();
  return written;
}

}  // namespace

Result<int> RenderSequence(const SequenceOptions& options, const Sequence& sequence) {
  Result<OffscreenRenderer> renderer = OffscreenRenderer::Create(options.renderer);
  if (!renderer.ok()) return renderer.error();
  if (options.threads < 2) return RenderInTurn(renderer.value(), options, sequence);
  return RenderSideBySide(renderer.value(), options, sequence);
}

}  // namespace hazumi::render
