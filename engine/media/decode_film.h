#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/picture/image.h"

namespace hazumi {

// The pictures of a video, one for each frame of a motion, kept as JPEG files; of a picture file
// one. Not wider than kFilmWidth.
class Film {
 public:
  Film() = default;
  // `jpegs`: one file behind the other.
  explicit Film(std::string jpegs);

  int count() const { return static_cast<int>(begins_.empty() ? 0 : begins_.size() - 1); }
  // kSyntax, kFailed: of DecodePictures.
  Result<Image> PictureAt(int index) const;

 private:
  std::span<const std::uint8_t> Bytes(int index) const;

  std::string jpegs_;
  std::vector<size_t> begins_;  // of each, and the end of the last
};

inline constexpr int kFilmWidth = 960;  // [px]

// At num / den frames a second, from the file's first picture on. Errors: as RunFfmpeg.
Result<Film> DecodeFilm(const std::filesystem::path& file, int num, int den,
                        const std::function<bool()>& is_cancelled);

}  // namespace hazumi
