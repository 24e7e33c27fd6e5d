#include "render/image/png.h"

#include <gtest/gtest.h>

#include "png_file.h"
#include "temp_folder.h"

namespace hazumi::render {
namespace {

Image Gradient(int width, int height) {
  Image image(width, height);
  for (size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(i * 37);
  }
  return image;
}

std::string Encoded(const Image& image, const std::vector<PngText>& texts) {
  const auto bytes = EncodePng(image, texts).value();
  return {bytes.begin(), bytes.end()};
}

TEST(Png, RoundTripKeepsPixelsAndTexts) {
  const TempFolder folder;
  const Image image = Gradient(33, 17);
  const std::vector<PngText> texts = {{"Software", "Hazumi 0.1"}, {"Project", "弾み.kfa"}};
  ASSERT_TRUE(WritePng(folder.path() / "a.png", image, texts).ok());
  const Result<Image> back = ReadPng(folder.path() / "a.png");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back.value().rgba, image.rgba);
  // As the standard lays them out: keyword, null, text; and, for UTF-8, keyword, null, not
  // compressed (two bytes), no language, no translated keyword, text.
  using namespace std::string_literals;
  const std::string bytes = BytesOf(folder.path() / "a.png");
  EXPECT_NE(bytes.find("tEXtSoftware\0Hazumi 0.1"s), std::string::npos);
  EXPECT_NE(bytes.find("iTXtProject\0\0\0\0\0弾み.kfa"s), std::string::npos);
}

TEST(Png, HasSrgbAndNoDate) {
  const std::string bytes = Encoded(Gradient(8, 8), {{"Frame", "3"}});
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  EXPECT_NE(bytes.find("tEXtFrame"), std::string::npos);
  EXPECT_EQ(bytes.find("tIME"), std::string::npos);
  EXPECT_EQ(bytes[25], 2) << "colour type RGB";
}

TEST(Png, IgnoresTheFourthByte) {
  Image seen = Gradient(8, 8), other = seen;
  for (size_t i = 3; i < other.rgba.size(); i += 4) other.rgba[i] = 7;
  EXPECT_EQ(Encoded(seen, {}), Encoded(other, {}));
}

TEST(Png, RefusesAPictureWithoutPixelsAndABadKey) {
  EXPECT_FALSE(EncodePng(Image(0, 0), {}).ok());
  EXPECT_FALSE(EncodePng(Gradient(2, 2), {{"", "x"}}).ok());
  EXPECT_FALSE(EncodePng(Gradient(2, 2), {{std::string(80, 'k'), "x"}}).ok());
}

TEST(Png, FailureNamesTheFileAndLeavesNothing) {
  const TempFolder folder;
  const auto missing = folder.path() / "no" / "a.png";
  const Result<Done> written = WritePng(missing, Gradient(4, 4), {});
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
  EXPECT_EQ(written.error().file, missing.string());
  EXPECT_NE(written.error().message.find("No such file"), std::string::npos);
  EXPECT_EQ(folder.file_count(), 0);
}

// A folder in the place of the file: the temporary file is written, the rename fails.
TEST(Png, FailedRenameRemovesTheTemporaryFile) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path() / "a.png" / "inside");
  ASSERT_FALSE(WritePng(folder.path() / "a.png", Gradient(4, 4), {}).ok());
  EXPECT_EQ(folder.file_count(), 1);
}

TEST(Png, ReplacesAnOlderFile) {
  const TempFolder folder;
  ASSERT_TRUE(WritePng(folder.path() / "a.png", Gradient(4, 4), {}).ok());
  ASSERT_TRUE(WritePng(folder.path() / "a.png", Gradient(5, 5), {}).ok());
  EXPECT_EQ(ReadPng(folder.path() / "a.png").value().width, 5);
  EXPECT_EQ(folder.file_count(), 1);
}

}  // namespace
}  // namespace hazumi::render
