#include "engine/picture/decode_pictures.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>

#include "engine/base/memory.h"
#include "engine/picture/decode.h"
#include "engine/picture/picture_bytes.h"
#include "tests/unit/picture/picture_sample.h"

namespace hazumi {
namespace {

using test::Bytes, test::JpegOf, test::PngOf, test::Scans, test::TwoColors;

std::vector<Result<Image>> Decoded(const std::vector<Bytes>& files,
                                   const ReadOptions& options = {}) {
  const std::vector<std::span<const std::uint8_t>> spans(files.begin(), files.end());
  return DecodePictures(spans, options);
}

void ExpectError(const Result<Image>& image, ErrorCode code, const std::string& words) {
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, code);
  EXPECT_NE(image.error().message.find(words), std::string::npos) << image.error().message;
}

void ExpectNoChildren() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(DecodePictures, PixelsAreThoseThatTheLibrariesGive) {
  const std::vector<Bytes> files = {PngOf(TwoColors(16)), JpegOf(TwoColors(32)),
                                    JpegOf(TwoColors(48), Scans::kProgressive),
                                    PngOf(TwoColors(1))};
  const std::vector<Result<Image>> images = Decoded(files);
  ASSERT_EQ(images.size(), files.size());
  for (size_t i = 0; i < files.size(); ++i) {
    ASSERT_TRUE(images[i].ok()) << images[i].error().message;
    EXPECT_EQ(images[i].value().rgba, DecodeImage(files[i]).value().rgba);
  }
  ExpectNoChildren();
}

TEST(DecodePictures, ABrokenOneIsNamedAndTheOthersAreThere) {
  Bytes cut = PngOf(TwoColors(16));
  cut.resize(60);
  const auto images = Decoded({PngOf(TwoColors(16)), cut, {}, JpegOf(TwoColors(16))});
  ASSERT_EQ(images.size(), 4u);
  EXPECT_TRUE(images[0].ok());
  ExpectError(images[1], ErrorCode::kSyntax, "not a whole PNG");
  ExpectError(images[2], ErrorCode::kSyntax, "neither a PNG nor a JPEG");
  EXPECT_TRUE(images[3].ok());
}

// Its pixels alone are 100 MB.
TEST(DecodePictures, OneThatSwellsIsLeftOutAlone) {
  if (kHasShadowMemory) {
    GTEST_SKIP() << "not here: the sanitizer's shadow memory rules out a limit";
  }
  ReadOptions options;
  options.limits.memory = 128u << 20;
  const auto images =
      Decoded({PngOf(TwoColors(16)), PngOf(TwoColors(5000)), PngOf(TwoColors(32))}, options);
  ASSERT_EQ(images.size(), 3u);
  EXPECT_TRUE(images[0].ok());
  ExpectError(images[1], ErrorCode::kSyntax, "128 MB of memory");
  ASSERT_TRUE(images[2].ok());
  EXPECT_EQ(images[2].value().width, 32);
  ExpectNoChildren();
}

TEST(DecodePictures, OneThatTakesTooLongIsLeftOutAlone) {
  ReadOptions options;
  options.limits.seconds = 0.2;
  const auto start = std::chrono::steady_clock::now();
  options.trouble = "hang";
  const auto images =
      Decoded({PngOf(TwoColors(16)), PngOf(TwoColors(16)), PngOf(TwoColors(16))}, options);
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(images.size(), 3u);
  ExpectError(images[0], ErrorCode::kSyntax, "0.2 s");
  ExpectError(images[2], ErrorCode::kSyntax, "took all the time");
  EXPECT_GE(gone.count(), 0.39);
  ExpectNoChildren();
}

TEST(DecodePictures, ACrashAndGarbageAreErrors) {
  for (const auto& [trouble, words] : {std::pair{"crash", "crashed"}, {"garbage", "no usable"}}) {
    ReadOptions options;
    options.trouble = trouble;
    const auto images = Decoded({PngOf(TwoColors(16)), PngOf(TwoColors(16))}, options);
    ASSERT_EQ(images.size(), 2u);
    for (const Result<Image>& image : images) ExpectError(image, ErrorCode::kSyntax, words);
    ExpectNoChildren();
  }
}

TEST(DecodePictures, AnEndlessAnswerIsNotKept) {
  ReadOptions options;
  options.trouble = "flood";
  options.limits.seconds = 60.0;
  ExpectError(Decoded({PngOf(TwoColors(16))}, options).at(0), ErrorCode::kSyntax, "far too much");
}

TEST(DecodePictures, AMissingReaderIsNamed) {
  ReadOptions options;
  options.reader = "/nowhere/hazumi-reader";
  const auto images = Decoded({PngOf(TwoColors(16)), PngOf(TwoColors(16))}, options);
  ASSERT_EQ(images.size(), 2u);
  for (const Result<Image>& image : images)
    ExpectError(image, ErrorCode::kFailed, "/nowhere/hazumi-reader is missing");
}

TEST(DecodePictures, TogetherTheyHaveNoMorePixelsThanAllowed) {
  const std::vector<Bytes> files = {PngOf(TwoColors(16)), PngOf(TwoColors(16)),
                                    PngOf(TwoColors(4))};
  const std::vector<std::span<const std::uint8_t>> spans(files.begin(), files.end());
  std::string answers;
  const std::string request = RequestToBytes(spans, 300);  // 256 + 16 fit
  ASSERT_TRUE(DecodeHere(request, [&](const std::string& answer) {
    answers += answer;
    return true;
  }));
  const std::vector<Result<Image>> images = AnswersFromBytes(answers, 3, 300);
  ASSERT_EQ(images.size(), 3u);
  EXPECT_TRUE(images[0].ok());
  ExpectError(images[1], ErrorCode::kSyntax, "is left out: only 44 pixels are left");
  EXPECT_TRUE(images[2].ok());
}

TEST(DecodePictures, NoneIsNoProcess) {
  ReadOptions options;
  options.reader = "/nowhere/hazumi-reader";
  EXPECT_TRUE(Decoded({}, options).empty());
}

}  // namespace
}  // namespace hazumi
