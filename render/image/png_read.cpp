#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <memory>

#include "render/image/png.h"

namespace hazumi::render {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void OnError(png_structp png, png_const_charp) { std::longjmp(png_jmpbuf(png), 1); }
void OnWarning(png_structp, png_const_charp) {}

bool ReadPixels(png_structp png, png_infop info, std::FILE* file, Image& image) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  png_read_info(png, info);
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_read_update_info(png, info);
  image = Image(static_cast<int>(png_get_image_width(png, info)),
                static_cast<int>(png_get_image_height(png, info)));
  const size_t stride = static_cast<size_t>(image.width) * 4;
  for (int row = 0; row < image.height; ++row) {
    png_read_row(png, image.rgba.data() + row * stride, nullptr);
  }
  png_read_end(png, info);
  return true;
}

void CopyTexts(png_structp png, png_infop info, std::vector<PngText>& texts) {
  png_textp chunks = nullptr;
  const int count = png_get_text(png, info, &chunks, nullptr);
  for (int i = 0; i < count; ++i) texts.push_back({chunks[i].key, chunks[i].text});
}

}  // namespace

Result<Image> ReadPng(const std::filesystem::path& path, std::vector<PngText>* texts) {
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "rb"));
  if (!file) return Error{ErrorCode::kNoInput, path.string(), "", "the file cannot be opened"};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, OnError, OnWarning);
  png_infop info = png_create_info_struct(png);
  Image image;
  const bool read = ReadPixels(png, info, file.get(), image);
  if (read && texts != nullptr) CopyTexts(png, info, *texts);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!read) return Error{ErrorCode::kSyntax, path.string(), "", "the file is not a whole PNG"};
  return image;
}

}  // namespace hazumi::render
