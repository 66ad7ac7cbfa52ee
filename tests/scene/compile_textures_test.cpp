// Textures that are made of others: what they show, what compiling makes of them, what is refused.
#include "renderer/scene/compile_textures.h"

#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "renderer/scene/compile.h"
#include "tests/image/crafted_files.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using description::ColourInput;
using description::ImageTexture;
using description::SceneDescription;
using description::UvMapping;

// Textures and one picture: 4 x 4, red grows with the column, green with the row.
class Textures {
 public:
  Textures() {
    const std::string path = folder_.put(
        "map.png", crafted::png_rgba(4, 4, [](int x, int y, int c) {
          return static_cast<unsigned>(c == 0 ? 60 * x : c == 1 ? 60 * y : c == 2 ? 51 : 255);
        }));
    scene.images.push_back({path, description::Encoding::Linear, description::Wrap::Repeat, {}});
  }

  template <class Kind>
  description::TextureHandle add(Kind kind) {
    scene.textures.push_back({"texture" + std::to_string(scene.textures.size()), {}, kind});
    return description::TextureHandle(scene.textures.size() - 1);
  }
  TextureValue compiled(description::TextureHandle texture) {
    return TextureCompiler(scene, store, diagnostics).texture(texture);
  }
  Vec4f at(const TextureValue& value, Vec2f uv) const {
    return value.texture ? store.lookup(value.texture, uv) : value.constant;
  }

  SceneDescription scene;
  TextureStore store;
  Diagnostics diagnostics;

 private:
  TemporaryFolder folder_;
};

constexpr Vec2f places[] = {{0.1f, 0.2f}, {0.6f, 0.9f}, {-3.3f, 7.45f}, {0, 0}, {12.5f, -0.75f}};

ColourInput constant(double x) {
  return {Vec3d(x), {}, {}};
}
ColourInput by(description::TextureHandle texture) {
  return {Vec3d(1.0), {}, texture};
}

TEST(Unit_Procedural, PlainImagesStayImages) {
  Textures t;
  const TextureValue plain = t.compiled(t.add(ImageTexture{description::ImageHandle(0u)}));
  ASSERT_TRUE(plain.texture);
  EXPECT_TRUE(t.store.is_image(plain.texture));
  EXPECT_EQ(t.store.size(), 1u);
}

// As pbrt's: before others have their part of them; numbers may be any.
TEST(Unit_Procedural, ColoursOfImagesEndAtOne) {
  Textures t;
  t.scene.images.push_back(
      light_test::write_float_map("two", 2, 2, [](int, int) { return Vec3f(2, 0.5f, -0.5f); }));
  const description::ImageHandle two(1u);
  const auto half_of = [&](const ColourInput& input) {
    const auto mix = t.add(description::MixTexture{input, constant(0), constant(0.5)});
    return Vec3f(t.at(t.compiled(mix), Vec2f(0.3f)));
  };
  EXPECT_EQ(half_of({Vec3d(1.0), two, {}}), Vec3f(0.5f, 0.25f, 0));
  EXPECT_EQ(half_of(by(t.add(ImageTexture{two}))), Vec3f(0.5f, 0.25f, 0));
  EXPECT_EQ(half_of(by(t.add(ImageTexture{two, {}, 3}))), Vec3f(0.5f, 0.5f, 0));
  EXPECT_EQ(half_of(by(t.add(ImageTexture{two, {}, 0.25}))), Vec3f(0.25f, 0.0625f, 0));
  const float number = half_of(by(t.add(ImageTexture{two, {}, 3, false, true}))).x;
  EXPECT_NEAR(number, 0.5f * 3 * (2.0f / 3), 1e-6f);
}

