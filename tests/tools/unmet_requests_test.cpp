// What was asked for by name and could not be done is told in a warning; what nobody asked for is
// not.
#include <nlohmann/json.hpp>

#include "tests/tools/refusals.h"

namespace candela::cli_test {
namespace {

std::vector<std::string> warnings_of(std::vector<std::string> words) {
  const std::string folder = fresh_folder("unmet_requests");
  words.insert(words.begin(), "render");
  words.insert(words.end(), {"-o", folder + "/a.exr", "--stats", folder + "/a.json"});
  const ProgramResult result = run_candela(words);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const auto warnings = nlohmann::json::parse(file_text(folder + "/a.json"))["warnings"];
  return warnings.get<std::vector<std::string>>();
}

using Sentences = std::vector<std::string>;

TEST(Unit_UnmetRequests, APilotThatHasTooFewSamplesOrPixels) {
  const auto of_box = [](std::vector<std::string> words) {
    words.insert(words.begin(), cornell_box);
    return warnings_of(words);
  };
  EXPECT_EQ(
      of_box({"--size", "8x8", "--spp", "63", "--adaptive", "on"}),
      Sentences{"--adaptive on: with 63 samples a pixel there is no pilot, which takes 64; all "
                "pixels get the same number of samples"});
  EXPECT_EQ(
      of_box({"--size", "8x8", "--spp", "71", "--replicates", "3", "--adaptive", "on"}),
      Sentences{"--adaptive on: with 71 samples a pixel there is no pilot, which takes 72; all "
                "pixels get the same number of samples"});
  EXPECT_EQ(of_box({"--size", "8x1", "--spp", "64", "--adaptive", "on"}),
            Sentences{"--adaptive on: the picture has but one row or column; all pixels get the "
                      "same number of samples"});
  EXPECT_EQ(of_box({"--size", "8x8", "--spp", "64", "--adaptive", "on"}), Sentences{});
  EXPECT_EQ(of_box({"--size", "8x8", "--spp", "72", "--replicates", "3", "--adaptive", "on"}),
            Sentences{});
  EXPECT_EQ(of_box({"--size", "8x8", "--spp", "8"}), Sentences{});
}

TEST(Unit_UnmetRequests, AnErrorThatNobodyKnows) {
  EXPECT_EQ(warnings_of({cornell_box, "--size", "8x8", "--spp", "1", "--error", "1%"}),
            Sentences{"no error is known of one sample a pixel, so that none ends the render"});
  EXPECT_EQ(warnings_of({cornell_box, "--size", "8x8", "--spp", "4", "--error", "1%"}),
            Sentences{});
}

TEST(Errors_UnmetRequests, EndARenderThatIsStrict) {
  expect_refused({cornell_box, "--size", "8x8", "--spp", "8", "--adaptive", "on", "--strict"}, 3,
                 "--adaptive on: with 8 samples a pixel there is no pilot");
}

TEST(Unit_UnmetRequests, LightThatAClampTakes) {
  EXPECT_EQ(warnings_of({cornell_box, "--size", "8x8", "--spp", "4", "--clamp", "10"}),
            Sentences{"clamp 10: the picture is biased, it lacks light"});
}

TEST(Unit_UnmetRequests, GuidesThatLearnNothing) {
  const std::string none = "--guiding on: no paths were guided, since too little was learned";
  EXPECT_EQ(warnings_of({cornell_box, "--size", "8x8", "--spp", "4", "--guiding", "on"}),
            Sentences{none});
  EXPECT_EQ(warnings_of({cornell_box, "--size", "8x8", "--spp", "4", "--guiding", "auto"}),
            Sentences{});
}

TEST(Unit_UnmetRequests, LayersOfErrorsThatNobodyKnows) {
  const std::string sentence =
      "--aov: no error is known without two replicates and a sample of each: variance, interval "
      "and heavy_tail are 0";
  const auto with = [](std::vector<std::string> words) {
    words.insert(words.begin(), {cornell_box, "--size", "8x8"});
    return warnings_of(words);
  };
  for (const std::string layer : {"variance", "interval", "heavy_tail"}) {
    EXPECT_EQ(with({"--spp", "8", "--replicates", "1", "--aov", layer}), Sentences{sentence});
    EXPECT_EQ(with({"--spp", "1", "--aov", layer}), Sentences{sentence});
    EXPECT_EQ(with({"--spp", "4", "--integrator", "whitted", "--aov", layer}), Sentences{sentence});
    EXPECT_EQ(with({"--spp", "8", "--replicates", "2", "--aov", layer}), Sentences{});
  }
  EXPECT_EQ(with({"--spp", "8", "--replicates", "1", "--aov", "samples"}), Sentences{});
}

TEST(Unit_UnmetRequests, WhatPathsInMediaDoNot) {
  const std::string media = assets + "/pbrt_media/pbrt_media.pbrt";
  EXPECT_EQ(warnings_of({media, "--size", "8x8", "--spp", "4", "--splitting", "2"}),
            Sentences{"--splitting 2: paths through media are not split"});
  EXPECT_EQ(warnings_of({media, "--size", "8x8", "--spp", "4", "--guiding", "on"}),
            Sentences{"--guiding on: paths through media are not guided"});
  EXPECT_EQ(warnings_of({media, "--size", "8x8", "--spp", "4"}), Sentences{});
}

TEST(Unit_UnmetRequests, WhatNoMaterialSkyOrOutputHas) {
  const std::string lights = assets + "/pbrt_lights/pbrt_lights.pbrt";
  const auto with = [](const std::string& scene, std::vector<std::string> words) {
    words.insert(words.begin(), {scene, "--size", "8x8", "--spp", "4"});
    return warnings_of(words);
  };
  EXPECT_EQ(with(lights, {"--fresnel", "schlick"}),
            Sentences{"--fresnel and --geometry: there is no material of the type cook_torrance"});
  EXPECT_EQ(with(lights, {"--geometry", "smith"}),
            Sentences{"--fresnel and --geometry: there is no material of the type cook_torrance"});
  EXPECT_EQ(with(lights, {"--sky-samples", "on"}), Sentences{});
  EXPECT_EQ(with(cornell_box, {"--sky-samples", "on"}),
            Sentences{"--sky-samples on: there is no sky of one colour"});
  EXPECT_EQ(with(cornell_box, {"--exposure", "1"}),
            Sentences{"--exposure and --tonemap: no output is for screens; expected PNG or JPEG"});
  EXPECT_EQ(with(cornell_box, {"--fresnel", "schlick"}), Sentences{});
}

TEST(Unit_UnmetRequests, PathsThatNothingShares) {
  EXPECT_EQ(
      warnings_of(
          {cornell_box, "--size", "16x16", "--spp", "16", "--reuse", "on", "--max-depth", "1"}),
      Sentences{"--reuse on: the scene and the options have no paths that pixels could share"});
  EXPECT_EQ(warnings_of({cornell_box, "--size", "16x16", "--spp", "16", "--reuse", "on"}),
            Sentences{});
}

}  // namespace
}  // namespace candela::cli_test
