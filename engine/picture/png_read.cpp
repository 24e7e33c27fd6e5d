// libpng reports errors by longjmp: between setjmp and its calls nothing lives on the stack that
// needs a destructor.

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>

#include "engine/picture/decode.h"
#include "engine/picture/image.h"

namespace hazumi {
namespace {

struct DecodeJob {
  std::span<const std::uint8_t> rest;
  char problem[128] = "";
  std::string size_problem;
  Image image;
  std::vector<png_bytep> rows;
};

void OnError(png_structp png, png_const_charp message) {
  auto* job = static_cast<DecodeJob*>(png_get_error_ptr(png));
  std::snprintf(job->problem, sizeof(job->problem), "%s", message);
  std::longjmp(png_jmpbuf(png), 1);
}

void OnWarning(png_structp, png_const_charp) {}

void OnRead(png_structp png, png_bytep to, size_t size) {
  auto* job = static_cast<DecodeJob*>(png_get_io_ptr(png));
  if (size > job->rest.size()) png_error(png, "it ends too early");
  std::copy_n(job->rest.begin(), size, to);
  job->rest = job->rest.subspan(size);
}

// To 8-bit RGBA, whatever the file holds.
void AskForRgba(png_structp png, png_infop info) {
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

bool ReadPixels(png_structp png, png_infop info, DecodeJob* job) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);  // ComplaintOnSize has a better message
  png_set_read_fn(png, job, OnRead);
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info);
  const png_uint_32 height = png_get_image_height(png, info);
  job->size_problem = ComplaintOnSize(width, height);
  if (!job->size_problem.empty()) return false;
  AskForRgba(png, info);
  job->image = Image(static_cast<int>(width), static_cast<int>(height));
  for (size_t row = 0; row < height; ++row) {
    job->rows.push_back(job->image.rgba.data() + row * width * 4);
  }
  png_read_image(png, job->rows.data());
  png_read_end(png, info);
  return true;
}

}  // namespace

Result<Image> DecodePng(std::span<const std::uint8_t> file) {
  DecodeJob job;
  job.rest = file;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, OnError, OnWarning);
  png_infop info = png_create_info_struct(png);
  const bool read = ReadPixels(png, info, &job);
  png_destroy_read_struct(&png, &info, nullptr);
  if (read) return std::move(job.image);
  if (!job.size_problem.empty()) return Error{ErrorCode::kSyntax, "", "", job.size_problem};
  return Error{ErrorCode::kSyntax, "", "",
               std::string("the file is not a whole PNG (") + job.problem +
                   "); save it anew with another program"};
}

}  // namespace hazumi
