// Options that a picture cannot have are told, and render() refuses them.
#include "integrators/check_options.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "renderer/base/floating_point_traps.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Case {
  std::function<void(RenderOptions&)> change;
  std::string sentence;
};

const Case cases[] = {
    {[](RenderOptions& o) { o.width = 0; }, "the width is 0, expected 1 to 65536"},
    {[](RenderOptions& o) { o.height = -5; }, "the height is -5, expected 1 to 65536"},
    {[](RenderOptions& o) { o.tile_size = 0; }, "the tiles' side is 0, expected 1 to 65536"},
    {[](RenderOptions& o) { o.samples_per_pixel = -1; },
     "the number of samples a pixel is -1, expected 1 to 1073741824"},
    {[](RenderOptions& o) { o.camera = 1; }, "camera 1 of a scene that has 1"},
    {[](RenderOptions& o) { o.integrator = IntegratorKind(77); },
     "the integrator is none that there is"},
    {[](RenderOptions& o) { o.filter = FilterKind(77); }, "the filter is none that there is"},
    {[](RenderOptions& o) { o.sampling = SamplingStrategy(77); },
     "the strategy of sampling is none that there is"},
    {[](RenderOptions& o) { o.heuristic = Heuristic(77); }, "the heuristic is none that there is"},
    {[](RenderOptions& o) { o.sampler = SamplerKind(77); }, "the sampler is none that there is"},
    {[](RenderOptions& o) { o.light_sampling = LightSampling(77); },
     "the light sampling is none that there is"},
    {[](RenderOptions& o) { o.guiding = Guiding(77); }, "the guiding is none that there is"},
    {[](RenderOptions& o) { o.specular = SpecularModel(77); },
     "the specular model is none that there is"},
    {[](RenderOptions& o) {
       o.crop = PixelRect{4, 4, 17, 8};
     },
     "the crop 4,4,17,8 is no part of 16 x 16 pixels"},
    {[](RenderOptions& o) {
       o.crop = PixelRect{-4, 0, 4, 4};
     },
     "the crop -4,0,4,4 is no part of 16 x 16 pixels"},
    {[](RenderOptions& o) { o.plan.splitting = 65; }, "splitting is 65, expected 1 to 64"},
    {[](RenderOptions& o) { o.plan.roulette_threshold = nan; },
     "the roulette's threshold is nan, expected above 0 and at most 1"},
    {[](RenderOptions& o) { o.report_p_rr = 0; },
     "the report's probability to go on is 0, expected above 0 and at most 1"},
    {[](RenderOptions& o) { o.lamp_rays = -1; },
     "the number of rays for lamps is -1, expected 0 to 64"},
    {[](RenderOptions& o) { o.filter_radius = 0.0f; },
     "the filter's radius is 0, expected above 0 and at most 32"},
    {[](RenderOptions& o) { o.clamp = -1; }, "what samples are dimmed to is -1, expected above 0"},
    {[](RenderOptions& o) { o.white_balance_kelvins = 3.0; },
     "the white balance is 3, expected 100 to 1000000000"},
    {[](RenderOptions& o) { o.max_depth = -1; }, "the depth is -1, expected at least 0"},
    {[](RenderOptions& o) { o.time_limit_seconds = -1.0; },
     "the limit of time is -1, expected at least 0"}};

TEST(Errors_CheckOptions, WhatIsOutOfItsRange) {
  const FloatingPointTraps traps(Traps::Off);  // of what is no number
  RenderSettings settings = settings_of(16, 1);
  const Scene scene = compiled(small_room(), settings.options);
  EXPECT_TRUE(check_options(scene, settings.options).list().empty());
  const AnyAccelerator accelerator = build_accelerator(scene, AcceleratorKind::Embree);
  for (const Case& c : cases) {
    RenderOptions options = settings.options;
    c.change(options);
    const Diagnostics found = check_options(scene, options);
    ASSERT_EQ(found.list().size(), 1u) << c.sentence;
    EXPECT_EQ(found.list()[0].message, c.sentence);
    EXPECT_THROW((void)render(scene, accelerator, options, nullptr, nullptr), std::invalid_argument)
        << c.sentence;
  }
}

// The largest numbers that the command line takes.
TEST(Unit_CheckOptions, LimitsThatAreNoneAreFine) {
  RenderOptions options = settings_of(16, 1).options;
  const Scene scene = compiled(small_room(), options);
  options.width = options.height = max_side;
  options.samples_per_pixel = max_samples_per_pixel;
  options.max_depth = std::numeric_limits<int>::max();
  options.time_limit_seconds = std::numeric_limits<double>::max();
  options.filter_radius = 32.0f;
  EXPECT_TRUE(check_options(scene, options).list().empty());
}

TEST(Errors_Compile, PicturesWithoutPixels) {
  const Result<Scene> scene = compile(small_room(), {.width = 0, .height = 4});
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.diagnostics.list()[0].message,
            "a picture of 0 x 4 pixels, expected at least 1 x 1");
}

}  // namespace
}  // namespace candela