// pbrt's: alpha where it says something, else the mean of the colours; what is grey stays an image.
TEST(Unit_Procedural, ImagesAsNumbersAreAlphaOrTheMean) {
  Textures t;
  const TemporaryFolder folder;
  const auto add_image = [&](const std::string& name, auto&& sample) {
    const std::string path = folder.put(name, crafted::png_rgba(4, 4, sample));
    t.scene.images.push_back({path, description::Encoding::Srgb, description::Wrap::Repeat, {}});
    return description::ImageHandle(t.scene.images.size() - 1);
  };
  const auto grey = add_image(
      "grey.png", [](int x, int, int c) { return static_cast<unsigned>(c < 3 ? 60 * x : 255); });
  const auto leaf = add_image("leaf.png", [](int x, int y, int c) {
    return static_cast<unsigned>(c < 3 ? 9 * c : 20 * (x + y));
  });
  const description::ImageHandle coloured(0u);
  TextureCompiler compiler(t.scene, t.store, t.diagnostics);
  const auto number_at = [&](const TextureCompiler::Scalar& scalar, Vec2f uv) {
    return t.store.lookup(scalar.texture, uv)[scalar.channel];
  };
  const auto of_grey = compiler.scalar(grey);
  const auto of_leaf = compiler.scalar(leaf);
  const auto mean = compiler.scalar(coloured);
  EXPECT_TRUE(t.store.is_image(of_grey.texture));
  EXPECT_EQ(of_grey.channel, 0);
  EXPECT_TRUE(t.store.is_image(of_leaf.texture));
  EXPECT_EQ(of_leaf.channel, 3);
  EXPECT_EQ(compiler.scalar(coloured).texture, mean.texture);
  for (const Vec2f uv : places) {
    const Vec4f colour = t.store.lookup(compiler.image(coloured), uv);
    EXPECT_FLOAT_EQ(number_at(mean, uv), (colour.x + colour.y + colour.z) / 3);
    EXPECT_EQ(number_at(of_leaf, uv), t.store.lookup_alpha_at(of_leaf.texture, {.uv = uv}));
  }
  // The same as inputs of other textures, in all channels.
  for (const auto& [image, scalar] :
       {std::pair(grey, of_grey), {leaf, of_leaf}, {coloured, mean}}) {
    const TextureValue twice = t.compiled(t.add(ImageTexture{image, {}, 2, false, true}));
    const TextureValue once = t.compiled(t.add(ImageTexture{image, {}, 1, false, true}));
    for (const Vec2f uv : places) {
      EXPECT_FLOAT_EQ(t.at(twice, uv).x, 2 * number_at(scalar, uv));
      EXPECT_EQ(t.at(twice, uv).y, t.at(twice, uv).x);
      EXPECT_FLOAT_EQ(t.at(once, uv).z, number_at(scalar, uv));
    }
  }
}

TEST(Unit_Procedural, ImagesAreMovedScaledAndInverted) {
  Textures t;
  const description::ImageHandle image(0u);
  const UvMapping mapping{{2, -3}, {0.25, 0.5}};
  const TextureValue plain = t.compiled(t.add(ImageTexture{image}));
  const TextureValue moved = t.compiled(t.add(ImageTexture{image, mapping, 3, false}));
  const TextureValue inverted = t.compiled(t.add(ImageTexture{image, {}, 1.5, true}));
  for (const Vec2f uv : places) {
    const Vec4f there = t.at(plain, {2 * uv.x + 0.25f, -3 * uv.y + 0.5f});
    EXPECT_LT(length(t.at(moved, uv) - Vec4f(glm::min(Vec3f(there) * 3.0f, Vec3f(1)), there.w)),
              1e-5f);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(t.at(inverted, uv)[c], std::max(0.0f, 1 - 1.5f * t.at(plain, uv)[c]), 1e-6);
  }
  EXPECT_GE(t.store.info(moved.texture).width, 8);  // twice as fine
}

TEST(Unit_Procedural, ProductsAndMixtures) {
  Textures t;
  const auto image = t.add(ImageTexture{description::ImageHandle(0u)});
  const auto inner = t.add(description::ProductTexture{by(image), {Vec3d(0.5, 2, 1), {}, {}}});
  const auto outer = t.add(description::MixTexture{by(inner), constant(0.8), by(image)});
  const TextureValue plain = t.compiled(image);
  const TextureValue mixed = t.compiled(outer);
  for (const Vec2f uv : places) {
    const Vec3f texel(t.at(plain, uv));
    const Vec3f product = texel * Vec3f(0.5f, 2, 1);
    EXPECT_LT(length(Vec3f(t.at(mixed, uv)) - (product * (1.0f - texel) + 0.8f * texel)), 1e-6f);
  }
}

TEST(Unit_Procedural, WhatIsConstantBecomesAConstant) {
  Textures t;
  const auto product = t.add(description::ProductTexture{constant(0.5), constant(0.25)});
  const TextureValue mixed =
      t.compiled(t.add(description::MixTexture{by(product), constant(1), constant(0.5)}));
  EXPECT_FALSE(mixed.texture);
  EXPECT_EQ(Vec3f(mixed.constant), Vec3f(0.5625f));
  EXPECT_EQ(t.store.size(), 0u);
}

