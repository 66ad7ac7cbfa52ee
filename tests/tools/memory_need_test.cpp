// What a picture needs of the memory.
#include "tools/candela/memory_need.h"

#include <gtest/gtest.h>

#include "tests/scenes/description.h"

namespace candela::cli {
namespace {

constexpr double side = 65536;
constexpr double whole = 5 * side * side;  // of a byte a pixel and a number
constexpr double little = 1e6;

RenderOptions small_crop_of_a_giant() {
  RenderOptions options;
  options.width = options.height = static_cast<int>(side);
  options.crop = PixelRect{0, 0, 4, 4};
  options.lamp_rays = 8;
  return options;
}

// Of the whole picture it is known for each pixel what may be seen there, whatever the crop.
TEST(Unit_MemoryNeed, HasWhatIsKnownOfAllPixels) {
  const description::SceneDescription room = test::small_room();
  const RenderOptions options = small_crop_of_a_giant();
  EXPECT_GE(needed_memory(options, room), whole);
  EXPECT_LT(needed_memory(options, room), whole + little);
  EXPECT_LT(needed_memory(options, {}), little);
}

TEST(Unit_MemoryNeed, HasItOnlyWhereItIsLookedFor) {
  description::SceneDescription scene = test::small_room();
  RenderOptions options = small_crop_of_a_giant();
  options.filter = FilterKind::Mitchell;
  EXPECT_LT(needed_memory(options, scene), little);
  options = small_crop_of_a_giant();
  options.integrator = IntegratorKind::Report;
  EXPECT_LT(needed_memory(options, scene), little);
  options = small_crop_of_a_giant();
  options.lamp_rays = 0;
  EXPECT_GE(needed_memory(options, scene), whole) << "the background is black";
  test::add_light(scene, description::LatLongEnvironment{});
  EXPECT_LT(needed_memory(options, scene), little);
  options.lamp_rays = 8;
  EXPECT_GE(needed_memory(options, scene), whole) << "there is a lamp";
  scene.cameras[0].lens_radius = 0.1;
  EXPECT_LT(needed_memory(options, scene), little);
}

TEST(Unit_MemoryNeed, IsMissingWhereThereIsNone) {
  RenderOptions options = small_crop_of_a_giant();
  EXPECT_FALSE(missing_memory(options, {}));
  options.crop.reset();
  EXPECT_NE(missing_memory(options, {}).value_or("").find("--crop renders a part"),
            std::string::npos);
}

}  // namespace
}  // namespace candela::cli
