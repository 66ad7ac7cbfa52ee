// Pictures where surfaces graze, coincide, touch or nearly touch: no acne, no leaks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/statistics/moments.h"
#include "tests/stress/disturb.h"
#include "tests/stress/row.h"
#include "tests/stress/undisturbed.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

constexpr double reflectance = 0.5;

// Auto: few faces without a tree, and Embree where they are many.
constexpr AcceleratorKind all_accelerators[] = {AcceleratorKind::Auto, AcceleratorKind::Embree,
                                                AcceleratorKind::Bvh};

const char* name_of(AcceleratorKind accelerator) {
  if (accelerator == AcceleratorKind::Auto) return "auto";
  return accelerator == AcceleratorKind::Bvh ? "own BVH" : "Embree";
}

// No number of the scene is one that floats carry.
SceneDescription turned(const SceneDescription& scene) {
  return rotated(scene, 0.7, {1, 2, 3});
}

RenderSettings sharp(int size, int samples_per_pixel, AcceleratorKind accelerator) {
  RenderSettings settings = settings_of(size, samples_per_pixel);
  settings.options.filter = FilterKind::Box;
  settings.accelerator = accelerator;
  return settings;
}

// Of the pixels that are wholly covered: how many are black, and how far the others are from what
// they should be, relative to it.
struct Evenness {
  int covered = 0;
  int black = 0;
  double worst = 0;
};

Evenness evenness_of(const Image& image, double expected) {
  Evenness result;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* const pixel = image.pixel(x, y);
      if (pixel[3] < 1) continue;
      ++result.covered;
      if (pixel[0] == 0)
        ++result.black;
      else
        result.worst = std::max(result.worst, std::abs(pixel[0] / expected - 1));
    }
  return result;
}

SceneDescription plane_under_a_sun(const Vec3d& to_light) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}),
           add_material(scene, diffuse(Vec3d(reflectance))));
  add_light(scene, description::DirectionalLight{normalize(to_light), Vec3d(1.0)});
  return scene;
}

// Radiance is reflectance / pi times the sine. A float normal is known to 10^-7, so at a sine of
// 10^-6 the cosine has an error of a tenth.
TEST(Stress_Grazing, ThePlaneUnderALowSunIsEven) {
  for (int k = 0; k <= 6; ++k) {
    const double sine = std::pow(10.0, -k);
    SceneDescription scene =
        plane_under_a_sun(Vec3d(0.6, 0, 0.8) * std::sqrt(1 - sine * sine) + Vec3d(0, sine, 0));
    set_camera(scene, {0, 5, 0}, {0, 0, 0}, 20, {0, 0, 1});
    for (const auto accelerator : all_accelerators) {
      const Image image = rendered(turned(scene), sharp(32, 16, accelerator)).film.to_image(true);
      const Evenness even = evenness_of(image, reflectance / pi_double * sine);
      EXPECT_EQ(even.covered, 32 * 32);
      EXPECT_EQ(even.black, 0) << sine;
      EXPECT_LT(even.worst, 1e-5 + 2e-7 / sine) << sine;
      add_row(fmt::format("sun at 10^-{}, {}", k, name_of(accelerator)),
              {{"black pixels", even.black}, {"worst relative error", even.worst}});
    }
  }
}

// The camera's height over the plane is a third of its distance from the middle times the sine.
TEST(Stress_Grazing, ThePlaneSeenFromLowIsEven) {
  for (int k = 1; k <= 6; ++k) {
    const double sine = std::pow(10.0, -k);
    SceneDescription scene = plane_under_a_sun({0, 1, 0});
    const double field_radians = 0.3 * sine;  // stays between the edges, seen at .75 and 1.5 sine
    set_camera(scene, {-3, 3 * sine, 0}, {0, 0, 0}, field_radians * 180 / pi_double);
    for (const auto accelerator : all_accelerators) {
      const Image image = rendered(turned(scene), sharp(32, 16, accelerator)).film.to_image(true);
      const Evenness even = evenness_of(image, reflectance / pi_double);
      EXPECT_EQ(even.black, 0) << sine;
      EXPECT_LT(even.worst, 1e-5) << sine;
      EXPECT_EQ(even.covered, 32 * 32) << sine;
      add_row(fmt::format("seen at 10^-{}, {}", k, name_of(accelerator)),
              {{"pixels not covered", 32 * 32 - even.covered},
               {"black pixels", even.black},
               {"worst relative error", even.worst}});
    }
  }
}

