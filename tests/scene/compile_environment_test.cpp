// Which of a scene's skies count, and what a compiled scene says of their sum.
#include "renderer/scene/compile_environment.h"

#include <gtest/gtest.h>

#include "tests/image/crafted_files.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using namespace test;
using description::ConstantEnvironment;
using description::EqualAreaEnvironment;
using description::ImageHandle;
using description::SceneDescription;

SceneDescription with_map(const Vec3d& scale = Vec3d(1.0), int side = 8) {
  SceneDescription scene = small_room();
  scene.images = {light_test::write_float_map(fmt::format("skies{}", side), side, side,
                                              [](int x, int y) { return Vec3f(x, y, 1); })};
  add_light(scene, EqualAreaEnvironment{ImageHandle(0), scale, Mat3d(1.0), true});
  return scene;
}

// Whether its header is broken or what follows, and whoever asked for it first: magenta light would
// be a picture that looks finished.
TEST(Errors_CompileEnvironment, ImagesThatCannotBeRead) {
  using crafted::operator+;
  const crafted::Bytes sound = crafted::png_rgba(64, 64, [](int, int, int) { return 7u; });
  const crafted::Bytes header(sound.begin(), sound.begin() + 33);  // signature and IHDR
  const TemporaryFolder folder;
  const std::string no_image = folder.put("text.png", std::string("no image"));
  const std::string no_pixels =
      folder.put("broken.png", header + crafted::png_chunk("IDAT", crafted::Bytes(600, 1)) +
                                   crafted::png_chunk("IEND", {}));
  for (const std::string& path : {no_image, no_pixels})
    for (const bool is_on_a_wall : {false, true}) {
      SceneDescription scene = with_map();
      scene.images[0].path = path;
      scene.images[0].span.line = 3;
      scene.images.push_back(scene.images[0]);
      scene.images[1].span.line = 2;
      if (is_on_a_wall)
        std::get<description::DiffuseMaterial>(scene.materials[0].model).reflectance.map =
            ImageHandle(1);
      const Result<Scene> result = compile(scene, {});
      ASSERT_EQ(result.diagnostics.error_count(), 1u) << path;
      const std::string message = result.diagnostics.list().back().message;
      EXPECT_TRUE(message.starts_with("a light's image '" + path + "' ")) << message;
      EXPECT_EQ(result.diagnostics.list().back().span.line, 3) << "where the light asks for it";
    }
}

// Each within its bounds, and together more than numbers hold.
TEST(Errors_CompileEnvironment, ImagesThatAreTooBrightForTheirScale) {
  const auto expect_told = [](const SceneDescription& scene) {
    const Result<Scene> compiled = compile(scene, {});
    ASSERT_FALSE(compiled);
    EXPECT_NE(compiled.diagnostics.list()[0].message.find(
                  "holds 1e+20, which its scale makes more than 1e+30"),
              std::string::npos)
        << compiled.diagnostics.list()[0].message;
  };
  SceneDescription sky = small_room();
  sky.images = {light_test::write_float_map(
      "bright", 8, 8, [](int x, int y) { return Vec3f(x == 3 && y == 5 ? 1e20f : 1.0f); })};
  SceneDescription lamp = sky;
  add_light(sky, EqualAreaEnvironment{ImageHandle(0), Vec3d(1e15), Mat3d(1.0), true});
  expect_told(sky);
  add_light(sky, ConstantEnvironment{Vec3d(1.0), true});
  expect_told(sky);
  lamp.materials[0].emission = Vec3d(1e15);
  lamp.materials[0].emission_map = ImageHandle(0);
  expect_told(lamp);
  lamp.materials[0].emission = Vec3d(1e9);
  EXPECT_TRUE(compile(lamp, {}));
}

TEST(Unit_CompileEnvironment, OneSkyIsItself) {
  SceneDescription scene = with_map();
  add_light(scene, ConstantEnvironment{Vec3d(0.0), false});  // black: no matter
  TextureStore textures;
  Diagnostics diagnostics;
  const auto environment = compile_environments(scene, textures, diagnostics);
  ASSERT_TRUE(environment);
  EXPECT_EQ(textures.size(), 1u);
  EXPECT_EQ(textures.path(environment->faces[0]), scene.images[0].path);
  EXPECT_TRUE(diagnostics.list().empty());
}