TEST(Unit_Procedural, CheckerboardsBeginWithEven) {
  Textures t;
  const TextureValue board = t.compiled(
      t.add(description::CheckerboardTexture{{{4, 2}, {0, 0}}, constant(0.9), constant(0.1)}));
  for (int i = -9; i < 9; ++i)
    for (int j = -9; j < 9; ++j) {
      const Vec2f uv{(static_cast<float>(i) + 0.3f) / 4, (static_cast<float>(j) + 0.7f) / 2};
      EXPECT_EQ(t.at(board, uv).x, (i + j) % 2 == 0 ? 0.9f : 0.1f) << i << ' ' << j;
    }
  const float inf = infinity;
  EXPECT_EQ(t.at(board, {inf, -inf}).x, 0.9f);
  EXPECT_GT(t.at(board, {3e38f, 1e30f}).x, 0);
}

TEST(Unit_Procedural, DotsStayWithinTheirCells) {
  Textures t;
  const TextureValue dots =
      t.compiled(t.add(description::DotsTexture{{}, constant(1), constant(0)}));
  double covered = 0;
  constexpr int cells = 64, fine = 20;
  for (int i = 0; i < cells * fine; ++i)
    for (int j = 0; j < cells * fine; ++j) {
      const Vec2f uv{(static_cast<float>(i) + 0.5f) / fine, (static_cast<float>(j) + 0.5f) / fine};
      covered += double{t.at(dots, uv).x};
      // Cells end halfway between whole numbers.
      const float edge = static_cast<float>(i % cells) + 0.5f;
      ASSERT_EQ(t.at(dots, {edge, uv.y}).x, 0);
      ASSERT_EQ(t.at(dots, {uv.x, edge}).x, 0);
    }
  // Half of 4225 cells have a dot, more or less, of the area 0.385.
  EXPECT_NEAR(covered / (cells * cells * fine * fine), 0.5 * pi_double * 0.35 * 0.35, 0.02);
}

TEST(Unit_Procedural, BilinearMeetsItsCorners) {
  Textures t;
  description::BilinearTexture corners;
  corners.v00 = Vec3d(0.1);
  corners.v01 = Vec3d(0.2);
  corners.v10 = Vec3d(0.4);
  corners.v11 = Vec3d(0.8);
  const TextureValue value = t.compiled(t.add(corners));
  EXPECT_FLOAT_EQ(t.at(value, {0, 0}).x, 0.1f);
  EXPECT_FLOAT_EQ(t.at(value, {0, 1}).x, 0.2f);
  EXPECT_FLOAT_EQ(t.at(value, {1, 0}).x, 0.4f);
  EXPECT_FLOAT_EQ(t.at(value, {1, 1}).x, 0.8f);
  EXPECT_FLOAT_EQ(t.at(value, {0.5f, 0.5f}).x, 0.375f);
}

// Through a whole compile, for every kind of input: colours, widths, heights, opacities.
TEST(Unit_Procedural, MaterialsReadThem) {
  Textures t;
  SceneDescription scene = test::small_room();
  scene.images = t.scene.images;
  scene.textures = t.scene.textures;
  description::CheckerboardTexture board{{{8, 8}, {0, 0}}, constant(0.75), constant(0.25)};
  scene.textures.push_back({"board", {}, board});
  const description::TextureHandle handle(0u);
  description::ConductorMaterial metal;
  metal.roughness.texture = handle;
  scene.materials[0].model = metal;
  scene.materials[1].model = description::DiffuseMaterial{by(handle)};
  scene.materials[2].opacity.texture = handle;
  scene.materials[2].height_texture = handle;
  const Result<Scene> compiled = compile(scene, {.width = 8, .height = 8});
  ASSERT_TRUE(compiled);
  const auto value = [&](TextureHandle texture, Vec2f uv) {
    return compiled->textures.lookup(texture, uv).x;
  };
  for (const TextureHandle texture :
       {compiled->materials[0].roughness.texture, compiled->materials[1].diffuse.texture,
        compiled->materials[2].opacity.texture, compiled->materials[2].height}) {
    ASSERT_TRUE(texture);
    EXPECT_EQ(value(texture, {0.05f, 0.05f}), 0.75f);
    EXPECT_EQ(value(texture, {0.15f, 0.05f}), 0.25f);
  }
  EXPECT_TRUE(std::ranges::any_of(compiled->geometries, &Geometry::has_cutouts));
  const Image image = test::rendered(*compiled, test::settings_of(8, 4)).film.to_image(false);
  EXPECT_GT(test::mean_of(image), 0);
}

