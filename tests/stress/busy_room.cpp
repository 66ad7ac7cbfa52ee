#include "tests/stress/busy_room.h"

namespace candela::test {

description::SceneDescription busy_room() {
  description::SceneDescription scene = small_room();
  description::ConductorMaterial metal;
  metal.roughness.factor = 0.3;
  const description::MeshHandle ball =
      add_mesh(scene, sphere({0, 0, 0}, 0.25, 3), add_material(scene, metal),
               {Mat3d(1.0), {-0.25, 0.375, -0.25}});
  add_instance(scene, ball, {Mat3d(1.5), {0.5, -0.5, 0.25}});
  scene.instances.back().material_override = add_material(scene, description::DielectricMaterial{});
  add_instance(scene, ball, {Mat3d(0.5), {-0.75, -0.5, 0.5}});
  add_instance(scene, ball, {Mat3d(0.5), {0.75, 0.5, -0.5}});
  add_light(scene, description::PointLight{{0.5, 0.25, 1.5}, {1, 0.5, 0.25}});
  add_light(scene, description::SpotLight{{-0.5, 0.5, 2}, {0, -0.6, -0.8}, Vec3d(4.0), 0.25, 0.5});
  add_light(scene, description::DirectionalLight{normalize(Vec3d(0.25, 0.5, 1)), Vec3d(0.25)});
  add_light(scene, description::ConstantEnvironment{{0.25, 0.3, 0.5}, true});
  scene.cameras[0].lens_radius = 0.03125;
  return scene;
}

}  // namespace candela::test
