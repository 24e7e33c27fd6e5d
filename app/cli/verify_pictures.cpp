#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/pictures.h"
#include "app/cli/verify.h"
#include "engine/base/text.h"
#include "engine/picture/decode_pictures.h"
#include "engine/picture/png_texts.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

namespace {

using Json = nlohmann::ordered_json;

struct MadePicture {
  std::string file, maker, renderer;
  int frame = 0;
  std::vector<std::string> options;
};

std::vector<std::string> Words(const std::string& json) {
  std::vector<std::string> words;
  const Json list = Json::parse(json, nullptr, false);
  for (const Json& word : list.is_array() ? list : Json::array()) {
    if (word.is_string()) words.push_back(word.get<std::string>());
  }
  return words;
}

Result<MadePicture> ReadMaking(const std::string& file) {
  const Result<std::string> bytes = ReadTextFile(file);
  if (!bytes.ok()) return bytes.error();
  auto texts = PngTexts(BytesOf(bytes.value()));
  MadePicture made;
  made.file = file;
  const bool says_options = texts.contains("Options");
  made.maker = texts["Maker"];
  made.options = Words(texts["Options"]);
  const std::string& frame = texts["Frame"];
  const auto [end, failed] = std::from_chars(frame.data(), frame.data() + frame.size(), made.frame);
  if (failed == std::errc() && end == frame.data() + frame.size() && says_options) {
    return made;
  }
  return Error{ErrorCode::kSchema, file, "",
               "does not say how it was drawn: this or a newer Hazumi's --render notes it in the "
               "file"};
}

// In order of frames.
Result<std::vector<MadePicture>> PicturesIn(const std::string& folder) {
  std::vector<MadePicture> pictures;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    if (entry.path().extension() != ".png") continue;
    Result<MadePicture> made = ReadMaking(entry.path().string());
    if (!made.ok()) return made.error();
    pictures.push_back(std::move(made).value());
  }
  if (pictures.empty()) {
    return Error{ErrorCode::kNoInput, folder, "", "holds no pictures (.png) to compare"};
  }
  std::sort(pictures.begin(), pictures.end(),
            [](const auto& a, const auto& b) { return a.frame < b.frame; });
  for (const MadePicture& picture : pictures) {
    if (picture.options == pictures.front().options) continue;
    return Error{ErrorCode::kSemantics, picture.file, "",
                 "was drawn with other options than the rest: verify each kind in a folder of its "
                 "own"};
  }
  return pictures;
}

class PixelComparison {
 public:
  // Differences are said of the frame.
  void Compare(const Image& made, const Image& again, int frame) {
    ++pictures_;
    if (made.width != again.width || made.height != again.height) {
      Differ("frame " + std::to_string(frame) + ": " + Size(made) + " pixels as made, " +
             Size(again) + " again");
      return;
    }
    for (size_t i = 0; i < made.rgba.size(); i += 4) ComparePixel(made, again, i, frame);
  }

  long pictures() const { return pictures_; }
  long pixels() const { return pixels_; }
  long differences() const { return differences_; }
  int largest() const { return largest_; }
  const std::string& first() const { return first_; }

 private:
  static std::string Size(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
  }
  static std::string Color(const Image& image, size_t i) {
    return std::to_string(image.rgba[i]) + " " + std::to_string(image.rgba[i + 1]) + " " +
           std::to_string(image.rgba[i + 2]);
  }

  void ComparePixel(const Image& made, const Image& again, size_t i, int frame) {
    ++pixels_;
    int by = 0;
    for (size_t k = i; k < i + 3; ++k) by = std::max(by, std::abs(made.rgba[k] - again.rgba[k]));
    if (by == 0) return;
    largest_ = std::max(largest_, by);
    const auto width = static_cast<size_t>(made.width);
    Differ(first_.empty()
               ? "frame " + std::to_string(frame) + ", pixel (" + std::to_string(i / 4 % width) +
                     ", " + std::to_string(i / 4 / width) + "): " + Color(made, i) + " as made, " +
                     Color(again, i) + " again"
               : "");
  }

