// Meshes, instances, holes and heights in the files that are written.
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "scene_io/pbrt/write/write_pbrt.h"
#include "tests/scene_io/pbrt/write/round_trip.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"

namespace candela::pbrt {
namespace {

using namespace description;
using test::RoundTrip;

SceneDescription scene_with_camera() {
  SceneDescription scene = test::empty_scene();
  test::set_camera(scene, {0, 0, 5}, {0, 0, 0});
  return scene;
}

Mesh square() {
  return test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

Transform placed(double x, double scale) {
  return {Mat3d(scale), Vec3d(x, 0.1, 0)};
}

TEST(Unit_WriteShapes, SharedMeshesAreObjects) {
  SceneDescription scene = scene_with_camera();
  const auto grey = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  const MeshHandle mesh = test::add_mesh(scene, square(), grey, placed(1, 2));
  test::add_instance(scene, mesh, placed(2, 1.0 / 3));
  test::add_instance(scene, mesh, {Mat3d(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3d(0, 7, 0)});
  const RoundTrip trip = test::round_trip(scene);
  EXPECT_EQ(count(trip.written.text, "ObjectBegin"), 1u);
  EXPECT_EQ(count(trip.written.text, "ObjectInstance"), 3u);
  EXPECT_EQ(trip.written.meshes.size(), 1u);
  ASSERT_EQ(trip.scene.instances.size(), 3u);
  EXPECT_EQ(trip.scene.meshes.size(), 1u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(trip.scene.instances[i].object_to_world.linear,
              scene.instances[i].object_to_world.linear);
    EXPECT_EQ(trip.scene.instances[i].object_to_world.translation,
              scene.instances[i].object_to_world.translation);
  }
}

TEST(Unit_WriteShapes, SpheresAreSpheres) {
  SceneDescription scene = scene_with_camera();
  const auto grey = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  test::add_mesh(scene, test::exact_sphere(0.3), grey, placed(1, 2));
  const auto lamp = test::add_material(scene, test::diffuse(Vec3d(0.0)), Vec3d(3, 2, 1));
  test::add_mesh(scene, test::exact_sphere(0.1, true), lamp);
  const MeshHandle shared = test::add_mesh(scene, test::exact_sphere(7), grey, placed(3, 4));
  test::add_instance(scene, shared, placed(5, 1.0 / 3));
  const RoundTrip trip = test::round_trip(scene);
  EXPECT_EQ(count(trip.written.text, "Shape \"sphere\""), 3u);
  EXPECT_EQ(count(trip.written.text, "ReverseOrientation"), 1u);
  EXPECT_TRUE(trip.written.meshes.empty());
  ASSERT_EQ(trip.scene.instances.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Instance& before = scene.instances[i];
    const Instance& after = trip.scene.instances[i];
    EXPECT_EQ(after.object_to_world.linear, before.object_to_world.linear);
    EXPECT_EQ(after.object_to_world.translation, before.object_to_world.translation);
    const auto& expected = scene.meshes[before.mesh.index].sphere;
    const auto& sphere = trip.scene.meshes[after.mesh.index].sphere;
    ASSERT_TRUE(sphere);
    EXPECT_EQ(sphere->radius, expected->radius);
    EXPECT_EQ(sphere->faces_inwards, expected->faces_inwards);
  }
}

// pbrt's objects do not shine.
TEST(Unit_WriteShapes, SharedLampsAreShapes) {
  SceneDescription scene = scene_with_camera();
  const auto lamp = test::add_material(scene, test::diffuse(Vec3d(0.5)), Vec3d(3, 2, 1));
  test::add_instance(scene, test::add_mesh(scene, square(), lamp), placed(2, 1));
  const RoundTrip trip = test::round_trip(scene);
  EXPECT_EQ(count(trip.written.text, "ObjectBegin"), 0u);
  EXPECT_EQ(count(trip.written.text, "AreaLightSource"), 2u);
  EXPECT_EQ(trip.written.meshes.size(), 1u);
  ASSERT_EQ(trip.scene.materials.size(), 1u);
  EXPECT_EQ(trip.scene.materials[0].emission, Vec3d(3, 2, 1));
}

TEST(Unit_WriteShapes, MaterialsOfTrianglesAndOfInstances) {
  SceneDescription scene = scene_with_camera();
  const auto red = test::add_material(scene, test::diffuse(Vec3d(0.5, 0, 0)));
  const auto blue = test::add_material(scene, test::diffuse(Vec3d(0, 0, 0.5)));
  const MeshHandle mesh = test::add_mesh(scene, square(), red);
  scene.meshes[mesh.index].materials = {red, blue};
  scene.instances.push_back({mesh, placed(3, 1), blue, {}});
  const RoundTrip trip = test::round_trip(scene);
  EXPECT_EQ(trip.written.meshes.size(), 3u);  // each half, and both
  ASSERT_EQ(trip.scene.instances.size(), 3u);
  const auto reflectance = [&](std::size_t i) {
    const Instance& instance = trip.scene.instances[i];
    const Mesh& m = trip.scene.meshes[instance.mesh.index];
    const MaterialHandle material =
        instance.material_override ? instance.material_override : m.materials[0];
    return std::get<DiffuseMaterial>(trip.scene.materials[material.index].model).reflectance.factor;
  };
  EXPECT_EQ(reflectance(0), Vec3d(0.5, 0, 0));
  EXPECT_EQ(reflectance(1), Vec3d(0, 0, 0.5));
  EXPECT_EQ(reflectance(2), Vec3d(0, 0, 0.5));
}

// One channel of an image is a grey image of its own: pbrt would take the mean of all.
TEST(Unit_WriteShapes, HolesByAlphaAndByAChannel) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"leaf.png", Encoding::Srgb, Wrap::Repeat, {}}};
  const auto leaf = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  test::add_mesh(scene, square(), leaf);
  scene.materials[0].opacity = {1, ImageHandle(0), alpha_or_first, {}};
  RoundTrip trip = test::round_trip(scene, {8, 8, 4, 3, false});
  ASSERT_EQ(trip.written.images.size(), 1u);
  EXPECT_EQ(trip.written.images[0].channel, 3);
  EXPECT_EQ(trip.scene.images[0].encoding, Encoding::Linear);  // alpha is never decoded
  EXPECT_EQ(trip.scene.materials[0].opacity.channel, alpha_or_mean);
  EXPECT_TRUE(trip.scene.materials[0].opacity.map);
  // What pbrt takes by itself stays as it is.
  scene.materials[0].opacity.channel = alpha_or_mean;
  trip = test::round_trip(scene, {8, 8, 4, 3, false});
  EXPECT_EQ(trip.written.images[0].channel, WrittenImage::all_channels);
  EXPECT_EQ(trip.scene.materials[0].opacity.channel, alpha_or_mean);
  scene.materials[0].opacity.channel = 1;
  trip = test::round_trip(scene, {8, 8, 4, 3, false});
  EXPECT_EQ(trip.written.images[0].channel, 1);
  EXPECT_EQ(trip.scene.images[0].encoding, Encoding::Srgb);
  trip = test::round_trip(scene, {8, 8, 1, -1, false});
  EXPECT_EQ(trip.written.images[0].channel, WrittenImage::all_channels);
  EXPECT_TRUE(trip.written.images[0].is_copied);
}

// candela's heights are in edges of the uv square, here of 2, and pbrt's in the world.
TEST(Unit_WriteShapes, HeightsAreLengthsForPbrt) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"bumps.jpg", Encoding::Linear, Wrap::Repeat, {}}};
  const auto rough = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  scene.materials[0].height = ImageHandle(0);
  scene.materials[0].height_scale = -0.25;
  test::add_mesh(scene, square(), rough, placed(0, 2));
  const RoundTrip trip = test::round_trip(scene, {8, 8, 1, -1, false});
  EXPECT_NE(trip.written.text.find("\"float scale\" -0.5"), std::string::npos) << trip.written.text;
  EXPECT_EQ(trip.scene.materials[0].height_scale, -0.25);
  EXPECT_TRUE(trip.scene.materials[0].height_texture);
  EXPECT_FALSE(trip.scene.materials[0].height);
  EXPECT_TRUE(trip.written.images[0].name.ends_with(".png"));
}

