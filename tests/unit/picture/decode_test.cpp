#include "engine/picture/decode.h"

#include <gtest/gtest.h>

#include "tests/unit/picture/picture_sample.h"

namespace hazumi {
namespace {

using test::Bytes, test::JpegOf, test::PngOf, test::Scans, test::TwoColors;

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
}  // namespace hazumi
