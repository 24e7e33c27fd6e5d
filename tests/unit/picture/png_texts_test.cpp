#include "engine/picture/png_texts.h"

#include <gtest/gtest.h>

#include "render/image/png.h"
#include "tests/unit/picture/picture_sample.h"

namespace hazumi {
namespace {

using test::Bytes;
using Texts = std::map<std::string, std::string>;

const Texts kTexts = {
    {"Frame", "12"}, {"Options", R"(["--size","64x48"])"}, {"Project", "弾み"}, {"Software", ""}};

Bytes Written() {
  std::vector<render::PngText> texts;
  for (const auto& [key, value] : kTexts) texts.push_back({key, value});
  return render::EncodePng(test::TwoColors(8), texts).value();
}

// Whatever is there of `texts` is as it was written.
void ExpectSomeOf(const Texts& texts, const char* what, size_t at) {
  for (const auto& [key, value] : texts) {
    const auto found = kTexts.find(key);
    ASSERT_TRUE(found != kTexts.end()) << what << " " << at << ": " << key;
    EXPECT_EQ(value, found->second) << what << " " << at;
  }
}

TEST(PngTexts, AreThoseThatWereWritten) {
  EXPECT_EQ(PngTexts(Written()), kTexts);
  EXPECT_EQ(PngTexts(test::PngOf(test::TwoColors(8))), Texts());
}

TEST(PngTexts, OfACutFileAreThoseBeforeTheCut) {
  const Bytes whole = Written();
  size_t before = 0;
  for (size_t size = 0; size <= whole.size(); ++size) {
    const Texts texts = PngTexts(std::span(whole).first(size));
    ExpectSomeOf(texts, "cut at", size);
    EXPECT_GE(texts.size(), before) << size;
    before = texts.size();
  }
  EXPECT_EQ(before, kTexts.size());
}

TEST(PngTexts, OfADamagedFileAreNoOthers) {
  const Bytes whole = Written();
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const int bits : {0x01, 0x20, 0x80, 0xff}) {
      Bytes damaged = whole;
      damaged[at] ^= static_cast<std::uint8_t>(bits);
      ExpectSomeOf(PngTexts(damaged), "damaged at", at);
    }
  }
}

TEST(PngTexts, OfWhatIsNoPngAreNone) {
  EXPECT_EQ(PngTexts({}), Texts());
  EXPECT_EQ(PngTexts(test::JpegOf(test::TwoColors(8))), Texts());
  Bytes no_signature = Written();
  no_signature.erase(no_signature.begin());
  EXPECT_EQ(PngTexts(no_signature), Texts());
}

}  // namespace
}  // namespace hazumi
