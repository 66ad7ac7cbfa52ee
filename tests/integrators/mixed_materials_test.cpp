// Mixtures of materials: each hit sees one part, so that what arrives is the parts' light in the
// mixture's proportions.
#include <gtest/gtest.h>

#include "renderer/bsdf/bsdf.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::CheckerboardTexture;
using description::MaterialHandle;
using description::MixMaterial;
using description::SceneDescription;

MaterialHandle add_mix(SceneDescription& scene, MaterialHandle first, MaterialHandle second,
                       double amount) {
  return add_material(scene, MixMaterial{first, second, {amount, {}, 0}});
}

// Of a wall that a sky of radiance 1 surrounds, its surface being what `material` makes of it.
template <class MakeMaterial>
SceneDescription wall_in_white(const MakeMaterial& make) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), make(scene));
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, {0, 0, 100}, {0, 0, 0}, 0.01);
  return scene;
}

statistics::Moments green_of(const Image& image) {
  statistics::Moments moments;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) moments.add(double{image.pixel(x, y)[1]});
  return moments;
}

// Amounts above, below and within each other; each number of a choice is used again for the next.
TEST(Statistical_MixedMaterials, ShowTheMeanOfTheirParts) {
  const auto nested = [](SceneDescription& scene) {
    const MaterialHandle dark = add_material(scene, diffuse(Vec3d(0.1)));
    const MaterialHandle light = add_material(scene, diffuse(Vec3d(0.9)));
    const MaterialHandle mirror = add_material(scene, description::MirrorMaterial{});
    const MaterialHandle inner = add_mix(scene, dark, light, 0.3);
    return add_mix(scene, inner, mirror, 0.2);
  };
  const statistics::Moments found =
      green_of(rendered(wall_in_white(nested), settings_of(32, 64)).film.to_image(false));
  const double expected = 0.2 * 1 + 0.8 * (0.7 * 0.1 + 0.3 * 0.9);
  EXPECT_GT(found.p_value(expected), 1e-3) << found.mean() << ", expected " << expected;
  EXPECT_LT(found.standard_error(), 2e-3);
}

// Light of one bounce is linear in the surface: under a lamp, by its samples and by the surface's.
TEST(Statistical_MixedMaterials, ReflectALampAsTheirPartsDo) {
  const auto with_wall = [](const auto& make) {
    SceneDescription scene = empty_scene();
    add_mesh(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), make(scene));
    add_mesh(scene, quad({-0.5, 0.5, 1}, {0, 0.5, 0}, {1, 0, 0.5}),
             add_material(scene, diffuse(Vec3d(0.0)), Vec3d(5.0)));
    set_camera(scene, {0, 0, 3}, {0, 0, 0}, 30);
    return scene;
  };
  const auto metal = [](SceneDescription& scene) {
    description::ConductorMaterial m;
    m.roughness.factor = 0.3;
    return add_material(scene, m);
  };
  const auto white = [](SceneDescription& scene) {
    return add_material(scene, diffuse(Vec3d(0.8)));
  };
  const auto both = [&](SceneDescription& scene) {
    const MaterialHandle first = metal(scene);
    return add_mix(scene, first, white(scene), 0.25);
  };
  statistics::Moments difference;  // of whole pictures
  for (std::uint64_t seed = 1; seed <= 48; ++seed) {
    const auto mean = [&](const SceneDescription& scene, std::uint64_t stream) {
      RenderSettings settings = settings_of(12, 16, 3 * seed + stream);
      settings.options.max_depth = 1;
      return mean_of(rendered(scene, settings).film.to_image(false));
    };
    difference.add(mean(with_wall(both), 0) - 0.75 * mean(with_wall(metal), 1) -
                   0.25 * mean(with_wall(white), 2));
  }
  EXPECT_GT(difference.p_value(0), 1e-3) << difference.mean();
  EXPECT_LT(difference.standard_error(), 3e-3);
}

