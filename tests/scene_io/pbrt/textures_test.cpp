// Textures of pbrt scenes as the reader leaves them.
#include <algorithm>

#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::expect_near;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

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
  EXPECT_EQ(material.opacity.channel, alpha_or_mean);
}

// A float texture is one number wherever it stands.
TEST(Unit_PbrtTextures, FloatImagesAreNumbers) {
  const auto scene = pbrt_world(R"(
    Texture "map" "float" "imagemap" "string filename" "picture.png"
    Texture "twice" "float" "imagemap" "string filename" "picture.png" "float scale" 2
    Texture "both" "spectrum" "mix" "texture amount" "map"
    Material "coateddiffuse" "texture reflectance" "both" "texture roughness" "map"
      "texture displacement" "twice" "bool remaproughness" false
    Shape "disk")");
  const auto& material = scene.materials.at(0);
  const auto& coated = std::get<CoatedDiffuseMaterial>(material.model);
  EXPECT_EQ(coated.coat.roughness.channel, alpha_or_mean);
  EXPECT_TRUE(coated.coat.roughness.map);
  const auto is_scalar = [&](TextureHandle handle) {
    return std::get<ImageTexture>(scene.textures.at(handle.index).kind).is_scalar;
  };
  EXPECT_TRUE(is_scalar(material.height_texture));
  const auto& mix = std::get<MixTexture>(scene.textures.at(coated.reflectance.texture.index).kind);
  EXPECT_TRUE(is_scalar(mix.amount.texture));
}

// A number scales what an image holds, as in pbrt, and so comes before inverting and clamping; what
// "tex1" and "tex2" name is multiplied.
TEST(Unit_PbrtTextures, NumbersScaleImages) {
  const auto scene = pbrt_world(R"(
    Texture "dark" "spectrum" "imagemap" "string filename" "picture.png" "bool invert" true
      "float scale" 2
    Texture "half" "spectrum" "scale" "texture tex" "dark" "float scale" .25
    Texture "plain" "spectrum" "imagemap" "string filename" "picture.png"
    Texture "third" "spectrum" "scale" "texture tex" "plain" "float scale" .3
    Texture "product" "spectrum" "scale" "texture tex1" "plain" "rgb tex2" [ .3 .3 .3 ]
    Texture "both" "spectrum" "mix" "texture tex1" "half" "texture tex2" "third"
    Texture "all" "spectrum" "mix" "texture tex1" "both" "texture tex2" "product"
    Texture "number" "float" "imagemap" "string filename" "picture.png"
    Texture "width" "float" "scale" "float tex" .5 "texture scale" "number"
    Material "conductor" "texture reflectance" "all" "texture roughness" "width"
    Shape "disk")");
  const auto texture = [&](const ColourInput& input) {
    return scene.textures.at(input.texture.index).kind;
  };
  const auto& metal = std::get<ConductorMaterial>(scene.materials.at(0).model);
  const auto all = std::get<MixTexture>(texture(*metal.reflectance));
  const auto both = std::get<MixTexture>(texture(all.first));
  const auto half = std::get<ImageTexture>(texture(both.first));
  EXPECT_EQ(half.factor, 0.5);
  EXPECT_TRUE(half.is_inverted);
  EXPECT_EQ(std::get<ImageTexture>(texture(both.second)).factor, 0.3);
  EXPECT_TRUE(std::holds_alternative<ProductTexture>(texture(all.second)));
  const auto is_half_of_a_number = [](const Texture& made) {
    const auto* image = std::get_if<ImageTexture>(&made.kind);
    return image && image->is_scalar && image->factor == 0.5;
  };
  EXPECT_EQ(std::ranges::count_if(scene.textures, is_half_of_a_number), 1);
}

TEST(Unit_PbrtTextures, UnusedOnesMayScaleUsedOnes) {
  const auto scene = pbrt_world(R"(
    Texture "image" "spectrum" "imagemap" "string filename" "picture.png" "float uscale" 2
    Texture "unused" "spectrum" "scale" "texture tex" "image" "float scale" .5
    Material "diffuse" "texture reflectance" "image"
    Shape "disk")");
  EXPECT_EQ(scene.textures.size(), 1u);
}

TEST(Unit_PbrtTextures, ByPlaceAndByNormal) {
  const auto scene = pbrt_world(R"(
    AttributeBegin
    Translate 5 0 0
    Scale 2 2 2
    Texture "flat" "spectrum" "checkerboard" "string mapping" "planar" "vector3 v1" [ 0 0 3 ]
      "float udelta" .5
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
      "2:24: \"dir\" is [0, 0, 0], expected a direction");
}

// Each mapping has its own.
TEST(Errors_PbrtTextures, ParametersOfOtherMappings) {
  const auto warning = [](const std::string& parameters) {
    return pbrt_world_warning("Texture \"t\" \"spectrum\" \"checkerboard\" " + parameters +
                              " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"disk\"");
  };
  const auto expect_told = [&](const std::string& parameters, const std::string& name) {
    EXPECT_NE(warning(parameters).find("'" + name + "' is not a parameter of"), std::string::npos)
        << warning(parameters);
  };
  expect_told("\"string mapping\" \"planar\" \"float uscale\" 9", "uscale");
  expect_told("\"string mapping\" \"spherical\" \"float udelta\" 9", "udelta");
  expect_told("\"vector3 v1\" [1 0 0]", "v1");
  expect_told("\"integer dimension\" 3 \"float uscale\" 9", "uscale");
}