// A texture that is the same everywhere is held to what others are, and means what a number does.
TEST(Unit_Procedural, ConstantsOfTexturesAreClamped) {
  SceneDescription scene = test::small_room();
  for (const double factor : {0.75, 8.0, -8.0})
    scene.textures.push_back(
        {"product", {}, description::ProductTexture{constant(0.5), constant(factor)}});
  const auto compiled_with = [&](const auto& model) {
    scene.materials[0].model = model;
    return compile(scene, {.width = 8, .height = 8})->materials[0];
  };
  constexpr float expected[] = {0.375f, 1, 0};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const ColourInput input = by(description::TextureHandle(i));
    EXPECT_EQ(compiled_with(description::DiffuseMaterial{input}).diffuse.constant,
              Rgb(expected[i]));
    description::CookTorranceMaterial rough;
    rough.roughness.texture = input.texture;
    EXPECT_EQ(compiled_with(rough).roughness.constant, expected[i]);
    description::ConductorMaterial metal;
    metal.reflectance = input;
    const Material by_texture = compiled_with(metal);
    metal.reflectance = constant(expected[i]);
    const Material by_number = compiled_with(metal);
    EXPECT_EQ(by_texture.k, by_number.k);
    EXPECT_EQ(by_texture.f0, by_number.f0);
  }
}

std::string error_of(const SceneDescription& scene) {
  const Diagnostics found = description::validate(scene);
  return found.has_errors() ? found.list().front().message : "";
}

TEST(Errors_Procedural, InputsStandBeforeAndAreThere) {
  SceneDescription scene = test::small_room();
  scene.textures.push_back(
      {"self", {}, description::ProductTexture{by(description::TextureHandle(0u)), constant(1)}});
  EXPECT_EQ(error_of(scene), "texture 'self': a texture that it uses does not stand before it");
  scene.textures[0].kind = ImageTexture{description::ImageHandle(7u)};
  EXPECT_EQ(error_of(scene), "texture 'self': its image does not exist");
  scene.textures[0].kind = description::BilinearTexture{{{1, 1}, {0, 0}}, Vec3d(INFINITY)};
  EXPECT_EQ(error_of(scene), "texture 'self': a value is not finite");
  description::ProductTexture both;
  both.first.map = description::ImageHandle(0u);
  both.first.texture = description::TextureHandle(0u);
  scene.images.push_back({"map.png", description::Encoding::Linear, description::Wrap::Repeat, {}});
  scene.textures.push_back({"both", {}, both});
  scene.textures[0].kind = description::CheckerboardTexture{};
  EXPECT_EQ(error_of(scene), "texture 'both': an input has a map and a texture");
  scene.textures.clear();
  scene.materials[0].model = description::DiffuseMaterial{by(description::TextureHandle(3u))};
  EXPECT_NE(error_of(scene).find("the texture of the reflectance does not exist"),
            std::string::npos);
}

// 2^40 lookups from forty lines, and a chain as long as the stack.
TEST(Errors_Procedural, TexturesThatRunAway) {
  SceneDescription scene = test::small_room();
  scene.textures.push_back({"0", {}, description::CheckerboardTexture{}});
  for (std::size_t i = 1; i < 40; ++i) {
    const ColourInput before = by(description::TextureHandle(i - 1));
    scene.textures.push_back({std::to_string(i), {}, description::ProductTexture{before, before}});
  }
  EXPECT_NE(error_of(scene).find("is made of more than 1024 others"), std::string::npos);
  scene.textures.resize(1);
  for (std::size_t i = 1; i < 80; ++i)
    scene.textures.push_back(
        {std::to_string(i),
         {},
         description::ProductTexture{by(description::TextureHandle(i - 1)), constant(1)}});
  EXPECT_NE(error_of(scene).find("nested deeper than 64"), std::string::npos);
}

}  // namespace
}  // namespace candela
