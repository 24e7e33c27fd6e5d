#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

#include "engine/base/result.h"
#include "engine/media/sound_part.h"
#include "engine/picture/image.h"
#include "render/pipeline/sequence.h"

namespace hazumi::render {

// An MP4 file (H.264, 4:2:0, BT.709) of pictures of one size, made by the program ffmpeg, which
// takes them through a pipe. The file appears when it is whole; until then it has
// no name, or where the file system has no such files a hidden one beside it.
struct VideoFormat {
  std::filesystem::path path;
  int width = 1280, height = 720;       // [px], even
  int rate_num = 30, rate_den = 1;      // frames a second = num / den
  std::optional<SoundPart> sound = {};  // heard with it, as AAC
};

class VideoWriter {
 public:
  // Decodes the sound first. Errors: those of DecodeSoundPart and WhyKept; kFailed: a size that
  // is odd; ffmpeg is not installed.
  static Result<VideoWriter> Start(const VideoFormat& format,
                                   const std::atomic<bool>* cancel = nullptr);
  // Without Finish nothing is left of the file.
  ~VideoWriter();
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) = delete;

  // Errors of both: what ffmpeg says (kFailed), or why the file cannot take its name.
  Result<Done> Write(const Image& image);
  Result<Done> Finish(const std::atomic<bool>* cancel = nullptr);

 private:
  struct Process;
  explicit VideoWriter(std::unique_ptr<Process> process);
  std::unique_ptr<Process> process_;
};

// Renders a sequence into a video; its `path` and `metadata` are not heeded. Stops at the first
// error, and before the first picture if the sound cannot be read; then, and when it is cancelled,
// no file is left. Returns the number of frames.
Result<int> RenderVideo(const SequenceOptions& options, const Sequence& sequence,
                        const VideoFormat& format);

}  // namespace hazumi::render
