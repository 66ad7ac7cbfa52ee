#include "tools/candela/render_settings.h"

#include <gtest/gtest.h>

namespace candela::cli {
namespace {

description::SceneDescription scene_with_wishes() {
  description::SceneDescription scene;
  scene.cameras.resize(2);
  scene.defaults.width = 100;
  scene.defaults.height = 50;
  scene.defaults.samples_per_pixel = 7;
  scene.defaults.max_depth = 3;
  scene.defaults.seed = 11;
  scene.defaults.filter = "box";
  scene.defaults.integrator = "path";
  scene.defaults.exposure = 1.5;
  return scene;
}

RenderSettings settings(const RenderArguments& arguments,
                        const description::SceneDescription& scene) {
  const SettledSettings settled = settle_settings(arguments, scene);
  EXPECT_TRUE(settled.settings) << settled.error;
  return settled.settings.value_or(RenderSettings{});
}

void expect_refused(const RenderArguments& arguments, const description::SceneDescription& scene,
                    ExitCode code, const std::string& sentence) {
  const SettledSettings settled = settle_settings(arguments, scene);
  EXPECT_FALSE(settled.settings);
  EXPECT_EQ(settled.exit_code, code);
  EXPECT_NE(settled.error.find(sentence), std::string::npos) << settled.error;
}

TEST(Unit_RenderSettings, ASilentSceneGetsTheDefaults) {
  const RenderSettings s = settings({}, {});
  EXPECT_EQ(s.options.width, 512);
  EXPECT_EQ(s.options.height, 512);
  EXPECT_EQ(s.options.samples_per_pixel, 64);
  EXPECT_EQ(s.options.max_depth, std::nullopt);
  EXPECT_EQ(s.options.seed, 0u);
  EXPECT_EQ(s.options.filter, FilterKind::BlackmanHarris);
  EXPECT_EQ(s.options.plan.splitting, 1u);
  EXPECT_EQ(s.options.plan.roulette_threshold, 0.5f);
  EXPECT_TRUE(s.options.chooses_roulette);
  EXPECT_EQ(s.display.exposure, 0);
  RenderArguments arguments;
  arguments.scene.path = "folder/name.with.dots.yaml";
  EXPECT_EQ(output_paths(arguments), std::vector<std::string>{"name.with.dots.exr"});
  arguments.scene.path = "folder/name.with.dots.yaml.gz";
  EXPECT_EQ(output_paths(arguments), std::vector<std::string>{"name.with.dots.exr"});
}

TEST(Unit_RenderSettings, PathsAreSplitAndEndedAsAsked) {
  RenderArguments arguments;
  arguments.splitting = 3;
  arguments.roulette = RouletteThreshold{0.25};
  const RenderOptions options = settings(arguments, {}).options;
  const PathPlan& plan = options.plan;
  EXPECT_FALSE(options.chooses_roulette);
  EXPECT_EQ(plan.splitting, 3u);
  EXPECT_EQ(plan.roulette_threshold, 0.25f);
}

TEST(Unit_RenderSettings, TheSceneOverridesTheDefaults) {
  const RenderSettings s = settings({}, scene_with_wishes());
  EXPECT_EQ(s.options.width, 100);
  EXPECT_EQ(s.options.height, 50);
  EXPECT_EQ(s.options.samples_per_pixel, 7);
  EXPECT_EQ(s.options.max_depth, 3);
  EXPECT_EQ(s.options.seed, 11u);
  EXPECT_EQ(s.options.filter, FilterKind::Box);
  EXPECT_EQ(s.display.exposure, 1.5);
}

// From the first pixel whose corner is within, as pbrt has it; shares are of whatever size is asked
// for.
TEST(Unit_RenderSettings, CropWindowsAreSharesOfThePicture) {
  description::SceneDescription scene = scene_with_wishes();
  scene.defaults.crop = description::CropWindow{0.25, 0.505, 0.2, 1};
  EXPECT_EQ(settings({}, scene).options.crop, (PixelRect{25, 10, 51, 50}));
  RenderArguments arguments;
  arguments.size = Size{40, 30};
  EXPECT_EQ(settings(arguments, scene).options.crop, (PixelRect{10, 6, 21, 30}));
  arguments.crop = PixelRect{1, 2, 3, 4};
  EXPECT_EQ(settings(arguments, scene).options.crop, (PixelRect{1, 2, 3, 4}));
  scene.defaults.crop = description::CropWindow{0.251, 0.252, 0, 1};
  expect_refused({}, scene, ExitCode::Scene,
                 "the scene's crop window holds no pixel of a picture of 100x50");
}

TEST(Unit_RenderSettings, TheCommandLineOverridesTheScene) {
  RenderArguments arguments;
  arguments.size = Size{40, 30};
  arguments.scale = 0.5;
  arguments.samples_per_pixel = 2;
  arguments.max_depth = DepthLimit{};  // none
  arguments.seed = 0;
  arguments.filter = FilterKind::Gaussian;
  arguments.exposure = 0;
  arguments.camera = 1;
  const RenderSettings s = settings(arguments, scene_with_wishes());
  EXPECT_EQ(s.options.width, 20);
  EXPECT_EQ(s.options.height, 15);
  EXPECT_EQ(s.options.samples_per_pixel, 2);
  EXPECT_EQ(s.options.max_depth, std::nullopt);
  EXPECT_EQ(s.options.seed, 0u);
  EXPECT_EQ(s.options.filter, FilterKind::Gaussian);
  EXPECT_EQ(s.options.camera, 1u);
  EXPECT_EQ(s.display.exposure, 0);
}

TEST(Unit_RenderSettings, WaysOfSamplingAreAsAsked) {
  const RenderOptions silent = settings({}, {}).options;
  EXPECT_TRUE(silent.adaptive);
  RenderArguments of_one_replicate;
  of_one_replicate.replicates = 1;
  EXPECT_FALSE(settings(of_one_replicate, {}).options.adaptive);
  of_one_replicate.adaptive = true;
  EXPECT_TRUE(settings(of_one_replicate, {}).options.adaptive);
  EXPECT_EQ(silent.lamp_rays, 8);
  EXPECT_EQ(silent.sampler, SamplerKind::Sobol);
  EXPECT_EQ(silent.light_sampling, LightSampling::Area);
  EXPECT_FALSE(silent.samples_constant_sky);
  EXPECT_TRUE(silent.compensates_sky);
  EXPECT_TRUE(silent.light_cells);
  RenderArguments arguments;
  arguments.adaptive = false;
  arguments.lamp_rays = 3;
  arguments.sampler = SamplerKind::Independent;
  arguments.light_sampling = LightSampling::Triangles;
  arguments.samples_constant_sky = true;
  arguments.compensates_sky = false;
  arguments.light_cells = false;
  arguments.clamp = 7;
  arguments.replicates = 2;
  arguments.time_limit_seconds = 5;
  const RenderOptions asked = settings(arguments, {}).options;
  EXPECT_FALSE(asked.adaptive);
  EXPECT_EQ(asked.lamp_rays, 3);
  EXPECT_EQ(asked.sampler, SamplerKind::Independent);
  EXPECT_EQ(asked.light_sampling, LightSampling::Triangles);
  EXPECT_TRUE(asked.samples_constant_sky);
  EXPECT_FALSE(asked.compensates_sky);
  EXPECT_FALSE(asked.light_cells);
  EXPECT_EQ(asked.clamp, 7);
  EXPECT_EQ(asked.replicates, 2);
  EXPECT_EQ(asked.time_limit_seconds, 5);
}

TEST(Unit_RenderSettings, TheFilmShowsWhatTheSceneAndTheCommandLineSay) {
  description::SceneDescription scene = scene_with_wishes();
  scene.defaults.white_balance_kelvins = 5000;
  scene.defaults.filter_radius = 2.5;
  RenderArguments arguments;
  arguments.is_transparent = true;
  arguments.aovs = aov_bit(Aov::Depth);
  arguments.tone_map = ToneMap::Aces;
  const RenderSettings s = settings(arguments, scene);
  EXPECT_EQ(s.options.white_balance_kelvins, 5000);
  EXPECT_EQ(s.options.filter_radius, 2.5f);
  EXPECT_TRUE(s.options.transparent);
  EXPECT_EQ(s.options.aovs, aov_bit(Aov::Depth));
  EXPECT_EQ(s.display.tone_map, ToneMap::Aces);
  // The scene's radius is that of the scene's filter.
  arguments.filter = FilterKind::Box;
  EXPECT_EQ(settings(arguments, scene).options.filter_radius, std::nullopt);
}

TEST(Unit_RenderSettings, ScaleMultipliesTheScenesSizeAndKeepsAPixel) {
  RenderArguments arguments;
  arguments.scale = 0.25;
  EXPECT_EQ(settings(arguments, scene_with_wishes()).options.width, 25);
  EXPECT_EQ(settings(arguments, scene_with_wishes()).options.height, 13);  // of 12.5
  arguments.scale = 1e-9;
  EXPECT_EQ(settings(arguments, scene_with_wishes()).options.width, 1);
}

// --error is an rMSE, --relmse its square; the stricter of both counts.
TEST(Unit_RenderSettings, ErrorsToReachAreRelmse) {
  const auto target = [](std::optional<double> rmse, std::optional<double> relmse) {
    RenderArguments arguments;
    arguments.error_goal = rmse;
    arguments.relmse_goal = relmse;
    return settings(arguments, {}).options.target_relmse;
  };
  EXPECT_EQ(target({}, {}), std::nullopt);
  EXPECT_EQ(target(0.25, {}), 0.0625);
  EXPECT_EQ(target({}, 0.25), 0.25);
  EXPECT_EQ(target(0.25, 0.25), 0.0625);
  EXPECT_EQ(target(0.5, 0.125), 0.125);
}

TEST(Unit_RenderSettings, WhatDoesNotFitTheSceneIsRefused) {
  RenderArguments arguments;
  arguments.camera = 2;
  expect_refused(arguments, scene_with_wishes(), ExitCode::Usage,
                 "--camera 2: the scene has cameras 0 to 1");
  arguments = {};
  arguments.crop = PixelRect{0, 0, 101, 50};
  expect_refused(arguments, scene_with_wishes(), ExitCode::Usage,
                 "--crop 0,0,101,50 leaves the picture, which is 100x50");
  arguments = {};
  arguments.clamp = 1e-60;
  expect_refused(arguments, scene_with_wishes(), ExitCode::Usage,
                 "--clamp 1e-60 would leave no light");
  arguments = {};
  arguments.scale = 1e6;
  expect_refused(arguments, scene_with_wishes(), ExitCode::Usage, "--scale 1000000");
  arguments = {};
  arguments.size = Size{65536, 65536};
  expect_refused(arguments, scene_with_wishes(), ExitCode::Limit, "GB of memory");
}

// A crop has a pilot of the whole picture, but for rules that have it end when it is good itself.
TEST(Unit_RenderSettings, AGiantsPilotCounts) {
  RenderArguments arguments;
  arguments.size = Size{65536, 65536};
  arguments.crop = PixelRect{0, 0, 4, 4};
  expect_refused(arguments, {}, ExitCode::Limit, "for its pilot");
  expect_refused(arguments, {}, ExitCode::Limit, "--adaptive off does without");
  arguments.adaptive = false;
  EXPECT_TRUE(settle_settings(arguments, {}).settings);
  arguments.adaptive.reset();
  arguments.error_goal = 0.01;
  EXPECT_TRUE(settle_settings(arguments, {}).settings);
  arguments.error_goal.reset();
  arguments.samples_per_pixel = 63;
  EXPECT_TRUE(settle_settings(arguments, {}).settings);
}

TEST(Unit_RenderSettings, ReplicatesWithoutSamplesNeedNoMemory) {
  RenderArguments arguments;
  arguments.size = Size{1024, 1024};
  arguments.replicates = 1 << 20;
  arguments.samples_per_pixel = 1 << 20;
  expect_refused(arguments, {}, ExitCode::Limit, "GB of memory");
  arguments.samples_per_pixel = 1;
  EXPECT_TRUE(settle_settings(arguments, {}).settings);
}

TEST(Unit_RenderSettings, WishesThatNobodyCanGrantAreTheScenesErrors) {
  description::SceneDescription scene;
  scene.defaults.integrator = "pth";
  expect_refused({}, scene, ExitCode::Scene, "unknown integrator 'pth', did you mean 'path'?");
  scene = {};
  scene.defaults.width = 0;
  expect_refused({}, scene, ExitCode::Scene, "a picture of 0x512");
  scene = {};
  scene.defaults.samples_per_pixel = -1;
  expect_refused({}, scene, ExitCode::Scene, "-1 samples a pixel");
  RenderArguments arguments;  // what is said on the command line makes the scene's wish moot
  arguments.samples_per_pixel = 1;
  EXPECT_EQ(settings(arguments, scene).options.samples_per_pixel, 1);
}

RenderArguments with_integrator(IntegratorKind integrator) {
  RenderArguments arguments;
  arguments.integrator = integrator;
  return arguments;
}

TEST(Unit_RenderSettings, OnlyPathHasAGeneralKernel) {
  for (const IntegratorKind integrator : {IntegratorKind::Whitted, IntegratorKind::Report}) {
    RenderArguments arguments = with_integrator(integrator);
    arguments.uses_general_kernel = true;
    expect_refused(arguments, {}, ExitCode::Usage, "--kernel general is for path");
  }
}

TEST(Unit_RenderSettings, WhittedAndRasterHaveDefaultsOfTheirOwn) {
  const RenderSettings whitted = settings(with_integrator(IntegratorKind::Whitted), {});
  EXPECT_EQ(whitted.options.samples_per_pixel, 16);
  EXPECT_EQ(whitted.options.max_depth, 5);
  EXPECT_EQ(whitted.options.filter, FilterKind::Box);
  EXPECT_EQ(whitted.options.specular, SpecularModel::Blinn);
  const RenderSettings raster = settings(with_integrator(IntegratorKind::Raster), {});
  EXPECT_EQ(raster.options.samples_per_pixel, 16);
  EXPECT_EQ(raster.options.max_depth, std::nullopt);
}

TEST(Unit_RenderSettings, AGridOfSamplesIsASquare) {
  RenderArguments arguments = with_integrator(IntegratorKind::Whitted);
  for (const int square : {1, 4, 9, 16, 25, 1024, 32767 * 32767}) {
    arguments.samples_per_pixel = square;
    EXPECT_EQ(settings(arguments, {}).options.samples_per_pixel, square);
  }
  arguments.samples_per_pixel = 5;
  expect_refused(arguments, {}, ExitCode::Usage,
                 "--spp 5: whitted puts samples on a grid of n x n; the nearest square numbers "
                 "are 4 and 9");
  arguments.samples_per_pixel = 3;
  arguments.integrator = IntegratorKind::Raster;
  expect_refused(arguments, {}, ExitCode::Usage, "raster puts samples on a grid");
  arguments.integrator = IntegratorKind::Path;
  EXPECT_EQ(settings(arguments, {}).options.samples_per_pixel, 3);
}

TEST(Unit_RenderSettings, TheScenesSamplesAreLoweredToASquareWithAWarning) {
  const RenderSettings lowered =
      settings(with_integrator(IntegratorKind::Whitted), scene_with_wishes());  // 7
  EXPECT_EQ(lowered.options.samples_per_pixel, 4);
  ASSERT_EQ(lowered.warnings.size(), 1u);
  EXPECT_EQ(lowered.warnings[0],
            "the scene asks for 7 samples a pixel, whitted takes 4: a grid of 2 x 2");
  EXPECT_TRUE(settings({}, scene_with_wishes()).warnings.empty());
}

TEST(Unit_RenderSettings, WhatAnIntegratorHasNoUseForIsRefused) {
  RenderArguments arguments = with_integrator(IntegratorKind::Whitted);
  arguments.max_depth = DepthLimit{};
  expect_refused(arguments, {}, ExitCode::Usage, "--max-depth none: whitted needs a limit");
  arguments.integrator = IntegratorKind::Raster;
  arguments.max_depth = DepthLimit{3};
  expect_refused(arguments, {}, ExitCode::Usage, "--max-depth: raster follows no ray");
  arguments = with_integrator(IntegratorKind::Whitted);
  arguments.filter = FilterKind::Gaussian;
  expect_refused(arguments, {}, ExitCode::Usage, "--filter gaussian: whitted averages its grid");
  arguments = with_integrator(IntegratorKind::Raster);
  arguments.measures_ray_limit = true;
  expect_refused(arguments, {}, ExitCode::Usage, "--ray-limit measures the path integrator");
  arguments = with_integrator(IntegratorKind::Path);
  arguments.specular = SpecularModel::Phong;
  expect_refused(arguments, {}, ExitCode::Usage, "--specular is for whitted and raster");
  arguments = {};
  arguments.has_lab_normals = true;
  expect_refused(arguments, {}, ExitCode::Usage, "--lab-normals is for whitted and raster");
}

}  // namespace
}  // namespace candela::cli
