// Dielectrics whose index is below that of what is around them, such as bubbles.
#include <gtest/gtest.h>

#include "tests/scene_io/pbrt/pbrt_text.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;

// A mesh in a coloured room of two lamps' light, or in a white sky.
description::SceneDescription ball(const std::string& light, const std::string& material) {
  return pbrt_scene(
      "LookAt 0 1 -4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n" + light +
      "\n" + material + "\nShape \"sphere\" \"float zmin\" -.999\n");  // a mesh
}
const std::string white = "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]";
const std::string lamp =
    "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 9 5 2 ] Translate 1 0 3 "
    "Shape \"sphere\" AttributeEnd";

statistics::Moments means(const description::SceneDescription& description, std::uint64_t first) {
  const Scene scene = compiled(description, settings_of(16, 16).options);
  statistics::Moments result;
  for (std::uint64_t seed = first; seed < first + 24; ++seed)
    result.add(mean_of(picture(scene, settings_of(16, 16, seed))));
  return result;
}

TEST(Statistical_LighterInside, IsTheDenserMaterialTurnedInsideOut) {
  for (const char* rough : {"", "\"float roughness\" .3 "}) {
    const std::string glass = std::string("Material \"dielectric\" ") + rough;
    const statistics::Moments lighter = means(ball(lamp, glass + "\"float eta\" .8"), 1);
    const statistics::Moments denser =
        means(ball(lamp, glass + "\"float eta\" 1.25\nReverseOrientation"), 101);
    EXPECT_GT(statistics::welch_p_value(lighter, denser), 1e-4)
        << lighter.mean() << " " << denser.mean();
    EXPECT_LT(lighter.standard_error(), 0.02 * lighter.mean());
    const statistics::Moments other = means(ball(lamp, glass + "\"float eta\" 1.25"), 201);
    EXPECT_LT(statistics::welch_p_value(lighter, other), 1e-4);
  }
}

TEST(Statistical_LighterInside, KeepsTheLight) {
  const statistics::Moments seen =
      means(ball(white, "Material \"dielectric\" \"float eta\" .7"), 1);
  EXPECT_NEAR(seen.mean(), 1, 1e-3 + 4 * seen.standard_error());
}

}  // namespace
}  // namespace candela