  void Differ(const std::string& text) {
    ++differences_;
    if (first_.empty()) first_ = text;
  }

  long pictures_ = 0, pixels_ = 0, differences_ = 0;
  int largest_ = 0;
  std::string first_;
};

Result<Image> Decoded(const std::string& file) {
  const Result<std::string> text = ReadTextFile(file);
  if (!text.ok()) return text.error();
  const std::vector<std::uint8_t> bytes = BytesOf(text.value());
  const std::span<const std::uint8_t> spans[] = {bytes};
  Result<Image> image = std::move(DecodePictures(spans).front());
  if (!image.ok()) return InFile(image.error(), file);
  return image;
}

// Draws what was made, in runs of frames, and compares.
Result<Done> DrawAgain(const BakedProject& baked, const std::vector<MadePicture>& made,
                       const Options& options, PixelComparison* comparison) {
  const Result<Motion> paths = PathMotion(baked, options);
  if (!paths.ok()) return paths.error();
  const auto skin = SkinOn(baked, options.files[0]);
  if (!skin.ok()) return skin.error();
  const auto things = ThingsOf(baked, options.files[0]);
  if (!things.ok()) return things.error();
  const auto film = FilmOf(baked, options.files[0], options.open_outside);
  if (!film.ok()) return film.error();
  const PictureSize size = PictureSizeOf(options);
  for (size_t first = 0; first < made.size();) {
    size_t end = first + 1;
    while (end < made.size() && made[end].frame == made[end - 1].frame + 1) ++end;
    Pictures pictures(baked, {made[first].frame, made[end - 1].frame}, paths.value(), skin.value(),
                      things.value(), film.value(), size, options);
    render::Sequence sequence = pictures.Sequence();
    sequence.write = [&](int i, const Image& image) -> Result<Done> {
      const MadePicture& picture = made[first + static_cast<size_t>(i)];
      const Result<Image> before = Decoded(picture.file);
      if (!before.ok()) return before.error();
      comparison->Compare(before.value(), image, picture.frame);
      return Done();
    };
    const Result<int> drawn = RenderSequence(SequenceOptionsOf(options, size), sequence);
    if (!drawn.ok()) return drawn.error();
    if (Interrupted()) return InterruptedError();
    first = end;
  }
  return Done();
}

}  // namespace

Result<Verdict> VerifyPictures(const std::string& project, const std::string& folder,
                               bool open_outside) {
  const auto made = PicturesIn(folder);
  if (!made.ok()) return made.error();
  const MadePicture& one = made.value().front();
  Result<Options> options = OptionsToMakeAgain({"--render", "again"}, one.options, project);
  if (!options.ok()) return options.error();
  options.value().open_outside = open_outside;  // whatever the pictures say
  const Result<BakedProject> baked = LoadAndBake(project, options.value());
  if (!baked.ok()) return baked.error();
  const auto& frames = baked.value().motion.frames;
  for (const MadePicture& picture : made.value()) {
    if (picture.frame >= frames.front().frame && picture.frame <= frames.back().frame) continue;
    return Error{
        ErrorCode::kSemantics, picture.file, "",
        "shows frame " + std::to_string(picture.frame) + ", which " + project + " does not have"};
  }
  PixelComparison comparison;
  const Result<Done> drawn = DrawAgain(baked.value(), made.value(), options.value(), &comparison);
  if (!drawn.ok()) return drawn.error();
  Verdict verdict;
  RemarkOnMaker(one.maker, &verdict);
  verdict.is_same = comparison.differences() == 0;
  const std::string of = std::to_string(comparison.pixels()) + " pixels of " +
                         std::to_string(comparison.pictures()) + " pictures";
  verdict.sentence = verdict.is_same ? "the same: " + of
                                     : "differs: " + comparison.first() + "; " +
                                           std::to_string(comparison.differences()) + " of " + of +
                                           " differ, by " + std::to_string(comparison.largest()) +
                                           " of 255 at most";
  return verdict;
}

}  // namespace hazumi