// Where the amount is 0 or 1 nothing is left to chance, and no other number of a path is moved.
TEST(Unit_MixedMaterials, ByAPatternOfNothingAndAllAreThePattern) {
  const auto checks = [](SceneDescription& scene, Vec3d even, Vec3d odd) {
    CheckerboardTexture board;
    board.mapping.scale = Vec2d(7.0);
    board.even.factor = even;
    board.odd.factor = odd;
    scene.textures.push_back({"checks", {}, board});
    return description::TextureHandle(scene.textures.size() - 1);
  };
  const auto room_with = [](const auto& make) {
    SceneDescription scene = small_room();
    add_mesh(scene, quad({-1, -0.9, -0.9}, {2, 0, 0}, {0, 0.5, -0.05}), make(scene));
    return scene;
  };
  const SceneDescription mixed = room_with([&](SceneDescription& scene) {
    const MaterialHandle grey = add_material(scene, diffuse(Vec3d(0.25)));
    const MaterialHandle white = add_material(scene, diffuse(Vec3d(0.75)));
    MixMaterial mix{grey, white, {}};
    mix.amount.texture = checks(scene, Vec3d(0.0), Vec3d(1.0));
    return add_material(scene, mix);
  });
  const SceneDescription textured = room_with([&](SceneDescription& scene) {
    description::DiffuseMaterial material;
    material.reflectance.texture = checks(scene, Vec3d(0.25), Vec3d(0.75));
    return add_material(scene, material);
  });
  const RenderSettings settings = settings_of(24, 16);
  EXPECT_EQ(rendered(mixed, settings).film.to_image(false).values,
            rendered(textured, settings).film.to_image(false).values);
}

SceneDescription room_with_a_mixed_ball() {
  SceneDescription scene = small_room();
  const MaterialHandle mirror = add_material(scene, description::MirrorMaterial{});
  const MaterialHandle white = add_material(scene, diffuse(Vec3d(0.7)));
  add_mesh(scene, sphere({0.3, -0.2, 0.1}, 0.4, 3), add_mix(scene, mirror, white, 0.4));
  return scene;
}

TEST(Unit_MixedMaterials, SameBitsForAnyThreadsAndTiles) {
  const SceneDescription scene = room_with_a_mixed_ball();
  RenderSettings settings = settings_of(24, 16);
  settings.threads = 1;
  const Image one = rendered(scene, settings).film.to_image(false);
  settings.threads = 3;
  settings.options.tile_size = 7;
  EXPECT_EQ(rendered(scene, settings).film.to_image(false).values, one.values);
}

TEST(Unit_MixedMaterials, AreTheSameByBothAccelerators) {
  const SceneDescription scene = room_with_a_mixed_ball();
  RenderSettings settings = settings_of(24, 16);
  settings.accelerator = AcceleratorKind::Embree;
  const Image embree = rendered(scene, settings).film.to_image(false);
  settings.accelerator = AcceleratorKind::Bvh;
  const Image bvh = rendered(scene, settings).film.to_image(false);
  int different = 0;
  for (std::size_t i = 0; i < embree.values.size(); ++i)
    different += std::abs(embree.values[i] - bvh.values[i]) > 1e-3f * embree.values[i] ? 1 : 0;
  EXPECT_LE(different, 30) << "of 1728: no more than a few paths end elsewhere by rounding";
}

TEST(Unit_MixedMaterials, CountAsAllTheirPartsTogether) {
  SceneDescription scene = wall_in_white([](SceneDescription& s) {
    const MaterialHandle metal = add_material(s, description::ConductorMaterial{});
    const MaterialHandle white = add_material(s, diffuse(Vec3d(0.7)));
    return add_mix(s, metal, white, 0.4);
  });
  const Scene compiled_scene = compiled(scene, {});
  EXPECT_TRUE(compiled_scene.features.mixes);
  EXPECT_EQ(compiled_scene.features.bsdf_models,
            model_bit(BsdfModel::Conductor) | model_bit(BsdfModel::Diffuse));
}

}  // namespace
}  // namespace candela
