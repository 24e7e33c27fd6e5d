#include "engine/picture/picture_bytes.h"

#include <gtest/gtest.h>

#include "engine/picture/image.h"
#include "tests/unit/picture/picture_sample.h"

namespace hazumi {
namespace {

using test::Bytes, test::TwoColors;

std::string Answers() {
  return AnswerToBytes(TwoColors(4)) +
         AnswerToBytes(Error{ErrorCode::kSyntax, "", "", "is broken"}) +
         AnswerToBytes(TwoColors(2));
}

// An answer that claims this size and brings so many bytes.
std::string Claiming(int width, int height, size_t num_bytes) {
  Image image;
  image.width = width, image.height = height;
  image.rgba.resize(num_bytes);
  return AnswerToBytes(image);
}

TEST(PictureBytes, ARequestComesBackAsItWas) {
  const Bytes first = {1, 2, 3}, second = {};
  const std::vector<std::span<const std::uint8_t>> files = {first, second};
  const std::string bytes = RequestToBytes(files, 77);
  const Result<PictureRequest> back = RequestFromBytes(bytes);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back.value().pixels_left, 77);
  ASSERT_EQ(back.value().files.size(), 2u);
  EXPECT_EQ(Bytes(back.value().files[0].begin(), back.value().files[0].end()), first);
  EXPECT_TRUE(back.value().files[1].empty());
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(RequestFromBytes(std::string_view(bytes).substr(0, size)).ok()) << size;
}

TEST(PictureBytes, AnswersComeBackAsTheyWere) {
  const std::vector<Result<Image>> back = AnswersFromBytes(Answers(), 3, kMostPixelsTogether);
  ASSERT_EQ(back.size(), 3u);
  ASSERT_TRUE(back[0].ok());
  EXPECT_EQ(back[0].value().rgba, TwoColors(4).rgba);
  ASSERT_FALSE(back[1].ok());
  EXPECT_EQ(back[1].error().message, "is broken");
  EXPECT_EQ(back[2].value().width, 2);
}

TEST(PictureBytes, OfWhatIsCutShortTheWholeAnswersAreTaken) {
  const std::string bytes = Answers();
  size_t before = 0;
  for (size_t size = 0; size <= bytes.size(); ++size) {
    const size_t num = AnswersFromBytes(std::string_view(bytes).substr(0, size), 9, 1000).size();
    EXPECT_GE(num, before);
    EXPECT_LE(num, before + 1);
    before = num;
  }
  EXPECT_EQ(before, 3u);
}

TEST(PictureBytes, NoMoreIsTakenThanWasAskedFor) {
  EXPECT_EQ(AnswersFromBytes(Answers(), 2, 1000).size(), 2u);
  EXPECT_EQ(AnswersFromBytes(Answers(), 3, 16).size(), 2u) << "16 and 4 pixels";
  EXPECT_EQ(AnswersFromBytes(Answers(), 3, 20).size(), 3u);
}

TEST(PictureBytes, SizesThatTheBytesBelieAreRefused) {
  for (const auto& [width, height, bytes] : {std::tuple{2, 2, 15},
                                             {2, 2, 17},
                                             {0, 0, 0},
                                             {-1, -1, 4},
                                             {-2, -2, 16},
                                             {16385, 1, 65540},
                                             {1 << 30, 4, 0},
                                             {65536, 65536, 0}}) {
    const std::string answer = Claiming(width, height, static_cast<size_t>(bytes));
    EXPECT_TRUE(AnswersFromBytes(answer, 1, kMostPixelsTogether).empty()) << width;
  }
  EXPECT_EQ(AnswersFromBytes(Claiming(2, 2, 16), 1, kMostPixelsTogether).size(), 1u);
}

TEST(PictureBytes, AnyChangedByteIsSurvived) {
  const std::string bytes = Answers();
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x55);
    for (const Result<Image>& answer : AnswersFromBytes(changed, 3, 1000)) {
      if (!answer.ok()) continue;
      EXPECT_EQ(answer.value().rgba.size(),
                size_t{4} * answer.value().width * answer.value().height);
    }
  }
}

}  // namespace
}  // namespace hazumi
