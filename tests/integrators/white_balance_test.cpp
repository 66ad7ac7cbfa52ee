// A film that is balanced for a white: what it shows, and what is said of its error.
#include <gtest/gtest.h>

#include "integrators/trial.h"
#include "renderer/film/variance.h"
#include "renderer/math/cie.h"
#include "renderer/math/white_balance.h"
#include "tests/integrators/synthetic_tile.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// A card under a sky of a colour.
SceneDescription card(const Vec3d& reflectance, const Vec3d& light) {
  SceneDescription scene = empty_scene();
  add_light(scene, description::ConstantEnvironment{light, false});
  add_mesh(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}),
           add_material(scene, diffuse(reflectance)));
  set_camera(scene, {0, 1, 0.01}, {0, 0, 0}, 40);
  return scene;
}

RenderSettings balanced(double kelvins, int samples = 4) {
  RenderSettings settings = settings_of(4, samples);
  settings.options.white_balance_kelvins = kelvins;
  return settings;
}

TEST(Unit_WhiteBalancedFilm, AGreyCardIsNeutralUnderItsLight) {
  for (const double kelvins : {2700.0, 5000.0, 9000.0}) {
    const Chromaticity white = daylight(kelvins);
    const Vec3d light = colour_of_chromaticity(white.x, white.y);
    const SceneDescription scene = card(Vec3d(0.18), light);
    const Film plain = rendered(scene, settings_of(4, 4)).film;
    const Film film = rendered(scene, balanced(kelvins)).film;
    EXPECT_GT(std::abs(plain.mean(0).x - plain.mean(0).z), 0.02);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.mean(0)[c], 0.18, 1e-4) << kelvins << " " << c;
  }
}

// What coloured surfaces make of the light is balanced, not the light: no scale of the lights does
// the same.
TEST(Unit_WhiteBalancedFilm, ColouredSurfacesAreBalancedAsTheyAreSeen) {
  const Vec3d reflectance(0.6, 0.3, 0.1), light(1.5, 1, 0.4);
  const Film film = rendered(card(reflectance, light), balanced(3200)).film;
  const Vec3d expected = white_balance(3200) * (reflectance * light);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.mean(0)[c], expected[c], 1e-5);
  const Vec3d scaled = reflectance * (white_balance(3200) * light);
  EXPECT_GT(std::abs(expected.z - scaled.z), 0.005);
}

// Samples are multiplied one by one, so the picture's variance is what is stated.
TEST(Unit_WhiteBalancedFilm, SumsAndVariancesAreOfTheBalancedSamples) {
  const SceneDescription scene = small_room();
  const Film plain = rendered(scene, settings_of(8, 16)).film;
  RenderSettings settings = settings_of(8, 16);
  settings.options.white_balance_kelvins = 4200;
  const Film film = rendered(scene, settings).film;
  const Mat3d matrix = white_balance(4200);
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    ASSERT_EQ(film.samples(i), plain.samples(i));
    for (std::uint32_t r = 0; r < film.replicates(); ++r) {
      const Vec3d expected = matrix * plain.replicate_sum(i, r);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(film.replicate_sum(i, r)[c], expected[c], 1e-9 * (1 + std::abs(expected[c])));
    }
    // By the replicates' means, multiplied.
    Vec3d variance(0.0);
    const double n = film.replicates();
    for (std::uint32_t r = 0; r < film.replicates(); ++r) {
      const Vec3d off = matrix * (plain.replicate_sum(i, r) /
                                      static_cast<double>(film.samples_by_replicate(i).of(r)) -
                                  plain.mean(i));
      variance += off * off / (n * (n - 1));
    }
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(variance_of_mean(film, i)[c], variance[c], 1e-9 * (1 + variance[c]));
  }
}

// The pilot's samples are part of the picture.
TEST(Unit_WhiteBalancedFilm, PilotsAreBalancedToo) {
  const Vec3d light(1, 0.5, 0.25);
  RenderSettings settings = balanced(3000, 64);
  settings.options.adaptive = true;
  const Film film = rendered(card(Vec3d(0.5), light), settings).film;
  const Vec3d expected = white_balance(3000) * light * 0.5;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.mean(0)[c], expected[c], 1e-5);
}

// What trials choose by is what the picture shows.
TEST(Unit_WhiteBalancedFilm, BlocksOfTrialsAreBalancedToo) {
  const TileFunction grey = [](const TilePass& pass, Film& film) {
    return synthetic_tile(pass, film, [](std::uint64_t, int, int) { return 0.5; });
  };
  const Vec3d mean = run_block({}, {1, 0, 0}, balanced(3200).options, grey);
  const Vec3d expected = white_balance(3200) * Vec3d(0.5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], expected[c], 1e-6);
}

}  // namespace
}  // namespace candela
