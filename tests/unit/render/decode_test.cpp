#include "render/image/decode.h"

#include <gtest/gtest.h>

#include <cstdio>
// jpeglib.h needs the declarations of stdio.
#include <jpeglib.h>

#include <cstdlib>

#include "render/image/halve.h"
#include "render/image/png.h"

namespace hazumi::render {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Red above, blue below.
Image TwoColors(int size) {
  Image image(size, size);
  for (int i = 0; i < size * size; ++i) {
    const bool above = i < size * size / 2;
    image.rgba[4 * i + (above ? 0 : 2)] = 255;
    image.rgba[4 * i + 3] = 255;
  }
  return image;
}

Bytes PngOf(const Image& image) { return EncodePng(image, {}).value(); }

enum class Scans { kOne, kProgressive };

Bytes JpegOf(const Image& image, Scans scans = Scans::kOne, J_COLOR_SPACE space = JCS_EXT_RGBA) {
  jpeg_compress_struct cinfo{};
  jpeg_error_mgr errors{};
  cinfo.err = jpeg_std_error(&errors);
  jpeg_create_compress(&cinfo);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&cinfo, &data, &size);
  cinfo.image_width = image.width;
  cinfo.image_height = image.height;
  cinfo.input_components = 4;
  cinfo.in_color_space = space;
  jpeg_set_defaults(&cinfo);
  jpeg_set_quality(&cinfo, 95, TRUE);
  if (scans == Scans::kProgressive) jpeg_simple_progression(&cinfo);
  jpeg_start_compress(&cinfo, TRUE);
  while (cinfo.next_scanline < cinfo.image_height) {
    auto* row = const_cast<JSAMPROW>(image.rgba.data() + cinfo.next_scanline * image.width * 4);
    jpeg_write_scanlines(&cinfo, &row, 1);
  }
  jpeg_finish_compress(&cinfo);
  const Bytes bytes(data, data + size);
  jpeg_destroy_compress(&cinfo);
  std::free(data);
  return bytes;
}

void ExpectTwoColors(const Result<Image>& image, int size) {
  ASSERT_TRUE(image.ok()) << image.error().ToString();
  ASSERT_EQ(image.value().width, size);
  ASSERT_EQ(image.value().height, size);
  const std::uint8_t* top = image.value().rgba.data();
  const std::uint8_t* bottom = &image.value().rgba[image.value().rgba.size() - 4];
  EXPECT_GT(top[0], 245);
  EXPECT_LT(top[2], 10);
  EXPECT_LT(bottom[0], 10);
  EXPECT_GT(bottom[2], 245);
  EXPECT_EQ(bottom[3], 255);
}

// The message tells the user what to do.
void ExpectRefused(const Bytes& file, const std::string& part_of_message) {
  const Result<Image> image = DecodeImage(file);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::kSyntax);
  EXPECT_NE(image.error().message.find(part_of_message), std::string::npos)
      << image.error().message;
}

// The size that the header claims, where the two formats keep it.
Bytes ClaimingSize(Bytes png, std::uint32_t width, std::uint32_t height) {
  for (int i = 0; i < 4; ++i) {
    png[16 + i] = static_cast<std::uint8_t>(width >> (24 - 8 * i));
    png[20 + i] = static_cast<std::uint8_t>(height >> (24 - 8 * i));
  }
  std::uint32_t crc = 0xffffffff;
  for (int i = 12; i < 29; ++i) {
    crc ^= png[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xedb88320u : 0u);
  }
  for (int i = 0; i < 4; ++i) png[29 + i] = static_cast<std::uint8_t>(~crc >> (24 - 8 * i));
  return png;
}

TEST(DecodeImage, TellsPngAndJpegApartByContent) {
  const Image image = TwoColors(16);
  ExpectTwoColors(DecodeImage(PngOf(image)), 16);
  ExpectTwoColors(DecodeImage(JpegOf(image)), 16);
}

TEST(DecodeImage, ReadsProgressiveAndInkedJpegs) {
  ExpectTwoColors(DecodeImage(JpegOf(TwoColors(32), Scans::kProgressive)), 32);
  // Bytes r, g, b, 255 as inks that are left out: cyan 255 is no cyan, hence red.
  ExpectTwoColors(DecodeImage(JpegOf(TwoColors(32), Scans::kOne, JCS_CMYK)), 32);
}

TEST(DecodeImage, RefusesOtherFormatsBySayingWhichItTakes) {
  ExpectRefused({}, "neither a PNG nor a JPEG");
  ExpectRefused({'G', 'I', 'F', '8', '9', 'a'}, "neither a PNG nor a JPEG");
  ExpectRefused({0xff, 0xd8}, "neither a PNG nor a JPEG");
}

TEST(DecodeImage, RefusesFilesThatAreCutOffAnywhere) {
  const Image image = TwoColors(48);
  for (const Bytes& whole : {PngOf(image), JpegOf(image), JpegOf(image, Scans::kProgressive)}) {
    ASSERT_TRUE(DecodeImage(whole).ok());
    for (size_t size = 0; size + 2 < whole.size(); ++size) {
      EXPECT_FALSE(DecodeImage(Bytes(whole.begin(), whole.begin() + size)).ok()) << size;
    }
  }
}

// Whatever comes out, nothing crashes and a picture has its pixels.
TEST(DecodeImage, SurvivesAnyChangedByte) {
  const Image image = TwoColors(24);
  for (const Bytes& whole : {PngOf(image), JpegOf(image), JpegOf(image, Scans::kProgressive)}) {
    for (size_t i = 0; i < whole.size(); ++i) {
      Bytes changed = whole;
      changed[i] ^= 0x55;
      const Result<Image> decoded = DecodeImage(changed);
      if (!decoded.ok()) continue;
      EXPECT_EQ(decoded.value().rgba.size(),
                size_t{4} * decoded.value().width * decoded.value().height);
    }
  }
}

TEST(Halved, IsTheMeanOfFourPixelsAndKeepsOne) {
  Image image(3, 1);  // the third column of an odd width is dropped
  image.rgba = {0, 100, 0, 255, 50, 200, 0, 255, 9, 9, 9, 9};
  const Image half = Halved(image);
  ASSERT_EQ(half.width, 1);
  ASSERT_EQ(half.height, 1);
  EXPECT_EQ(half.rgba, (Bytes{25, 150, 0, 255}));
  EXPECT_EQ(Halved(half).rgba, half.rgba);
}

TEST(DecodeImage, RefusesPicturesTooLargeForMemoryBeforeTakingIt) {
  const Bytes png = PngOf(TwoColors(8));
  ExpectRefused(ClaimingSize(png, 16385, 1), "16385 x 1");
  ExpectRefused(ClaimingSize(png, 16384, 16384), "16384 x 16384");
  Bytes jpeg = JpegOf(TwoColors(8));
  for (size_t i = 0; i + 8 < jpeg.size(); ++i) {
    if (jpeg[i] != 0xff || jpeg[i + 1] != 0xc0) continue;
    jpeg[i + 5] = jpeg[i + 7] = 0x3f;  // height and width 16136
    jpeg[i + 6] = jpeg[i + 8] = 0x08;
  }
  ExpectRefused(jpeg, "16136 x 16136");
}

}  // namespace
}  // namespace hazumi::render