TEST(Unit_WriteShapes, HeightsThatAreLengthsStayWhatTheyAre) {
  SceneDescription scene = scene_with_camera();
  scene.textures = {{"ramp", {}, description::BilinearTexture{}}};
  const auto rough = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  scene.materials[0].height_texture = description::TextureHandle(0u);
  scene.materials[0].heights_are_lengths = true;
  test::add_mesh(scene, square(), rough, placed(0, 2));
  const RoundTrip trip = test::round_trip(scene);
  EXPECT_TRUE(trip.scene.materials[0].heights_are_lengths);
  EXPECT_EQ(trip.scene.materials[0].height_scale, 1);
  EXPECT_EQ(trip.scene.textures.size(), 1u) << trip.written.text;
}

// A mixture stands for them, whose parts are no less dented.
TEST(Unit_WriteShapes, DentsOfMixtures) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"bumps.png", Encoding::Linear, Wrap::Repeat, {}}};
  const auto glossy = test::add_material(scene, description::CookTorranceMaterial{});
  scene.materials[0].height = ImageHandle(0);
  scene.materials[0].height_scale = -0.25;
  test::add_mesh(scene, square(), glossy, placed(0, 2));
  const RoundTrip trip = test::round_trip(scene, {8, 8, 1, -1, false});
  for (const Material& material : trip.scene.materials) EXPECT_EQ(material.height_scale, -0.25);
  EXPECT_FALSE(description::validate(trip.scene).has_errors()) << trip.written.text;
}

