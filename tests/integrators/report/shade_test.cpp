// The report's integrator against closed forms, and its place among the others.
#include <gtest/gtest.h>

#include "integrators/report/emitter_table.h"
#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/form_factor.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

RenderSettings report_settings(int size, int samples_per_pixel, std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples_per_pixel, seed);
  settings.options.integrator = IntegratorKind::Report;
  return settings;
}

// REPORT 3.12: calls of shade() are geometric with the mean 1 / (1 - P) where no ray gets lost, and
// its continued bounces have the mean P / (1 - P).
TEST(Statistical_ReportShade, CallsInAClosedWhiteBoxAreGeometric) {
  SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 1, 0);
  for (const auto& [p_rr, calls] : {std::pair(0.8f, 5.0), std::pair(0.5f, 2.0)}) {
    RenderSettings settings = report_settings(16, 256);
    settings.options.report_p_rr = p_rr;
    const RayCounts rays = rendered(scene, settings).statistics.rays;
    const double paths = static_cast<double>(rays.camera);
    const double bounces = static_cast<double>(rays.indirect) / paths;
    const double error = std::sqrt(p_rr / paths) / (1 - p_rr);
    EXPECT_GT(statistics::normal_two_sided((1 + bounces - calls) / error), 0.01)
        << 1 + bounces << " calls";
    EXPECT_EQ(rays.shadow, 0u);  // there is no lamp
  }
}

SceneDescription lamp_over_a_plane(int copies) {
  SceneDescription scene;
  const auto floor = add_material(scene, diffuse(Vec3d(0.5)));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(10.0));
  add_mesh(scene, quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}), floor);
  // The same rectangle as one lamp or as unequal strips of it, which are picked by area.
  double x = 0;
  for (int i = 0; i < copies; ++i) {
    const double width = copies == 1 ? 1.5 : i == 0 ? 0.25 : 1.25;
    add_mesh(scene, quad({x, 2, 0}, {width, 0, 0}, {0, 0, 1}), lamp);
    x += width;
  }
  set_camera(scene, {-0.5, 1, -0.5}, {0, 0, 0}, 0.01);
  return scene;
}

// Le f cos cos' / d^2 / pdf, averaged, whatever P_RR is: the floor sees nothing but the lamp.
TEST(Statistical_ReportShade, DirectLightHasItsClosedForm) {
  const double expected = 0.5 * 10 * corner_form_factor(1.5, 1, 2);
  for (const int copies : {1, 2})
    for (const float p_rr : {0.2f, 1.0f}) {
      statistics::Moments means;
      for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        RenderSettings settings = report_settings(4, 64, seed);
        settings.options.report_p_rr = p_rr;
        means.add(mean_of(rendered(lamp_over_a_plane(copies), settings).film.to_image(false)));
      }
      EXPECT_GT(means.p_value(expected), 0.01) << means.mean() << " against " << expected;
      EXPECT_LT(means.standard_error(), 0.003 * expected);
    }
}

TEST(Unit_ReportShade, LampsAreSampledUniformlyByArea) {
  const SceneDescription description = lamp_over_a_plane(2);
  const Scene scene = compiled(description, report_settings(4, 1).options);
  const EmitterTable emitters(scene);
  double area = 0;
  for (const Light& light : scene.lights) area += light.area;
  ASSERT_EQ(scene.lights.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_NEAR(emitters.pdf_area(scene, i) * area, 1, 1e-6);
}

// REPORT 3.0 and 3.4: the camera sees the lamp itself; no other ray brings what lamps send.
TEST(Unit_ReportShade, OnlyTheCameraSeesLamps) {
  SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.5, 3);
  const RenderResult result = rendered(scene, report_settings(4, 4));
  EXPECT_EQ(mean_of(result.film.to_image(false)), 3);
  EXPECT_EQ(result.statistics.rays.indirect, 0u);
  EXPECT_EQ(result.statistics.rays.shadow, 0u);
  EXPECT_EQ(result.statistics.kernel, "report");
}

// A pilot, which it has none of, would deal its samples to other sequences.
TEST(Unit_ReportShade, DoesNotAdapt) {
  RenderSettings settings = report_settings(16, 64);
  settings.options.replicates = 1;
  const Scene scene = compiled(small_room(), settings.options);
  const Image plain = picture(scene, settings);
  settings.options.adaptive = true;
  EXPECT_EQ(picture(scene, settings).values, plain.values);
}

TEST(Agreement_ReportSameBits, OverThreadsTilesAndCrops) {
  RenderSettings settings = report_settings(40, 12);
  settings.options.aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Normal) | aov_bit(Aov::Depth);
  const Scene scene = compiled(small_room(), settings.options);
  const Image whole = picture(scene, settings);
  EXPECT_GT(mean_of(whole), 0.01);
  expect_same_bits_however_rendered(scene, settings, whole, {13, 5, 31, 40});
}

}  // namespace
}  // namespace candela
