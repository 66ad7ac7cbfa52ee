#include "tests/scenes/description.h"

namespace candela::test {

using description::DiffuseMaterial;
using description::MaterialHandle;
using description::MeshHandle;
using description::SceneDescription;

SceneDescription empty_scene() {
  SceneDescription scene;
  scene.path = "built in code";
  return scene;
}

MeshHandle add_mesh(SceneDescription& scene, description::Mesh mesh, MaterialHandle material,
                    const Transform& object_to_world) {
  mesh.materials = {material};
  if (mesh.name.empty()) mesh.name = "mesh" + std::to_string(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  const MeshHandle handle(scene.meshes.size() - 1);
  add_instance(scene, handle, object_to_world);
  return handle;
}

description::MediumHandle add_medium(SceneDescription& scene, const Vec3d& absorption,
                                     const Vec3d& scattering, double asymmetry) {
  const std::string name = "medium" + std::to_string(scene.media.size());
  scene.media.push_back({name, {}, absorption, scattering, asymmetry});
  return description::MediumHandle(scene.media.size() - 1);
}

void add_instance(SceneDescription& scene, MeshHandle mesh, const Transform& object_to_world) {
  scene.instances.push_back({mesh, object_to_world, {}, {}});
}

void set_camera(SceneDescription& scene, const Vec3d& eye, const Vec3d& target, double fovy_degrees,
                const Vec3d& up) {
  description::Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.up = up;
  camera.fovy_degrees = fovy_degrees;
  scene.cameras = {camera};
}

SceneDescription small_room() {
  SceneDescription scene = empty_scene();
  const auto diffuse = [&](const Vec3d& colour) {
    return add_material(scene, DiffuseMaterial{{colour, {}}});
  };
  const MaterialHandle white = diffuse(Vec3d{0.75});
  const MaterialHandle red = diffuse({0.63, 0.065, 0.05});
  const MaterialHandle green = diffuse({0.14, 0.45, 0.091});
  const MaterialHandle lamp = add_material(scene, DiffuseMaterial{{Vec3d{0.0}, {}}}, {17, 12, 4});
  add_mesh(scene, quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}), white);             // floor
  add_mesh(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), white);              // ceiling
  add_mesh(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}), white);             // back
  add_mesh(scene, quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}), red);               // left
  add_mesh(scene, quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}), green);              // right
  add_mesh(scene, quad({-0.25, 0.98, -0.25}, {0.5, 0, 0}, {0, 0, 0.5}), lamp);  // shines down
  add_mesh(scene, box({-0.5, -1, -0.6}, {0.1, 0.1, 0}), white);
  set_camera(scene, {0, 0, 3.5}, {0, 0, 0}, 45);
  return scene;
}

SceneDescription ball_on_ground(const Vec3d& ball_centre) {
  SceneDescription scene = empty_scene();
  add_mesh(scene, quad({-2, -0.5, 2}, {4, 0, 0}, {0, 0, -4}),
           add_material(scene, diffuse(Vec3d(0.5))));
  description::CookTorranceMaterial glossy;
  glossy.diffuse.factor = Vec3d(0.2);
  glossy.specular.factor = Vec3d(0.6);
  glossy.roughness.factor = 0.3;
  add_mesh(scene, sphere(ball_centre, 0.5, 2), add_material(scene, glossy));
  set_camera(scene, {0, 1, 4}, {0, 0, 0}, 45);
  return scene;
}

SceneDescription furnace(description::Mesh inward_surface, double albedo, double emission) {
  SceneDescription scene = empty_scene();
  const MaterialHandle wall =
      add_material(scene, DiffuseMaterial{{Vec3d{albedo}, {}}}, Vec3d{emission});
  add_mesh(scene, std::move(inward_surface), wall);
  set_camera(scene, {0, 0, 0}, {0, 0, -1}, 60);
  return scene;
}

}  // namespace candela::test
