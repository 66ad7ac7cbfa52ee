// What dense media scatter does not depend on how dense they are: light pays on its way out for no
// more than where it may collide on its way in.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene_io/pbrt/read_pbrt.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;

// A cube of edge 2, lit and seen straight on.
std::string lit_cube(double density) {
  return fmt::format(R"(LookAt 0 0 -5  0 0 0  0 1 0
    Camera "orthographic" "float screenwindow" [ -.5 .5 -.5 .5 ]
    Integrator "volpath" "integer maxdepth" 1
    WorldBegin
    LightSource "distant" "rgb L" [ 1 1 1 ] "point3 from" [ 0 0 -1 ] "point3 to" [ 0 0 0 ]
    MakeNamedMedium "m" "string type" "homogeneous" "float scale" {}
      "rgb sigma_a" [ .05 .05 .05 ] "rgb sigma_s" [ .95 .95 .95 ]
    Material "interface" MediumInterface "m" ""
    Shape "trianglemesh" "integer indices"
      [ 0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 2 3 7 2 7 6 1 2 6 1 6 5 0 4 7 0 7 3 ]
      "point3 P" [ -1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1  -1 -1 1  1 -1 1  1 1 1  -1 1 1 ])",
                     density);
}

// A half space of albedo a scatters a / (4 pi) / (1 + 1) of the irradiance once, straight back.
TEST(Statistical_DenseMedia, ScatterAsMuchAsThinOnes) {
  const double expected = 0.95 / (8 * 3.14159265358979);
  for (const double density : {1e2, 1e4, 1e5}) {
    const auto scene = pbrt::parse_pbrt("scene.pbrt", lit_cube(density));
    ASSERT_TRUE(scene);
    statistics::Moments means;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
      RenderSettings settings = settings_of(8, 64, seed);
      settings.options.max_depth = 1;
      means.add(mean_of(rendered(*scene, settings).film.to_image(false)));
    }
    const double z = (means.mean() - expected) / means.standard_error();
    EXPECT_LT(std::abs(z), 4) << density << ": " << means.mean() << " of " << expected;
  }
}

// And with many collisions, after which paths leave the medium: under a white sky.
TEST(Statistical_DenseMedia, LetAsMuchLightOutAsThinOnes) {
  const auto mean_of_density = [](double density) {
    std::string text = lit_cube(density);
    const std::string lamp = "LightSource \"distant\"";
    text.replace(text.find(lamp), text.find("MakeNamedMedium") - text.find(lamp),
                 "LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]\n");
    const auto scene = pbrt::parse_pbrt("scene.pbrt", text);
    EXPECT_TRUE(scene);
    statistics::Moments means;
    for (std::uint64_t seed = 0; scene && seed < 16; ++seed) {
      RenderSettings settings = settings_of(8, 32, seed);
      settings.options.max_depth = 20;
      means.add(mean_of(rendered(*scene, settings).film.to_image(false)));
    }
    return means;
  };
  const statistics::Moments thin = mean_of_density(1e2);
  for (const double density : {1e4, 1e6}) {
    const statistics::Moments dense = mean_of_density(density);
    const double z = (dense.mean() - thin.mean()) /
                     std::sqrt(dense.variance_of_mean() + thin.variance_of_mean());
    EXPECT_LT(std::abs(z), 4) << density << ": " << dense.mean() << " of " << thin.mean();
  }
}

}  // namespace
}  // namespace candela