// Each pixel against the cosine of its own face's normal: a convex body has no shadow on its lit
// side, and no light on the other.
TEST(Stress_Grazing, SpheresUnderTheSunHaveNeitherAcneNorLeaks) {
  const Vec3d to_light = normalize(Vec3d(1, 0.2, 0.3));
  for (const auto accelerator : all_accelerators) {
    SceneDescription scene = empty_scene();
    add_mesh(scene, sphere({0, 0, 0}, 1, 5, false),
             add_material(scene, diffuse(Vec3d(reflectance))));
    add_light(scene, description::DirectionalLight{to_light, Vec3d(1.0)});
    set_camera(scene, {0, 0, 5}, {0, 0, 0}, 25);
    RenderSettings settings = sharp(is_heavy() ? 1024 : 256, 1, accelerator);
    settings.options.aovs = aov_bit(Aov::Normal);
    const Image image = rendered(scene, settings).film.to_image(true);
    int acne = 0;
    int leaks = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const float* const pixel = image.pixel(x, y);
        if (pixel[3] < 1) continue;
        const double cosine = dot(Vec3d(pixel[4], pixel[5], pixel[6]), to_light);
        const double expected = reflectance / pi_double * std::max(0.0, cosine);
        acne += pixel[0] < expected - 1e-6;
        leaks += pixel[0] > expected + 1e-6;
      }
    EXPECT_EQ(acne, 0);
    EXPECT_EQ(leaks, 0);
    add_row(name_of(accelerator), {{"pixels", static_cast<double>(image.pixel_count())},
                                   {"too dark", acne},
                                   {"too bright", leaks}});
  }
}

// Every wall again in the same place, cut along its other diagonal.
SceneDescription with_duplicates(SceneDescription scene) {
  const std::size_t count = scene.meshes.size();
  for (std::size_t m = 0; m < count; ++m) {
    description::Mesh mesh = scene.meshes[m];
    const description::MaterialHandle material = mesh.materials.at(0);
    if (scene.materials[material.index].emission != Vec3d(0.0)) continue;
    mesh.triangles.clear();
    for (std::uint32_t i = 0; i + 3 < mesh.positions.size(); i += 4) {
      mesh.triangles.push_back({i + 1, i + 2, i + 3});
      mesh.triangles.push_back({i + 3, i, i + 1});
    }
    add_mesh(scene, mesh, material);
  }
  return scene;
}

RenderSettings heavy_or_light(AcceleratorKind accelerator) {
  RenderSettings settings = settings_of(24, is_heavy() ? 256 : 32);
  settings.accelerator = accelerator;
  return settings;
}

TEST(Stress_Touching, CoplanarDuplicatesAreOneSurface) {
  for (const AcceleratorKind accelerator : all_accelerators) {
    const RenderSettings settings = heavy_or_light(accelerator);
    const Renders undisturbed = renders_of(fmt::format("undisturbed, {}", name_of(accelerator)),
                                           turned(small_room()), settings);
    expect_within_noise(renders_of(fmt::format("walls twice, {}", name_of(accelerator)),
                                   turned(with_duplicates(small_room())), settings),
                        undisturbed);
  }
}

// The box of the small room, its bottom at another height than the floor's.
SceneDescription with_box_at(double height) {
  SceneDescription scene = small_room();
  for (Vec3d& p : scene.meshes.back().positions)
    if (p.y == -1) p.y += height;
  return turned(scene);
}

TEST(Stress_Touching, ABoxOnTheFloorCastsNoLightBelowItself) {
  for (const AcceleratorKind accelerator : all_accelerators) {
    const auto renders_at = [&](const char* where, double height) {
      return renders_of(fmt::format("{}, {}", where, name_of(accelerator)), with_box_at(height),
                        heavy_or_light(accelerator));
    };
    const Renders sunk = renders_at("sunk into the floor", -0.25);
    expect_within_noise(renders_at("touching the floor", 0), sunk);
    expect_within_noise(renders_at("10^-6 over the floor", 2e-6), sunk);
  }
}

