#include "renderer/scene/compile_materials.h"

#include <gtest/gtest.h>

#include "renderer/math/reflectance.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

description::CoatedConductorMaterial lacquered(double roughness) {
  description::CoatedConductorMaterial metal;
  metal.roughness.factor = roughness;
  return metal;
}

// A table takes up to a tenth of a second.
TEST(Unit_CompileMaterials, EqualCoatsAndMetalsShareTheirTables) {
  description::SceneDescription scene = small_room();
  std::vector<description::CoatedConductorMaterial> metals(5, lacquered(0.3));
  metals[2].roughness.factor = 0.4;
  metals[3].k.z += 1;
  metals[4].coat.max_depth = 3;
  for (const auto& metal : metals)
    add_mesh(scene, sphere({0, 0, 0}, 0.1, 1), add_material(scene, metal));
  const Scene made = compiled(scene, settings_of(8, 1).options);
  const std::size_t first = made.materials.size() - metals.size();
  ASSERT_TRUE(made.materials[first].metal);
  for (std::size_t i = 1; i < metals.size(); ++i) {
    const Material& other = made.materials[first + i];
    EXPECT_EQ(other.coat, made.materials[first].coat) << i;
    EXPECT_EQ(other.metal == made.materials[first].metal, i == 1) << i;
  }
}

// Beyond some size squares are no numbers, and nothing is left to reflect.
TEST(Unit_CompileMaterials, MetalsOfAnyIndexReflectANumber) {
  description::SceneDescription scene = small_room();
  for (const double index : {1e20, 1e300}) {
    description::ConductorMaterial metal;
    metal.eta = metal.k = Vec3d(index);
    scene.materials[0].model = metal;
    const Scene whole = compiled(scene, settings_of(8, 1).options);
    const Material& made = whole.materials[0];
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(made.f0[c], 1, 1e-5f) << index;
      EXPECT_NEAR(normal_reflectance(made.eta, made.k)[c], 1, 1e-5f) << index;
    }
  }
}

}  // namespace
}  // namespace candela