TEST(Unit_WriteShapes, NormalMapsKeepTheirHandedness) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"normals.png", Encoding::Linear, Wrap::Repeat, {}}};
  const auto rough = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  scene.materials[0].normal_map = ImageHandle(0);
  test::add_mesh(scene, square(), rough, placed(0, 2));
  for (const bool is_right_handed : {false, true}) {
    scene.materials[0].normal_map_is_right_handed = is_right_handed;
    const SceneDescription back = test::round_trip(scene).scene;
    EXPECT_TRUE(back.materials.at(0).normal_map);
    EXPECT_EQ(back.materials.at(0).normal_map_is_right_handed, is_right_handed);
  }
}

// pbrt's run the other way there.
TEST(Unit_WriteShapes, MapsOfNormalsOnMirroredCoordinatesAreSaid) {
  for (const bool is_mirrored : {false, true})
    for (const bool is_turned : {false, true})
      for (const bool is_right_handed : {false, true}) {
        SceneDescription scene = scene_with_camera();
        scene.images = {{"bumps.png", Encoding::Linear, Wrap::Repeat, {}}};
        const auto rough = test::add_material(scene, test::diffuse(Vec3d(0.5)));
        scene.materials[0].normal_map = ImageHandle(0);
        scene.materials[0].normal_map_is_right_handed = is_right_handed;
        Mesh mesh = square();
        if (is_mirrored)
          for (Vec2f& uv : mesh.uvs) uv.x = -uv.x;
        Mat3d place(1.0);
        if (is_turned) place[0][0] = -1;
        test::add_mesh(scene, mesh, rough, {place, Vec3d(0.0)});
        const bool is_lost = !is_right_handed && is_mirrored != is_turned;
        EXPECT_EQ(test::round_trip(scene).diagnostics.warning_count(), is_lost ? 1u : 0u)
            << is_mirrored << is_turned << is_right_handed;
      }
}

// By power it is the image's mean that counts.
TEST(Unit_WriteShapes, LampsWithAnImage) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"glow.exr", Encoding::Linear, Wrap::Clamp, {}}};
  const auto lamp = test::add_material(scene, test::diffuse(Vec3d(0.5)), Vec3d(2.5));
  scene.materials[0].emission_map = ImageHandle(0);
  test::add_mesh(scene, square(), lamp, placed(1, 3));
  for (const bool is_mean : {false, true}) {
    scene.materials[0].emission_is_maps_mean = is_mean;
    const SceneDescription back = test::round_trip(scene).scene;
    ASSERT_EQ(back.materials.size(), 1u);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.materials[0].emission[c], 2.5, 1e-14);
    EXPECT_EQ(back.materials[0].emission_is_maps_mean, is_mean);
    EXPECT_TRUE(back.materials[0].emission_map);
  }
}

// pbrt's end at their edges, which is said where a lamp looks beyond them.
TEST(Unit_WriteShapes, LampsWithAnImageKeepHowItGoesOn) {
  for (const Wrap wrap : {Wrap::Clamp, Wrap::Repeat, Wrap::Mirror, Wrap::Black})
    for (const float reach : {1.0f, 2.0f}) {
      SceneDescription scene = scene_with_camera();
      scene.images = {{"glow.exr", Encoding::Linear, wrap, {}}};
      const auto lamp = test::add_material(scene, test::diffuse(Vec3d(0.5)), Vec3d(2.5));
      scene.materials[0].emission_map = ImageHandle(0);
      Mesh mesh = square();
      mesh.uvs = {{0, 0}, {reach, 0}, {reach, 1}, {0, 1}};
      test::add_mesh(scene, mesh, lamp, placed(1, 3));
      const RoundTrip trip = test::round_trip(scene);
      EXPECT_EQ(trip.scene.images.at(0).wrap, wrap);
      EXPECT_EQ(trip.diagnostics.warning_count(), wrap != Wrap::Clamp && reach > 1 ? 1u : 0u);
    }
}

// pbrt takes no colour beside an image.
TEST(Unit_WriteShapes, LampsWithAnImageKeepTheirColour) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"glow.exr", Encoding::Linear, Wrap::Clamp, {}}};
  const Vec3d colour(3, 0.1, 0);
  const auto lamp = test::add_material(scene, test::diffuse(Vec3d(0.5)), colour);
  scene.materials[0].emission_map = ImageHandle(0);
  test::add_mesh(scene, square(), lamp, placed(1, 3));
  for (const bool is_mean : {false, true}) {
    scene.materials[0].emission_is_maps_mean = is_mean;
    const RoundTrip trip = test::round_trip(scene);
    EXPECT_EQ(trip.diagnostics.warning_count(), 1u);
    ASSERT_EQ(trip.scene.materials.size(), 1u);
    EXPECT_EQ(trip.scene.materials[0].emission, colour);
    EXPECT_EQ(trip.scene.materials[0].emission_is_maps_mean, is_mean);
  }
  scene.materials[0].emission = Vec3d(0.1);  // no colour, though its mean may be off by rounding
  EXPECT_EQ(test::round_trip(scene).diagnostics.warning_count(), 0u);
}