// Six slabs that share faces and edges but do not overlap, in a sky a million times as bright as
// what the film would show of a leak of one in a million.
SceneDescription room_of_slabs() {
  SceneDescription scene = empty_scene();
  const auto white = add_material(scene, diffuse(Vec3d(0.9)));
  const double outer = 1.1;
  add_mesh(scene, box({-outer, -outer, -outer}, {-1, outer, outer}), white);
  add_mesh(scene, box({1, -outer, -outer}, {outer, outer, outer}), white);
  add_mesh(scene, box({-1, -outer, -outer}, {1, -1, outer}), white);
  add_mesh(scene, box({-1, 1, -outer}, {1, outer, outer}), white);
  add_mesh(scene, box({-1, -1, -outer}, {1, 1, -1}), white);
  add_mesh(scene, box({-1, -1, 1}, {1, 1, outer}), white);
  add_light(scene, description::ConstantEnvironment{Vec3d(1e6), true});
  set_camera(scene, {0.1, -0.2, 0.3}, {-1, -1, -1}, 100);
  return scene;
}

TEST(Stress_Touching, RoomsOfTouchingSlabsAreDark) {
  for (const bool is_turned : {false, true})
    for (const auto accelerator : all_accelerators) {
      RenderSettings settings = sharp(64, is_heavy() ? 256 : 4, accelerator);
      const SceneDescription scene = is_turned ? turned(room_of_slabs()) : room_of_slabs();
      const RenderResult result = rendered(scene, settings);
      const Image image = result.film.to_image(false);
      const auto lit = std::count_if(image.values.begin(), image.values.end(),
                                     [](float value) { return value != 0; });
      EXPECT_EQ(lit, 0);
      add_row(fmt::format("{}, {}", is_turned ? "turned" : "along the axes", name_of(accelerator)),
              {{"rays", static_cast<double>(result.statistics.rays.indirect +
                                            result.statistics.rays.shadow)},
               {"lit values", static_cast<double>(lit)}});
    }
}

// A furnace as thin as this share of a scene that is 2 wide, away from the scene's centre: radiance
// within is emission / (1 - albedo), whatever the thickness.
SceneDescription thin_furnace(double thickness) {
  SceneDescription scene =
      furnace(inside_out(box({0.4, 0.5, 0.6}, {0.9, 0.5 + thickness, 0.9})), 0.5, 0.25);
  add_mesh(scene, box({-1, -1, -1}, {-0.9, -0.9, -0.9}), scene.meshes[0].materials[0]);
  add_mesh(scene, box({0.95, 0.95, 0.95}, {1, 1, 1}), scene.meshes[0].materials[0]);
  const Vec3d eye(0.6, 0.5 + 0.5 * thickness, 0.7);
  set_camera(scene, eye, eye + Vec3d(0.3, 0.2, 0.5), 60);
  return turned(scene);
}

void expect_light_kept(int k, AcceleratorKind accelerator) {
  RenderSettings settings = sharp(8, is_heavy() ? 1024 : 128, accelerator);
  const Scene scene = compiled(thin_furnace(2 * std::pow(10.0, -k)), settings.options);
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    settings.options.seed = seed;
    means.add(mean_of(rendered(scene, settings).film.to_image(false)));
  }
  const double error = means.mean() / 0.5 - 1;
  const double sigma = means.standard_error() / 0.5;
  EXPECT_LT(std::abs(error), 4.5 * sigma + 1e-6) << "10^-" << k;
  add_row(fmt::format("gap of 10^-{}, {}", k, name_of(accelerator)),
          {{"relative error", error}, {"its standard error", sigma}});
}

TEST(Stress_Touching, ThinFurnacesKeepTheirLight) {
  for (const AcceleratorKind accelerator : all_accelerators)
    for (int k = 1; k <= 6; ++k) expect_light_kept(k, accelerator);
}

}  // namespace
}  // namespace candela
