#include "engine/media/decode_film.h"

#include <array>
#include <utility>

#include "engine/media/ffmpeg.h"
#include "engine/picture/decode_pictures.h"

namespace hazumi {

namespace {

constexpr std::string_view kEndOfImage = "\xff\xd9";  // inside its data 0xff is followed by 0

std::string Filter(int num, int den) {
  return "setpts=PTS-STARTPTS,fps=" + std::to_string(num) + "/" + std::to_string(den) +
         ",scale=w='min(iw," + std::to_string(kFilmWidth) + ")':h=-2";
}

}  // namespace

Film::Film(std::string jpegs) : jpegs_(std::move(jpegs)), begins_{0} {
  size_t end = 0;
  while ((end = jpegs_.find(kEndOfImage, end)) != std::string::npos) {
    end += kEndOfImage.size();
    begins_.push_back(end);
  }
}

std::span<const std::uint8_t> Film::Bytes(int index) const {
  const auto* data = reinterpret_cast<const std::uint8_t*>(jpegs_.data());
  return {data + begins_[index], begins_[index + 1] - begins_[index]};
}

Result<Image> Film::PictureAt(int index) const {
  const std::array<std::span<const std::uint8_t>, 1> file = {Bytes(index)};
  return std::move(DecodePictures(file).front());
}

Result<Film> DecodeFilm(const std::filesystem::path& file, int num, int den,
                        const std::function<bool()>& is_cancelled) {
  const std::vector<std::string> output = {"-map",           "0:v:0", "-an",        "-vf",
                                           Filter(num, den), "-f",    "image2pipe", "-c:v",
                                           "mjpeg",          "-q:v",  "3"};
  Result<std::string> bytes = RunFfmpeg(
      file, output, {"picture", "choose another file, or convert it to MP4 or PNG"}, is_cancelled);
  if (!bytes.ok()) return bytes.error();
  Film film(std::move(bytes.value()));
  if (film.count() > 0) return film;
  return Error{ErrorCode::kSyntax, file.string(), "",
               "ffmpeg finds no picture in it; choose another file"};
}

}  // namespace hazumi
