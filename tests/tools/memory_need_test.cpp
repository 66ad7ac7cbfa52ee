// What a picture needs of the memory.
#include "tools/candela/memory_need.h"

#include <gtest/gtest.h>

namespace candela::cli {
namespace {

constexpr double side = 65536;
constexpr double little = 1e6;

RenderOptions small_crop_of_a_giant() {
  RenderOptions options;
  options.width = options.height = static_cast<int>(side);
  options.crop = PixelRect{0, 0, 4, 4};
  return options;
}

TEST(Unit_MemoryNeed, IsThatOfTheCrop) {
  constexpr double colours = 4 * 4 * 3 * sizeof(float);
  EXPECT_GE(needed_memory(small_crop_of_a_giant()), colours);
  EXPECT_LT(needed_memory(small_crop_of_a_giant()), little);
}

TEST(Unit_MemoryNeed, IsMissingWhereThereIsNone) {
  RenderOptions options = small_crop_of_a_giant();
  EXPECT_FALSE(missing_memory(options));
  options.crop.reset();
  EXPECT_NE(missing_memory(options).value_or("").find("--crop renders a part"), std::string::npos);
}

}  // namespace
}  // namespace candela::cli