TEST(Errors_PbrtTextures, NamesThatAreNotThere) {
  EXPECT_EQ(pbrt_world_error("Texture \"wood\" \"spectrum\" \"constant\"\nMaterial \"diffuse\" "
                             "\"texture reflectance\" \"wodo\""),
            "3:20: there is no spectrum texture 'wodo', did you mean 'wood'?");
  EXPECT_EQ(pbrt_world_error("Texture \"wood\" \"float\" \"constant\"\nMaterial \"diffuse\" "
                             "\"texture reflectance\" \"wood\""),
            "3:20: there is no spectrum texture 'wood'; the texture of this name is a float one");
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"t\"\nMaterial "
                             "\"diffuse\" \"texture reflectance\" \"t\""),
            "2:32: textures are made of each other more than 64 deep: 't' perhaps of itself");
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"flaot\" \"constant\""),
            "2:13: Texture: found 'flaot', expected float or spectrum");
  EXPECT_EQ(pbrt_world_error(
                "Texture \"t\" \"float\" \"constant\"\nTexture \"t\" \"float\" \"constant\""),
            "3:1: the float texture 't' is defined twice");
}

// Nothing of them comes to the scene.
TEST(Unit_PbrtTextures, UnusedOnesAreChecked) {
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"spectrum\" \"cnstant\""),
            "2:24: 'cnstant' is no texture, did you mean 'constant'?");
  EXPECT_EQ(test::pbrt_world_warning("Texture \"t\" \"float\" \"constant\" \"float valeu\" 1"),
            "2:32: 'valeu' is not a parameter of Texture \"constant\" and is ignored, did you mean "
            "'value'?");
  const auto scene = pbrt_world(
      "Texture \"a\" \"spectrum\" \"imagemap\" \"string filename\" \"not there.png\"\n"
      "Texture \"b\" \"spectrum\" \"scale\" \"texture tex\" \"a\" \"float scale\" .5");
  EXPECT_TRUE(scene.images.empty());
  EXPECT_TRUE(scene.textures.empty());
}

TEST(Errors_PbrtTextures, CheckerboardsHaveTwoOrThreeDimensions) {
  EXPECT_EQ(pbrt_world_error("Texture \"t\" \"spectrum\" \"checkerboard\" \"integer dimension\" 4 "
                             "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"disk\""),
            "2:39: 'dimension' is 4, expected 2 or 3");
}

// pbrt-v3's flag: what is stored is light already.
TEST(Unit_PbrtTextures, WithoutGammaTexelsAreLinear) {
  const auto encoding_of = [](const std::string& parameters) {
    const auto scene = pbrt_world(
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"picture.png\" " +
        parameters + " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"disk\"");
    return scene.images.at(0).encoding;
  };
  EXPECT_EQ(encoding_of("\"bool gamma\" false"), Encoding::Linear);
  EXPECT_EQ(encoding_of("\"string encoding\" \"gamma 2.2\""), Encoding::Gamma22);
  EXPECT_EQ(encoding_of("\"string encoding\" \"gamma 2.2\" \"string decode\" \"lab3\""),
            Encoding::LabGamma);
  EXPECT_EQ(encoding_of("\"bool gamma\" true"), Encoding::Srgb);
  EXPECT_EQ(encoding_of("\"float gamma\" 2.2"), Encoding::Srgb);
}

// pbrt-v2's was an exponent.
TEST(Errors_PbrtTextures, AGammaThatIsNoFlagIsToldOf) {
  const auto scene = test::parse_pbrt_text(
      "WorldBegin\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"picture.png\" "
      "\"float gamma\" 2.2\nMaterial \"diffuse\" \"texture reflectance\" \"t\"\nShape \"disk\"");
  ASSERT_EQ(scene.diagnostics.warning_count(), 1u);
  EXPECT_EQ(scene.diagnostics.list().at(0).message, "'gamma' is no bool and is ignored");
}

std::vector<Diagnostic> said_of_filter(const std::string& parameters) {
  const std::string map = "\"spectrum\" \"imagemap\" \"string filename\" \"picture.png\" ";
  const auto scene = test::parse_pbrt_text(
      "WorldBegin\nTexture \"a\" " + map + parameters + "\nTexture \"b\" " + map + parameters +
      "\nMaterial \"diffuse\" \"texture reflectance\" \"a\"\nShape \"disk\"" +
      "\nMaterial \"diffuse\" \"texture reflectance\" \"b\"\nShape \"disk\"");
  EXPECT_TRUE(scene);
  return scene.diagnostics.list();
}

// Once a scene, and no warning: pictures differ by what more samples take away.
TEST(Unit_PbrtTextures, OtherFiltersAreNamedByANote) {
  for (const char* filter : {"\"string filter\" \"trilinear\"", "\"string filter\" \"EWA\"",
                             "\"string filter\" \"point\"", "\"bool trilinear\" true"}) {
    const auto said = said_of_filter(filter);
    ASSERT_EQ(said.size(), 1u) << filter;
    EXPECT_EQ(said[0].severity, Severity::Note);
    EXPECT_EQ(said[0].span.line, 2u);
    EXPECT_EQ(said[0].message,
              "images are looked up bilinearly, whatever \"filter\" they name: a pixel's samples "
              "average them over its footprint");
  }
  EXPECT_TRUE(said_of_filter("").empty());
  EXPECT_TRUE(said_of_filter("\"string filter\" \"bilinear\"").empty());
  const auto unknown = said_of_filter("\"string filter\" \"cubic\"");
  ASSERT_EQ(unknown.size(), 2u);
  EXPECT_EQ(unknown[0].severity, Severity::Warning);
}

}  // namespace
}  // namespace candela