TEST(Unit_WriteShapes, MixturesWithTheirParts) {
  SceneDescription scene = scene_with_camera();
  const auto red = test::add_material(scene, test::diffuse(Vec3d(0.5, 0, 0)));
  DielectricMaterial glass;
  const auto clear = test::add_material(scene, glass);
  const auto mixed = test::add_material(scene, MixMaterial{red, clear, {0.3, {}, 0, {}}});
  scene.materials[mixed.index].emission = Vec3d(1);
  test::add_mesh(scene, square(), mixed);
  const SceneDescription back = test::round_trip(scene).scene;
  const Mesh& mesh = back.meshes[back.instances[0].mesh.index];
  const Material& material = back.materials[mesh.materials[0].index];
  ASSERT_TRUE(std::holds_alternative<MixMaterial>(material.model));
  const auto& mix = std::get<MixMaterial>(material.model);
  EXPECT_EQ(mix.amount.factor, 0.3);
  EXPECT_EQ(material.emission, Vec3d(1));
  EXPECT_EQ(std::get<DiffuseMaterial>(back.materials[mix.first.index].model).reflectance.factor,
            Vec3d(0.5, 0, 0));
  EXPECT_TRUE(std::holds_alternative<DielectricMaterial>(back.materials[mix.second.index].model));
}

// candela looks at the middle of a texture where a mesh has no coordinates; pbrt has its own.
TEST(Unit_WriteShapes, TexturedMeshesHaveTextureCoordinates) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"wood.png", Encoding::Srgb, Wrap::Repeat, {}}};
  ColourInput wood;
  wood.map = ImageHandle(0);
  const auto textured = test::add_material(scene, DiffuseMaterial{wood});
  const auto plain = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  const MeshHandle mesh = test::add_mesh(scene, test::triangle({}, {1, 0, 0}, {0, 1, 0}), textured);
  scene.instances.push_back({mesh, placed(3, 1), plain, {}});
  const RoundTrip trip = test::round_trip(scene);
  ASSERT_EQ(trip.scene.meshes.size(), 2u);
  EXPECT_EQ(trip.scene.meshes[0].uvs, std::vector<Vec2f>(3, Vec2f(0.5f)));
  EXPECT_TRUE(trip.scene.meshes[1].uvs.empty());
}

TEST(Unit_WriteShapes, EqualNamesBecomeDifferentFiles) {
  SceneDescription scene = scene_with_camera();
  const auto grey = test::add_material(scene, test::diffuse(Vec3d(0.5)));
  for (const double x : {1.0, 2.0, 3.0})
    test::add_mesh(scene, test::quad({x, 0, 0}, {1, 0, 0}, {0, 1, 0}), grey);
  for (Mesh& mesh : scene.meshes) mesh.name = "some/where/a box.obj";
  const RoundTrip trip = test::round_trip(scene);
  ASSERT_EQ(trip.written.meshes.size(), 3u);
  EXPECT_EQ(trip.written.meshes[0].name, "files/a_box.ply");
  EXPECT_EQ(trip.written.meshes[1].name, "files/a_box-2.ply");
  EXPECT_EQ(trip.written.meshes[2].name, "files/a_box-3.ply");
  EXPECT_EQ(trip.scene.instances.size(), 3u);
}

TEST(Unit_WriteShapes, MissingImagesAreMagentaAndNamed) {
  SceneDescription scene = scene_with_camera();
  scene.images = {{"gone.png", Encoding::Srgb, Wrap::Repeat, {}}};
  ColourInput gone;
  gone.map = ImageHandle(0);
  const auto textured = test::add_material(scene, DiffuseMaterial{gone});
  test::add_mesh(scene, square(), textured);
  const auto written = write_pbrt(
      scene, {"files", "a.exr", 0, [](const std::string&) { return std::optional<ImageFacts>(); }});
  ASSERT_TRUE(written);
  EXPECT_NE(written->text.find("\"rgb reflectance\" [ 1 0 1 ]"), std::string::npos);
  EXPECT_TRUE(written->images.empty());
  ASSERT_EQ(written.diagnostics.warning_count(), 1u);
  EXPECT_NE(written.diagnostics.list()[0].message.find("gone.png"), std::string::npos);
}

}  // namespace
}  // namespace candela::pbrt
