// Textures of pbrt scenes as the reader leaves them.
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::pbrt_world;
using test::pbrt_world_error;

void expect_near(const Vec3d& vector, const Vec3d& expected) {
  EXPECT_LT(length(vector - expected), 1e-9) << vector.x << " " << vector.y << " " << vector.z;
}

TEST(Unit_PbrtTextures, KindsAndTheirInputs) {
  const auto scene = pbrt_world(R"(
    Texture "map" "spectrum" "imagemap" "string filename" "picture.png" "string wrap" "clamp"
    Texture "twice" "spectrum" "imagemap" "string filename" "picture.png" "float uscale" 2
      "float vdelta" .5 "bool invert" true "string encoding" "linear"
    Texture "board" "spectrum" "checkerboard" "texture tex1" "map" "texture tex2" "twice"
    Texture "alpha" "float" "imagemap" "string filename" "picture.png"
    Material "diffuse" "texture reflectance" "board"
    Shape "disk" "texture alpha" "alpha")");
  const auto& material = scene.materials.at(0);
  const auto& reflectance = std::get<DiffuseMaterial>(material.model).reflectance;
  ASSERT_EQ(reflectance.texture.index, 1u);
  const auto& board = std::get<CheckerboardTexture>(scene.textures.at(1).kind);
  EXPECT_EQ(scene.images.at(board.even.map.index).wrap, Wrap::Clamp);
  EXPECT_EQ(scene.images.at(board.even.map.index).encoding, Encoding::Srgb);
  ASSERT_EQ(board.odd.texture.index, 0u);
  const auto& twice = std::get<ImageTexture>(scene.textures.at(0).kind);
  EXPECT_EQ(twice.mapping.scale, Vec2d(2, 1));
  EXPECT_EQ(twice.mapping.offset, Vec2d(0, 0.5));
  EXPECT_TRUE(twice.is_inverted);
  EXPECT_EQ(scene.images.at(twice.image.index).encoding, Encoding::Linear);
  EXPECT_TRUE(material.opacity.map.is_valid());
  EXPECT_EQ(material.opacity.channel, alpha_or_first);
}

TEST(Unit_PbrtTextures, ByPlaceAndByNormal) {
  const auto scene = pbrt_world(R"(
    AttributeBegin
    Translate 5 0 0
    Scale 2 2 2
    Texture "flat" "spectrum" "checkerboard" "string mapping" "planar" "vector3 v1" [ 0 0 3 ]
      "float udelta" .5 "float uscale" 9
    Texture "round" "spectrum" "imagemap" "string filename" "picture.png"
      "string mapping" "spherical"
    Texture "cubes" "spectrum" "checkerboard" "integer dimension" 3
    Rotate 90 1 0 0
    Texture "snow" "spectrum" "directionmix" "texture tex1" "flat" "texture tex2" "round"
    AttributeEnd
    Texture "all" "spectrum" "mix" "texture tex1" "snow" "texture tex2" "cubes"
    Material "diffuse" "texture reflectance" "all"
    Shape "disk")");
  EXPECT_FALSE(validate(scene).has_errors());
  const auto& flat = std::get<CheckerboardTexture>(scene.textures.at(0).kind).mapping;
  EXPECT_EQ(flat.kind, MappingKind::Planar);
  expect_near(flat.place_from_world.point({7, 4, 6}), {9, 2, 0});  // (1, 2, 3) there
  EXPECT_EQ(flat.offset, Vec2d(0.5, 0));
  EXPECT_EQ(flat.scale, Vec2d(1.0));
  const auto& round = std::get<ImageTexture>(scene.textures.at(1).kind).mapping;
  EXPECT_EQ(round.kind, MappingKind::Spherical);
  expect_near(round.place_from_world.point({7, 4, 6}), {1, 2, 3});
  expect_near(std::get<DirectionMixTexture>(scene.textures.at(2).kind).direction, {0, 0, 1});
  const auto& cubes = std::get<SolidCheckerboardTexture>(scene.textures.at(3).kind);
  expect_near(cubes.place_from_world.point({7, 4, 6}), {1, 2, 3});
}

TEST(Errors_PbrtTextures, Mappings) {
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"spectrum\" \"dots\" \"string mapping\" \"flat\" "
                             "Material \"diffuse\" \"texture reflectance\" \"t\""),
            "2:31: 'mapping' is 'flat', expected uv, planar, spherical or cylindrical");
  EXPECT_EQ(
      pbrt_world_error("Texture \"t\" \"spectrum\" \"directionmix\" \"vector3 dir\" [ 0 0 0 ] "
                       "Material \"diffuse\" \"texture reflectance\" \"t\""),
      "2:24: \"dir\" is no direction");
}

TEST(Errors_PbrtTextures, NamesThatAreNotThere) {
  EXPECT_EQ(pbrt_world_error("Texture \"wood\" \"spectrum\" \"constant\"\nMaterial \"diffuse\" "
                             "\"texture reflectance\" \"wodo\""),
            "3:20: there is no spectrum texture 'wodo', did you mean 'wood'?");
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"t\"\nMaterial "
                             "\"diffuse\" \"texture reflectance\" \"t\""),
            "2:32: textures are made of each other more than 64 deep: 't' perhaps of itself");
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"flaot\" \"constant\""),
            "2:13: Texture: found 'flaot', expected float or spectrum");
  EXPECT_EQ(pbrt_world_error(
                "Texture \"t\" \"float\" \"constant\"\nTexture \"t\" \"float\" \"constant\""),
            "3:1: the float texture 't' is defined twice");
}

}  // namespace
}  // namespace candela
