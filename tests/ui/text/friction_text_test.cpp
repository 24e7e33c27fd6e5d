#include <gtest/gtest.h>

#include "ui/panels/text/quantity_text.h"

namespace hazumi::ui {
namespace {

// 0.9^30 = 0.0424; 0.9^(30 * 0.2193) = 0.5.
TEST(FrictionInWords, TellsHalfTimeAndShareAfterASecond) {
  EXPECT_EQ(FrictionInWords(0.9), "Speed halves in 0.22 s; after 1 s 4.2 % is left.");
  EXPECT_EQ(FrictionInWords(1.0), "No friction: all speed stays.");
  EXPECT_EQ(FrictionInWords(0.0), "Frozen: no speed is left.");
}

}  // namespace
}  // namespace hazumi::ui