// Light samples that stand alone keep the plain density.
TEST(Unit_CompileEnvironment, IsCompensatedBesideDirectionsFromBsdfsAlone) {
  const auto table = [](IntegratorKind integrator, SamplingStrategy sampling,
                        bool compensates = true) {
    RenderOptions options = settings_of(4, 1).options;
    options.integrator = integrator;
    options.sampling = sampling;
    options.compensates_sky = compensates;
    return compiled(with_map(), options).environment->distribution;
  };
  const auto first_cell = [](const SkyDistribution& sky) { return sky.cells().probability(0, 0); };
  const SkyDistribution plain = table(IntegratorKind::Path, SamplingStrategy::Light);
  const SkyDistribution beside = table(IntegratorKind::Path, SamplingStrategy::Mis);
  EXPECT_EQ(first_cell(beside), first_cell(compensated(plain)));
  EXPECT_GT(std::abs(first_cell(beside) / first_cell(plain) - 1), 0.05);
  EXPECT_EQ(first_cell(table(IntegratorKind::Report, SamplingStrategy::Mis)), first_cell(plain));
  EXPECT_EQ(first_cell(table(IntegratorKind::Path, SamplingStrategy::Mis, false)),
            first_cell(plain));
}

TEST(Unit_CompileEnvironment, BlackSkiesAreKeptWhereThereIsNoOther) {
  SceneDescription scene = small_room();
  TextureStore textures;
  Diagnostics diagnostics;
  EXPECT_FALSE(compile_environments(scene, textures, diagnostics));
  add_light(scene, ConstantEnvironment{Vec3d(0.0), true});
  const auto environment = compile_environments(scene, textures, diagnostics);
  ASSERT_TRUE(environment);
  EXPECT_TRUE(environment->is_black());
}

TEST(Unit_CompileEnvironment, ConstantsAreOneConstant) {
  SceneDescription scene = small_room();
  add_light(scene, ConstantEnvironment{{1, 2, 3}, false});
  add_light(scene, ConstantEnvironment{{0.5, 0, 0.25}, false});
  const Scene compiled_scene = compiled(scene, settings_of(4, 1).options);
  ASSERT_TRUE(compiled_scene.environment->is_constant());
  EXPECT_EQ(compiled_scene.environment->scale, Rgb(1.5f, 2, 3.25f));
  EXPECT_FALSE(compiled_scene.environment->is_seen_by_camera);
  EXPECT_EQ(compiled_scene.ambient, Rgb(1.5f, 2, 3.25f));
}

TEST(Unit_CompileEnvironment, AConstantIsAddedToEachTexelWithoutAWord) {
  SceneDescription scene = with_map({1, 2, 3});
  add_light(scene, ConstantEnvironment{{10, 20, 30}, true});
  TextureStore textures;
  Diagnostics diagnostics;
  const auto environment = compile_environments(scene, textures, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  const TextureHandle map = environment->faces[0];
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(Rgb(textures.texel(map, x, y)), Rgb(x + 10, 2 * y + 20, 33));
}

TEST(Unit_CompileEnvironment, ANoteSaysWhatIsResampled) {
  SceneDescription scene = with_map();
  scene.images.push_back(with_map(Vec3d(1.0), 48).images[0]);
  add_light(scene, EqualAreaEnvironment{ImageHandle(1), Vec3d(1.0), Mat3d(1.0), true});
  TextureStore textures;
  Diagnostics diagnostics;
  const auto environment = compile_environments(scene, textures, diagnostics);
  EXPECT_EQ(environment->mapping, EnvironmentMapping::EqualArea);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].severity, Severity::Note);
  EXPECT_EQ(diagnostics.list()[0].message,
            "the scene's 2 skies differ in grid or rotation: their sum is resampled to a map of "
            "equal areas, 96 x 96 texels");
}

}  // namespace
}  // namespace candela
