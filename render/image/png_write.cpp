// libpng reports errors by longjmp: the functions between setjmp and the calls hold nothing that
// needs a destructor.

#include <png.h>

#include <algorithm>
#include <csetjmp>

#include "engine/base/atomic_file.h"
#include "render/image/png.h"

namespace hazumi::render {
namespace {

// With the SUB filter a quarter of the default's time. Gradients and flat areas become runs, so
// that looking for runs alone (zlib's Z_RLE) is faster than level 1's search and no larger.
constexpr int kCompressionLevel = 1;
constexpr int kRunLengths = 3;

struct EncodeJob {
  const Image* image;
  std::vector<png_text>* texts;
  std::vector<std::uint8_t> bytes;
  char problem[128] = "libpng failed";
};

void OnError(png_structp png, png_const_charp message) {
  auto* job = static_cast<EncodeJob*>(png_get_error_ptr(png));
  std::snprintf(job->problem, sizeof(job->problem), "%s", message);
  std::longjmp(png_jmpbuf(png), 1);
}

void OnWarning(png_structp png, png_const_charp message) { OnError(png, message); }

void OnWrite(png_structp png, png_bytep data, size_t size) {
  auto& bytes = static_cast<EncodeJob*>(png_get_io_ptr(png))->bytes;
  bytes.insert(bytes.end(), data, data + size);
}

void WriteHeader(png_structp png, png_infop info, EncodeJob& job) {
  png_set_IHDR(png, info, static_cast<png_uint_32>(job.image->width),
               static_cast<png_uint_32>(job.image->height), 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_text(png, info, job.texts->data(), static_cast<int>(job.texts->size()));
  png_set_compression_level(png, kCompressionLevel);
  png_set_compression_strategy(png, kRunLengths);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_write_info(png, info);
  png_set_filler(png, 0, PNG_FILLER_AFTER);
}

bool RunJob(png_structp png, png_infop info, EncodeJob& job) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &job, OnWrite, nullptr);
  WriteHeader(png, info, job);
  const size_t stride = static_cast<size_t>(job.image->width) * 4;
  for (int row = 0; row < job.image->height; ++row) {
    png_write_row(png, job.image->rgba.data() + row * stride);
  }
  png_write_end(png, nullptr);
  return true;
}

bool IsAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return (c & 0x80) == 0; });
}

std::vector<png_text> ToLibpng(const std::vector<PngText>& texts) {
  std::vector<png_text> out;
  for (const PngText& t : texts) {
    png_text chunk{};
    const bool ascii = IsAscii(t.value);
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(t.key.c_str());
    chunk.text = const_cast<char*>(t.value.c_str());
    (ascii ? chunk.text_length : chunk.itxt_length) = t.value.size();
    out.push_back(chunk);
  }
  return out;
}

bool HasBadKey(const std::vector<PngText>& texts) {
  return std::any_of(texts.begin(), texts.end(), [](const PngText& t) {
    return t.key.empty() || t.key.size() > 79 || !IsAscii(t.key);
  });
}

}  // namespace

Result<std::vector<std::uint8_t>> EncodePng(const Image& image, const std::vector<PngText>& texts) {
  if (HasBadKey(texts)) {
    return Error{ErrorCode::kCannotWrite, "", "",
                 "the name of a PNG text must have 1 to 79 ASCII letters"};
  }
  std::vector<png_text> chunks = ToLibpng(texts);
  EncodeJob job{&image, &chunks, {}};
  job.bytes.reserve(image.rgba.size() / 8);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, OnError, OnWarning);
  png_infop info = png_create_info_struct(png);
  const bool written = RunJob(png, info, job);
  png_destroy_write_struct(&png, &info);
  if (!written) return Error{ErrorCode::kCannotWrite, "", "", job.problem};
  return std::move(job.bytes);
}

Result<Done> WritePng(const std::filesystem::path& path, const Image& image,
                      const std::vector<PngText>& texts) {
  Result<std::vector<std::uint8_t>> bytes = EncodePng(image, texts);
  if (bytes.ok()) {
    const auto* data = reinterpret_cast<const char*>(bytes.value().data());
    return WriteFileAtomically(path.string(), {data, bytes.value().size()});
  }
  Error error = bytes.error();
  error.file = path.string();
  return error;
}

}  // namespace hazumi::render
