// A file that was cut or whose bytes were changed: an error with a place, or a sound character.

#include <gtest/gtest.h>

#include "tests/support/random.h"
#include "tests/unit/exchange/bvh_sample.h"

namespace hazumi::test {
namespace {

// Whether something is said: an error or a warning.
bool ReadsSoundly(const std::string& text) {
  const Result<Character> read = ReadBvh(text, "damaged.bvh");
  if (read.ok()) {
    ExpectSound(read.value());
    return !read.value().warnings.empty();
  }
  EXPECT_EQ(read.error().file, "damaged.bvh");
  EXPECT_TRUE(read.error().place.starts_with("line ")) << read.error().ToString();
  EXPECT_FALSE(read.error().message.empty());
  return true;
}

TEST(DamagedBvh, CutAtAnyByteIsSaid) {
  const std::string text = SmallBvh();
  for (size_t size = 0; size <= text.size(); ++size) {
    const bool is_said = ReadsSoundly(text.substr(0, size));
    // Of the last number a part is a number too.
    if (size < text.size() - 2) {
      EXPECT_TRUE(is_said) << "cut after " << size << " bytes";
    }
  }
}

TEST(DamagedBvh, AnyByteChangedGivesAnErrorOrASoundCharacter) {
  Random random(7);
  const std::string text = SmallBvh();
  const std::string likely = "0123456789+-.eE{} \t\r\n,nainfROTJN#\xff";
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    std::string damaged = text;
    for (int changes = random.Integer(1, 4); changes > 0; --changes) {
      const auto at = static_cast<size_t>(random.Integer(0, static_cast<int>(text.size()) - 1));
      const int last = static_cast<int>(likely.size()) - 1;
      damaged[at] = random.Chance(0.5) ? likely[static_cast<size_t>(random.Integer(0, last))]
                                       : static_cast<char>(random.Integer(0, 255));
    }
    ReadsSoundly(damaged);
    if (::testing::Test::HasFailure()) ADD_FAILURE() << "change " << i << ":\n" << damaged;
  }
}

TEST(DamagedBvh, PiecesLeftOutOrDoubledGiveAnErrorOrASoundCharacter) {
  Random random(8);
  const std::string text = SmallBvh();
  const int size = static_cast<int>(text.size());
  for (int i = 0; i < 10000 && !::testing::Test::HasFailure(); ++i) {
    const auto at = static_cast<size_t>(random.Integer(0, size - 1));
    const auto length = static_cast<size_t>(random.Integer(1, 60));
    std::string damaged = text;
    if (random.Chance(0.5)) {
      damaged.erase(at, length);
    } else {
      damaged.insert(static_cast<size_t>(random.Integer(0, size)), text.substr(at, length));
    }
    ReadsSoundly(damaged);
    if (::testing::Test::HasFailure()) ADD_FAILURE() << "change " << i << ":\n" << damaged;
  }
}

}  // namespace
}  // namespace hazumi::test
