#include "engine/picture/picture_bytes.h"

#include <optional>

#include "engine/base/byte_stream.h"
#include "engine/base/utf8.h"
#include "engine/picture/image.h"

namespace hazumi {
namespace {

constexpr std::uint32_t kMagic = 0x50'4d'5a'48;  // "HZMP"
constexpr std::uint32_t kVersion = 1;
enum : std::uint8_t { kIsError = 0, kIsPicture = 1 };

// One answer; none if what comes next is not sound.
std::optional<Result<Image>> NextAnswer(ByteReader* reader, std::int64_t pixels_left) {
  std::uint8_t kind = 0xff;
  reader->Value(kind);
  if (kind == kIsError) {
    std::string message;
    reader->Text(message);
    if (!reader->ok() || message.empty()) return std::nullopt;
    return Error{ErrorCode::kSyntax, "", "", ValidUtf8(message)};
  }
  Image image;
  reader->Value(image.width);
  reader->Value(image.height);
  reader->Flat(image.rgba);
  const std::int64_t pixels = std::int64_t{image.width} * image.height;
  const bool is_sound = kind == kIsPicture && reader->ok() && pixels <= pixels_left &&
                        ComplaintOnSize(image.width, image.height).empty() &&
                        image.rgba.size() == 4 * static_cast<std::uint64_t>(pixels);
  if (!is_sound) return std::nullopt;
  return image;
}

}  // namespace

std::string RequestToBytes(std::span<const std::span<const std::uint8_t>> files,
                           std::int64_t pixels_left) {
  ByteWriter writer;
  std::uint32_t magic = kMagic, version = kVersion;
  std::uint64_t count = files.size();
  writer.Value(magic);
  writer.Value(version);
  writer.Value(pixels_left);
  writer.Value(count);
  for (const std::span<const std::uint8_t> file : files) writer.Bytes(file.data(), file.size());
  return writer.Take();
}

Result<PictureRequest> RequestFromBytes(std::string_view bytes) {
  ByteReader reader(bytes);
  std::uint32_t magic = 0, version = 0;
  std::uint64_t count = 0;
  PictureRequest request;
  reader.Value(magic);
  reader.Value(version);
  reader.Value(request.pixels_left);
  reader.Value(count);
  for (std::uint64_t i = 0; reader.ok() && i < count; ++i) {
    const std::string_view file = reader.Bytes();
    request.files.emplace_back(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  }
  if (magic == kMagic && version == kVersion && reader.at_end()) return request;
  return Error{ErrorCode::kSyntax, "", "", "this is no request to decode pictures"};
}

std::string AnswerToBytes(Result<Image> decoded) {
  ByteWriter writer;
  std::uint8_t kind = decoded.ok() ? kIsPicture : kIsError;
  writer.Value(kind);
  if (decoded.ok()) {
    writer.Value(decoded.value().width);
    writer.Value(decoded.value().height);
    writer.Flat(decoded.value().rgba);
  } else {
    const std::string& message = decoded.error().message;
    writer.Bytes(message.data(), message.size());
  }
  return writer.Take();
}

std::vector<Result<Image>> AnswersFromBytes(std::string_view bytes, size_t most,
                                            std::int64_t pixels_left) {
  ByteReader reader(bytes);
  std::vector<Result<Image>> answers;
  while (answers.size() < most) {
    std::optional<Result<Image>> answer = NextAnswer(&reader, pixels_left);
    if (!answer) break;
    if (answer->ok()) pixels_left -= std::int64_t{answer->value().width} * answer->value().height;
    answers.push_back(*std::move(answer));
  }
  return answers;
}

}  // namespace hazumi
