#include "render/image/halve.h"

#include <gtest/gtest.h>

namespace hazumi::render {
namespace {

TEST(Halved, IsTheMeanOfFourPixelsAndKeepsOne) {
  Image image(3, 1);  // the third column of an odd width is dropped
  image.rgba = {0, 100, 0, 255, 50, 200, 0, 255, 9, 9, 9, 9};
  const Image half = Halved(image);
  ASSERT_EQ(half.width, 1);
  ASSERT_EQ(half.height, 1);
  EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{25, 150, 0, 255}));
  EXPECT_EQ(Halved(half).rgba, half.rgba);
}

}  // namespace
}  // namespace hazumi::render
