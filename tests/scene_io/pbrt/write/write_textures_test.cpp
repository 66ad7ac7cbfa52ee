// Textures come back as they were.
#include <gtest/gtest.h>

#include "scene_io/pbrt/write/write_pbrt.h"
#include "tests/scene_io/pbrt/write/round_trip.h"
#include "tests/scenes/description.h"

namespace candela::pbrt {
namespace {

using namespace description;
using test::RoundTrip;

const Vec3d odd(0.1, 1.0 / 3, 0.7);

// Also where the texture around them is one of colours.
TEST(Unit_WriteTextures, ImagesAsNumbersStayNumbers) {
  SceneDescription scene = test::small_room();
  scene.images = {{"a.png", Encoding::Srgb, Wrap::Clamp, {}}};
  scene.textures = {{"n", {}, ImageTexture{ImageHandle(0), {}, 1, false, true}},
                    {"m", {}, MixTexture{{odd, {}, {}}, {Vec3d(1), {}, {}}, {}}},
                    {"p", {}, ProductTexture{}}};
  const auto by = [](std::size_t i) { return ColourInput{Vec3d(1), {}, TextureHandle(i)}; };
  std::get<MixTexture>(scene.textures[1].kind).amount = by(0);
  scene.textures[2].kind = ProductTexture{by(1), by(0)};
  scene.materials[0].model = DiffuseMaterial{by(2)};
  const SceneDescription back = test::round_trip(scene).scene;
  const auto& product = std::get<ProductTexture>(back.textures.back().kind);
  const auto is_scalar = [&](const ColourInput& input) {
    return std::get<ImageTexture>(back.textures.at(input.texture.index).kind).is_scalar;
  };
  EXPECT_TRUE(is_scalar(product.second));
  const auto& mix = std::get<MixTexture>(back.textures.at(product.first.texture.index).kind);
  EXPECT_TRUE(is_scalar(mix.amount));
}

TEST(Unit_WriteTextures, OfEveryKind) {
  SceneDescription scene = test::small_room();
  scene.images = {{"a.png", Encoding::Srgb, Wrap::Clamp, {}},
                  {"b.exr", Encoding::Linear, Wrap::Mirror, {}}};
  const auto add = [&](auto kind) {
    scene.textures.push_back({"t", {}, std::move(kind)});
    ColourInput input;
    input.texture = TextureHandle(scene.textures.size() - 1);
    return input;
  };
  const UvMapping mapping{{2, 3}, {0.5, 0.25}};
  const ColourInput image = add(ImageTexture{ImageHandle(0), mapping, 0.75, true});
  ColourInput plain;
  plain.map = ImageHandle(1);
  const ColourInput product = add(ProductTexture{image, {Vec3d(1, 0.5, 0.25), {}, {}}});
  const ColourInput mixed = add(MixTexture{product, plain, {Vec3d(0.3), {}, {}}});
  const ColourInput checks = add(CheckerboardTexture{mapping, mixed, {Vec3d(0.1), {}, {}}});
  const ColourInput dots = add(DotsTexture{mapping, checks, {Vec3d(0.2), {}, {}}});
  const ColourInput corners = add(BilinearTexture{mapping, Vec3d(0), Vec3d(0.1), Vec3d(1), odd});
  const ColourInput top = add(MixTexture{dots, corners, {Vec3d(0.5), {}, {}}});
  scene.materials[0].model = DiffuseMaterial{top};
  const RoundTrip trip = test::round_trip(scene);
  const auto& back = trip.scene.textures;
  ASSERT_EQ(back.size(), 7u) << trip.written.text;
  EXPECT_EQ(trip.scene.images[0].wrap, Wrap::Clamp);
  EXPECT_EQ(trip.scene.images[0].encoding, Encoding::Srgb);
  EXPECT_EQ(trip.scene.images[1].wrap, Wrap::Mirror);
  const auto& i = std::get<ImageTexture>(back[0].kind);
  EXPECT_EQ(i.mapping.scale, Vec2d(2, 3));
  EXPECT_EQ(i.mapping.offset, Vec2d(0.5, 0.25));
  EXPECT_EQ(i.factor, 0.75);
  EXPECT_TRUE(i.is_inverted);
  EXPECT_EQ(std::get<ProductTexture>(back[1].kind).second.factor, Vec3d(1, 0.5, 0.25));
  EXPECT_EQ(std::get<MixTexture>(back[2].kind).amount.factor, Vec3d(0.3));
  EXPECT_EQ(std::get<MixTexture>(back[2].kind).second.map.index, 1u);
  EXPECT_EQ(std::get<CheckerboardTexture>(back[3].kind).odd.factor, Vec3d(0.1));
  EXPECT_EQ(std::get<DotsTexture>(back[4].kind).outside.factor, Vec3d(0.2));
  EXPECT_EQ(std::get<BilinearTexture>(back[5].kind).v11, odd);
  EXPECT_EQ(std::get<MixTexture>(back[6].kind).first.texture.index, 4u);
}

// A number would scale what the image holds and not what comes of it.
TEST(Unit_WriteTextures, ProductsOfImagesStayProducts) {
  SceneDescription scene = test::small_room();
  scene.images = {{"a.png", Encoding::Srgb, Wrap::Clamp, {}}};
  scene.textures = {{"n", {}, ImageTexture{ImageHandle(0), {}, 1, true}},
                    {"p", {}, ProductTexture{}}};
  const ColourInput image{Vec3d(1.0), {}, TextureHandle(0)};
  scene.textures[1].kind = ProductTexture{image, {Vec3d(0.5), {}, {}}};
  scene.materials[0].model = DiffuseMaterial{{Vec3d(1.0), {}, TextureHandle(1)}};
  const SceneDescription back = test::round_trip(scene).scene;
  ASSERT_EQ(back.textures.size(), 2u);
  EXPECT_EQ(std::get<ProductTexture>(back.textures[1].kind).second.factor, Vec3d(0.5));
}

// Places are found again whatever the space, and roots that pbrt does not have.
TEST(Unit_WriteTextures, ByPlaceAndByNormal) {
  SceneDescription scene = test::small_room();
  const auto add = [&](auto kind) {
    scene.textures.push_back({"t", {}, std::move(kind)});
    ColourInput input;
    input.texture = TextureHandle(scene.textures.size() - 1);
    return input;
  };
  const Transform turned{Mat3d(0, 2, 0, 0, 0, 2, 2, 0, 0), {0.5, -1, 0.25}};
  const auto mapped = [&](MappingKind kind) { return UvMapping{{1, 1}, {0, 0}, kind, turned}; };
  const ColourInput flat =
      add(CheckerboardTexture{{{3, 2}, {0.5, 0}, MappingKind::Planar, turned}});
  const ColourInput round = add(DotsTexture{mapped(MappingKind::Spherical), flat});
  const ColourInput tube = add(CheckerboardTexture{mapped(MappingKind::Cylindrical), round});
  const ColourInput cubes = add(SolidCheckerboardTexture{turned, tube});
  const ColourInput snow = add(DirectionMixTexture{cubes, flat, {0, 0, 1}});
  const ColourInput root = add(SquareRootTexture{snow});
  scene.materials[0].model = DiffuseMaterial{root};
  const RoundTrip trip = test::round_trip(scene);
  const auto& back = trip.scene.textures;
  ASSERT_EQ(back.size(), 6u) << trip.written.text;
  const auto expect_at = [](const Vec3d& found, const Vec3d& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-12);
  };
  const Vec3d p(3, 4, 5);
  const Vec3d there = turned.point(p);
  const auto& plane = std::get<CheckerboardTexture>(back[0].kind).mapping;
  EXPECT_EQ(plane.kind, MappingKind::Planar);
  const Vec3d on_plane = plane.place_from_world.point(p);
  EXPECT_NEAR(on_plane.x + plane.offset.x, there.x * 3 + 0.5, 1e-12);
  EXPECT_NEAR(on_plane.y + plane.offset.y, there.y * 2, 1e-12);
  const auto& dots = std::get<DotsTexture>(back[1].kind).mapping;
  EXPECT_EQ(dots.kind, MappingKind::Spherical);
  expect_at(dots.place_from_world.point(p), there);
  EXPECT_EQ(std::get<CheckerboardTexture>(back[2].kind).mapping.kind, MappingKind::Cylindrical);
  expect_at(std::get<SolidCheckerboardTexture>(back[3].kind).place_from_world.point(p), there);
  EXPECT_EQ(std::get<DirectionMixTexture>(back[4].kind).direction, Vec3d(0, 0, 1));
  EXPECT_EQ(std::get<SquareRootTexture>(back[5].kind).input.texture.index, 4u);
}

// Of other files than PNG pbrt knows no encoding.
TEST(Unit_WriteTextures, GammaOfAnyFileIsKept) {
  for (const char* file : {"wood.exr", "wood.png"}) {
    SceneDescription scene = test::small_room();
    scene.images = {{file, Encoding::LabGamma, Wrap::Repeat, {}}};
    scene.materials[0].model = DiffuseMaterial{{Vec3d(1.0), ImageHandle(0)}};
    const RoundTrip trip = test::round_trip(scene);
    ASSERT_EQ(trip.scene.images.size(), 1u);
    EXPECT_EQ(trip.scene.images[0].encoding, Encoding::LabGamma) << trip.written.text;
  }
}

}  // namespace
}  // namespace candela::pbrt
