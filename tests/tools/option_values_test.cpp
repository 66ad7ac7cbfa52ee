#include "tools/candela/option_values.h"

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>

#include "tools/candela/parse_arguments.h"

namespace candela::cli {
namespace {

template <class T>
std::string reason(const Result<T>& result) {
  return result ? "" : result.diagnostics.list().at(0).message;
}

TEST(Unit_OptionValues, SizesAreTwoWholeNumbers) {
  EXPECT_EQ(*parse_size("640x480"), (Size{640, 480}));
  EXPECT_EQ(*parse_size("65536x1"), (Size{65536, 1}));
  for (const char* wrong : {"", "640", "640x", "x480", "640x480x3", "6.4x4", "0x5", "-1x5",
                            "65537x1", "640X480", " 640x480", "99999999999x1"})
    EXPECT_FALSE(parse_size(wrong)) << wrong;
  EXPECT_EQ(reason(parse_size("640")), "expected WIDTHxHEIGHT such as 640x480, found '640'");
}

TEST(Unit_OptionValues, CropsAreHalfOpenAndNotEmpty) {
  EXPECT_EQ(*parse_crop("0,1,2,3"), (PixelRect{0, 1, 2, 3}));
  for (const char* wrong : {"", "0,0,1", "0,0,1,1,1", "0,0,0,1", "2,0,1,1", "-1,0,1,1", "a,0,1,1"})
    EXPECT_FALSE(parse_crop(wrong)) << wrong;
}

TEST(Unit_OptionValues, NumbersAreFiniteAndWhole) {
  EXPECT_EQ(*parse_number("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(*parse_number("+2"), 2);
  for (const char* wrong : {"", "nan", "inf", "1e999", "1,5", "1x", "--1"})
    EXPECT_FALSE(parse_number(wrong)) << wrong;
  EXPECT_TRUE(parse_non_negative_number("0"));
  EXPECT_FALSE(parse_positive_number("0"));
  EXPECT_EQ(*parse_integer("64", 1, 64), 64);
  EXPECT_FALSE(parse_integer("65", 1, 64));
  EXPECT_FALSE(parse_integer("0", 1, 64));
  EXPECT_EQ(*parse_seed("18446744073709551615"), ~std::uint64_t{0});
  EXPECT_FALSE(parse_seed("18446744073709551616"));
  EXPECT_FALSE(parse_seed("-1"));
}

TEST(Unit_OptionValues, DepthsMayBeNone) {
  EXPECT_EQ(parse_depth_limit("none")->depth, std::nullopt);
  EXPECT_EQ(parse_depth_limit("0")->depth, 0);
  EXPECT_FALSE(parse_depth_limit("-1"));
  EXPECT_FALSE(parse_depth_limit("None"));
}

TEST(Unit_OptionValues, RouletteHasAThresholdAboveZero) {
  EXPECT_EQ(parse_roulette(".25")->threshold, 0.25);
  EXPECT_EQ(parse_roulette("1")->threshold, 1.0);
  EXPECT_EQ(parse_roulette("auto")->threshold, std::nullopt);
  for (const char* wrong : {"0", "-1", "1.01", "nan", "none", "1e-60", ""})
    EXPECT_FALSE(parse_roulette(wrong)) << wrong;
  EXPECT_EQ(parse_roulette("2").diagnostics.list().front().message,
            "expected a number from 1e-06 to 1 or 'auto', found '2'");
}

TEST(Unit_OptionValues, ColoursAreThreeNonNegativeNumbers) {
  EXPECT_EQ(*parse_rgb(".1,2,0"), Vec3d(.1, 2, 0));
  for (const char* wrong : {"1", "1,2", "1,2,3,4", "1,-2,3", "1,,3"})
    EXPECT_FALSE(parse_rgb(wrong));
}

TEST(Unit_OptionValues, LayersAreASet) {
  EXPECT_EQ(*parse_aovs("normal,albedo,normal"), aov_bit(Aov::Normal) | aov_bit(Aov::Albedo));
  EXPECT_EQ(
      reason(parse_aovs("albedo,nornal")),
      "unknown layer 'nornal', did you mean 'normal'? Known: albedo, normal, depth, position, "
      "material_id, samples, variance, interval, heavy_tail");
}

TEST(Unit_OptionValues, NamesReadBackAsTheirValues) {
  for (const auto& choice : filter_choices())
    EXPECT_EQ(*choose("filter", choice.name, filter_choices()), choice.value);
  for (const auto& choice : tone_map_choices())
    EXPECT_EQ(name_of(choice.value, tone_map_choices()), choice.name);
  EXPECT_EQ(reason(choose("integrator", "zzzz", integrator_choices())),
            "unknown integrator 'zzzz'. Known: path, whitted, raster, report");
}

// `candela render s.yaml` with these words, which spaces part.
RenderArguments rendering(const std::string& options) {
  std::istringstream stream("render s.yaml " + options);
  const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  const ParsedArguments parsed = parse_arguments(words);
  EXPECT_TRUE(parsed.arguments) << parsed.error;
  return parsed.arguments ? std::get<RenderArguments>(*parsed.arguments) : RenderArguments{};
}

TEST(Unit_OptionValues, OptionsReachTheirFields) {
  const RenderArguments a = rendering(
      "-o a.exr --output b.png --spp 7 --size 8x9 --scale 0.5 --camera 3 --crop 1,2,3,4 "
      "--max-depth none --seed 11 -t 2 --accel bvh --robust off --kernel general --filter box "
      "--exposure -1.5 --tonemap aces --aov depth --strict --transparent -q --ray-limit "
      "--stats s.json --materials mtl --lab3-ground g.jpg --ambient 1,2,3 --integrator path");
  EXPECT_EQ(a.scene.path, "s.yaml");
  EXPECT_EQ(a.outputs, (std::vector<std::string>{"a.exr", "b.png"}));
  EXPECT_EQ(a.samples_per_pixel, 7);
  EXPECT_EQ(a.size, (Size{8, 9}));
  EXPECT_EQ(a.scale, 0.5);
  EXPECT_EQ(a.camera, 3u);
  EXPECT_EQ(a.crop, (PixelRect{1, 2, 3, 4}));
  ASSERT_TRUE(a.max_depth);
  EXPECT_EQ(a.max_depth->depth, std::nullopt);
  EXPECT_EQ(a.seed, 11u);
  EXPECT_EQ(a.threads, 2);
  EXPECT_EQ(a.accelerator, AcceleratorKind::Bvh);
  EXPECT_FALSE(a.embree.robust);
  EXPECT_TRUE(a.uses_general_kernel);
  EXPECT_EQ(a.filter, FilterKind::Box);
  EXPECT_EQ(a.exposure, -1.5);
  EXPECT_EQ(a.tone_map, ToneMap::Aces);
  EXPECT_EQ(a.aovs, aov_bit(Aov::Depth));
  EXPECT_TRUE(a.scene.is_strict && a.is_transparent && a.is_quiet && a.measures_ray_limit);
  EXPECT_EQ(a.stats_path, "s.json");
  EXPECT_TRUE(a.scene.load.use_mtl_materials);
  EXPECT_EQ(a.scene.load.lab3_ground, "g.jpg");
  EXPECT_EQ(a.scene.load.ambient, Vec3d(1, 2, 3));
  EXPECT_EQ(a.integrator, IntegratorKind::Path);
}

TEST(Unit_OptionValues, OptionsOfSamplingReachTheirFields) {
  const RenderArguments a = rendering(
      "--error 0.5 --relmse 0.25 --time 3s --replicates 6 --adaptive off --splitting 3 --reuse on "
      "--roulette 0.75 --guiding auto --clamp 2.5 --sampling bsdf --heuristic balance "
      "--sampler padded --lamp-rays 5 --light-sampling solid_angle --rr 0.125 "
      "--without packets,convoys --fresnel schlick --geometry smith");
  EXPECT_EQ(a.error_goal, 0.5);
  EXPECT_EQ(a.relmse_goal, 0.25);
  EXPECT_EQ(a.time_limit_seconds, 3);
  EXPECT_EQ(a.replicates, 6);
  EXPECT_EQ(a.adaptive, false);
  EXPECT_EQ(a.splitting, 3);
  EXPECT_EQ(a.reuses_paths, PathSharing{true});
  EXPECT_EQ(a.roulette, RouletteThreshold{0.75});
  EXPECT_EQ(a.guiding, Guiding::Auto);
  EXPECT_EQ(a.clamp, 2.5);
  EXPECT_EQ(a.sampling, SamplingStrategy::Bsdf);
  EXPECT_EQ(a.heuristic, Heuristic::Balance);
  EXPECT_EQ(a.sampler, SamplerKind::Padded);
  EXPECT_EQ(a.lamp_rays, 5);
  EXPECT_EQ(a.light_sampling, LightSampling::SolidAngle);
  EXPECT_EQ(a.report_p_rr, 0.125);
  EXPECT_EQ(a.without, saving_bit(Saving::Packets) | saving_bit(Saving::Convoys));
  EXPECT_EQ(a.scene.load.fresnel, FresnelModel::Schlick);
  EXPECT_EQ(a.scene.load.geometry, GeometryModel::Smith);
}

// One at a time, so that none can stand for another.
TEST(Unit_OptionValues, EachSwitchIsItsOwn) {
  const auto switches = [](const RenderArguments& a) {
    return std::vector{a.adaptive, a.samples_constant_sky, a.compensates_sky, a.light_cells};
  };
  const std::vector<std::string> options{"--adaptive", "--sky-samples", "--sky-compensation",
                                         "--light-cells"};
  for (std::size_t i = 0; i < options.size(); ++i)
    for (const bool on : {true, false}) {
      std::vector<std::optional<bool>> expected(options.size());
      expected[i] = on;
      EXPECT_EQ(switches(rendering(options[i] + (on ? " on" : " off"))), expected) << options[i];
    }
}

TEST(Unit_OptionValues, TheLabsShadingHasOptionsOfItsOwn) {
  const RenderArguments a = rendering("--integrator whitted --specular phong --lab-normals");
  EXPECT_EQ(a.integrator, IntegratorKind::Whitted);
  EXPECT_EQ(a.specular, SpecularModel::Phong);
  EXPECT_TRUE(a.has_lab_normals);
  EXPECT_FALSE(rendering("").has_lab_normals);
}

TEST(Unit_OptionValues, WhatIsNotSaidIsLeftToTheScene) {
  const RenderArguments a = rendering("");
  EXPECT_FALSE(a.samples_per_pixel || a.size || a.max_depth || a.seed || a.filter || a.exposure ||
               a.integrator || a.crop || a.stats_path || a.specular);
  EXPECT_TRUE(a.outputs.empty());
}

TEST(Unit_OptionValues, NumbersThatLightCannotHaveAreRefused) {
  EXPECT_TRUE(parse_rgb("1e30,0,0"));
  EXPECT_EQ(reason(parse_rgb("1e31,0,0")),
            "expected three numbers R,G,B from 0 to 1e30 such as .1,.1,.1, found '1e31,0,0'");
  EXPECT_TRUE(parse_duration("1e304h"));
  EXPECT_FALSE(parse_duration("1e308h"));
}

TEST(Unit_OptionValues, TheLastValueCounts) {
  EXPECT_EQ(rendering("--spp 1 --spp=2").samples_per_pixel, 2);
}

}  // namespace
}  // namespace candela::cli
