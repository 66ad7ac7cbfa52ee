// Heights of pbrt's scenes are lengths in the world, however texture coordinates lie on a surface
// and however it is placed: a lamp along the view shows the cosine of the slope.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene_io/pbrt/read_pbrt.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

// Heights rise by `rise` along u; `unit`: of the scene.
std::string lit_surface(double rise, const std::string& shapes, double unit = 1) {
  return fmt::format(R"(LookAt 0 0 {2}  0 0 0  0 1 0
    Camera "orthographic" "float screenwindow" [ -{3} {3} -{3} {3} ]
    WorldBegin
    LightSource "distant" "rgb L" [ {0} {0} {0} ] "point3 from" [ 0 0 5 ] "point3 to" [ 0 0 0 ]
    Texture "ramp" "float" "bilerp" "float v00" 0 "float v01" 0 "float v10" {1} "float v11" {1}
    Material "diffuse" "rgb reflectance" [ 1 1 1 ] "texture displacement" "ramp"
    )",
                     3.14159265358979, rise, 5 * unit, unit / 10) +
         shapes;
}

double brightness_of(const std::string& text) {
  const auto scene = pbrt::parse_pbrt("scene.pbrt", text);
  EXPECT_TRUE(scene) << text;
  if (!scene) return 0;
  RenderSettings settings = settings_of(4, 4);
  settings.options.max_depth = 1;
  return mean_of(rendered(*scene, settings).film.to_image(false));
}

double cosine_of_slope(double slope) {
  return 1 / std::sqrt(1 + slope * slope);
}

constexpr const char* square =
    "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0  1 -1 0  -1 1 0  1 1 0 ]\n";

TEST(Agreement_HeightsInTheWorld, AreOfTheUnitOfTheFile) {
  for (const double unit : {1.0, 1000.0, 1e-3}) {
    const std::string scaled =
        lit_surface(2 * 0.5 * unit, fmt::format("Scale {0} {0} {0}\n", unit) + square, unit);
    EXPECT_NEAR(brightness_of(scaled), cosine_of_slope(0.5), 1e-5) << unit;
  }
}

// The square in sight is a hundredth of the mesh, and has as many coordinates as the rest.
TEST(Agreement_HeightsInTheWorld, DoNotAskHowTheCoordinatesOfAMeshLie) {
  const std::string two_squares = R"(Shape "trianglemesh"
    "point3 P" [ -1 -1 0  1 -1 0  1 1 0  -1 1 0   5 -10 0  25 -10 0  25 10 0  5 10 0 ]
    "point2 uv" [ 0 0  1 0  1 1  0 1   0 0  1 0  1 1  0 1 ]
    "integer indices" [ 0 1 2  0 2 3  4 5 6  4 6 7 ])";
  EXPECT_NEAR(brightness_of(lit_surface(2 * 0.5, two_squares)), cosine_of_slope(0.5), 1e-5);
}

TEST(Agreement_HeightsInTheWorld, StayWhereInstancesAreScaled) {
  for (const double scale : {2.0, 0.5}) {
    const std::string placed = std::string("ObjectBegin \"thing\"\n") + square +
                               fmt::format("ObjectEnd\nScale {0} {0} 1\n", scale) +
                               "ObjectInstance \"thing\"\nTranslate 9 0 0 ObjectInstance \"thing\"";
    EXPECT_NEAR(brightness_of(lit_surface(2 * 0.25, placed)), cosine_of_slope(0.25 / scale), 1e-5)
        << scale;
  }
}

}  // namespace
}  // namespace candela
