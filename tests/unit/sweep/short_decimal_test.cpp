#include <gtest/gtest.h>

#include "engine/sweep/table_text.h"

namespace hazumi::test {
namespace {

using Texts = std::vector<std::string>;

TEST(ShortDecimal, KeepsThreeDigitsAndAllBeforeThePoint) {
  EXPECT_EQ(ShortDecimal("0.555555555556"), "0.556");
  EXPECT_EQ(ShortDecimal("12345.678"), "12346");
  EXPECT_EQ(ShortDecimal("-0.1"), "-0.1");
  EXPECT_EQ(ShortDecimal("0.555555555556", 5), "0.55556");
  EXPECT_EQ(ShortDecimal("quintic"), "quintic");
  EXPECT_EQ(ShortDecimal(""), "");
}

TEST(ShortDecimal, TellsNeighboursApart) {
  EXPECT_EQ(ShortDecimals({"0.5", "0.555555555556", "0.611111111111"}),
            (Texts{"0.5", "0.556", "0.611"}));
  EXPECT_EQ(ShortDecimals({"9.8066", "9.8068", "9.8068"}), (Texts{"9.8066", "9.8068", "9.8068"}));
  EXPECT_EQ(ShortDecimals({"true", "false"}), (Texts{"true", "false"}));
  EXPECT_EQ(ShortDecimals({}), Texts());
}

}  // namespace
}  // namespace hazumi::test
