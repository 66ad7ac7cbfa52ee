// Media in the files that are written.
#include <gtest/gtest.h>

#include "scene_io/pbrt/write/write_pbrt.h"
#include "tests/scene_io/pbrt/write/round_trip.h"
#include "tests/scenes/description.h"

namespace candela::pbrt {
namespace {

using namespace description;

TEST(Unit_WriteMedia, SurfacesAndTheCameraKeepThem) {
  SceneDescription scene = test::empty_scene();
  test::set_camera(scene, {0, 0, 5}, {0, 0, 0});
  const auto fog = test::add_medium(scene, Vec3d(0.1, 0, 20), Vec3d(1, 2.5, 1e-7), -0.3);
  const auto smoke = test::add_medium(scene, Vec3d(1), Vec3d(0));
  scene.cameras[0].medium = fog;
  const MediumInterface sides[] = {{smoke, fog}, {fog, {}}, {{}, {}}, {{}, smoke}};
  for (const MediumInterface& media : sides) {
    const auto material = test::add_material(scene, InterfaceMaterial{});
    scene.materials[material.index].media = media;
    test::add_mesh(scene, test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
  }
  const test::RoundTrip trip = test::round_trip(scene);
  EXPECT_TRUE(trip.diagnostics.list().empty());
  const SceneDescription& back = trip.scene;
  ASSERT_EQ(back.media.size(), 2u);
  const auto name_of = [](const SceneDescription& s, MediumHandle medium) {
    return medium ? s.media[medium.index].name : "";
  };
  for (const Medium& medium : scene.media)
    for (const Medium& read : back.media) {
      if (read.name != medium.name) continue;
      EXPECT_EQ(read.absorption, medium.absorption);
      EXPECT_EQ(read.scattering, medium.scattering);
      EXPECT_EQ(read.asymmetry, medium.asymmetry);
    }
  EXPECT_EQ(name_of(back, back.cameras.at(0).medium), scene.media[fog.index].name);
  ASSERT_EQ(back.instances.size(), std::size(sides));
  for (std::size_t i = 0; i < std::size(sides); ++i) {
    const Instance& instance = back.instances[i];
    const MaterialHandle material = instance.material_override
                                        ? instance.material_override
                                        : back.meshes[instance.mesh.index].materials[0];
    const MediumInterface& read = back.materials[material.index].media;
    EXPECT_EQ(name_of(back, read.inside), name_of(scene, sides[i].inside)) << i;
    EXPECT_EQ(name_of(back, read.outside), name_of(scene, sides[i].outside)) << i;
  }
  EXPECT_NE(trip.written.text.find("Integrator \"volpath\""), std::string::npos);
}

}  // namespace
}  // namespace candela::pbrt
