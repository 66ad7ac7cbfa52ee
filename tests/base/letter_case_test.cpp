#include "renderer/base/letter_case.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Unit_LetterCase, IsAsciisAlone) {
  EXPECT_EQ(to_lower("AZ az @[`{ 09 \xC3\x89"), "az az @[`{ 09 \xC3\x89");
}

TEST(Unit_LetterCase, EqualTextsAreOfOneLength) {
  EXPECT_TRUE(equal_ignoring_case("Kd", "kD"));
  EXPECT_TRUE(equal_ignoring_case("", ""));
  EXPECT_FALSE(equal_ignoring_case("Kd", "Ks"));
  EXPECT_FALSE(equal_ignoring_case("Kd", "K"));
  EXPECT_FALSE(equal_ignoring_case("K", "Kd"));
}

TEST(Unit_LetterCase, EndingsAreNoLongerThanTheText) {
  EXPECT_TRUE(ends_ignoring_case("folder/a.PNG", ".png"));
  EXPECT_TRUE(ends_ignoring_case(".png", ".Png"));
  EXPECT_FALSE(ends_ignoring_case("png", ".png"));
  EXPECT_FALSE(ends_ignoring_case("a.png.gz", ".png"));
}

}  // namespace
}  // namespace candela
