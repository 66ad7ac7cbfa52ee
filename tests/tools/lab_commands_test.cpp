// `candela render --integrator whitted|raster`: what outputs and messages tell.
#include <gtest/gtest.h>

#include "renderer/image/image_io.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

ProgramResult render(const std::string& scene, const std::string& output,
                     const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"render", scene, "-q", "-o", output, "--size", "8x8"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_candela(arguments);
}

// No light but an environment that has a picture, of which whitted makes nothing.
std::string dark_scene(const std::string& folder) {
  Image grey(2, 1, {"R", "G", "B"});
  for (float& v : grey.values) v = 0.5f;
  EXPECT_FALSE(write_image(folder + "/sky.exr", grey, {}).has_errors());
  write_text(folder + "/floor.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  write_text(folder + "/dark.yaml",
             "Render: {SamplesPerPixel: 5}\nEnvironment: {Map: sky.exr}\n"
             "Materials: [{Name: grey, Type: diffuse}]\n"
             "Models: [{Mesh: floor.obj, Material: grey}]\n");
  return folder + "/dark.yaml";
}

TEST(Unit_LabCommands, PicturesTellTheirIntegrator) {
  const std::string folder = fresh_folder("lab");
  for (const std::string name : {"whitted", "raster"}) {
    const std::string path = folder + "/" + name + ".exr";
    const ProgramResult result =
        render(small_scene(), path, {"--integrator", name, "--stats", folder + "/stats.json"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.error, "");
    const std::string stats = file_text(folder + "/stats.json");
    EXPECT_NE(stats.find("\"integrator\": \"" + name + "\""), std::string::npos) << stats;
    EXPECT_NE(stats.find("\"kernel\": \"" + name + "\""), std::string::npos) << stats;
    EXPECT_NE(stats.find("\"spp\": 64"), std::string::npos) << stats;  // the scene's
    EXPECT_NE(file_text(path).find("specular=blinn lab_normals=no"), std::string::npos);
  }
}

// path shows the sky.
TEST(Unit_LabCommands, ThatASkyAloneIsNotDrawnIsSaid) {
  const std::string folder = fresh_folder("sky_alone");
  const std::string scene = folder + "/sky.pbrt", output = folder + "/a.exr";
  write_text(scene, "WorldBegin\nLightSource \"infinite\"\n");
  for (const std::string name : {"whitted", "raster"}) {
    const ProgramResult lax = render(scene, output, {"--integrator", name});
    EXPECT_EQ(lax.exit_code, 0);
    EXPECT_NE(lax.error.find(name + " draws surfaces alone"), std::string::npos) << lax.error;
    EXPECT_EQ(render(scene, output, {"--integrator", name, "--strict"}).exit_code, 3);
  }
  EXPECT_EQ(render(scene, output, {"--strict"}).exit_code, 0);
}

TEST(Unit_LabCommands, WhatWhittedCannotGrantIsSaid) {
  const std::string folder = fresh_folder("dark");
  const std::string scene = dark_scene(folder), output = folder + "/a.exr";
  const ProgramResult lax = render(scene, output, {"--integrator", "whitted"});
  EXPECT_EQ(lax.exit_code, 0);
  EXPECT_NE(lax.error.find("warning: whitted sees no light in this scene"), std::string::npos);
  EXPECT_NE(lax.error.find("asks for 5 samples a pixel, whitted takes 4"), std::string::npos);
  EXPECT_EQ(render(scene, output, {"--integrator", "whitted", "--strict"}).exit_code, 3);
  const ProgramResult strict =
      render(scene, output, {"--integrator", "raster", "--spp", "4", "--strict"});
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_NE(strict.error.find("raster sees no light"), std::string::npos) << strict.error;
  EXPECT_NE(strict.error.find("--strict: 1 warning about"), std::string::npos) << strict.error;
  EXPECT_EQ(render(scene, output, {"--spp", "4", "--strict"}).exit_code, 0);  // path
}

TEST(Unit_LabCommands, SamplesThatAreNoSquareAreRefused) {
  const ProgramResult result = render(small_scene(), fresh_folder("square") + "/a.exr",
                                      {"--integrator", "whitted", "--spp", "8"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.error.find("the nearest square numbers are 4 and 9"), std::string::npos);
}

}  // namespace
}  // namespace candela::cli_test
