// SceneDescriptions built in code, for tests that go through compile():
//
//   description::SceneDescription scene = empty_scene();
//   const auto white = add_material(scene, description::DiffuseMaterial{{Vec3d{0.8}, {}}});
//   add_mesh(scene, sphere({0, 0, 0}, 1, 4), white);
//   add_light(scene, description::PointLight{{0, 5, 0}, Vec3d{10}});
//   set_camera(scene, {0, 0, 5}, {0, 0, 0}, 40);
#pragma once

#include "tests/scenes/meshes.h"

namespace candela::test {

// Nothing but a name.
[[nodiscard]] description::SceneDescription empty_scene();

template <class Model>
description::MaterialHandle add_material(description::SceneDescription& scene, Model model,
                                         Vec3d emission = Vec3d{0.0}) {
  description::Material material;
  material.name = "material" + std::to_string(scene.materials.size());
  material.model = std::move(model);
  material.emission = emission;
  scene.materials.push_back(std::move(material));
  return description::MaterialHandle(scene.materials.size() - 1);
}

// Of a surface with media on its sides.
template <class Model>
description::MaterialHandle add_material_with_media(description::SceneDescription& scene,
                                                    Model model,
                                                    const description::MediumInterface& media) {
  const description::MaterialHandle material = add_material(scene, std::move(model));
  scene.materials[material.index].media = media;
  return material;
}

description::MediumHandle add_medium(description::SceneDescription& scene, const Vec3d& absorption,
                                     const Vec3d& scattering, double asymmetry = 0);

[[nodiscard]] inline description::DiffuseMaterial diffuse(Vec3d reflectance) {
  return {{reflectance, {}}};
}

// The mesh and one instance of it.
description::MeshHandle add_mesh(description::SceneDescription& scene, description::Mesh mesh,
                                 description::MaterialHandle material,
                                 const Transform& object_to_world = {});

// One more instance of a mesh that is there already.
void add_instance(description::SceneDescription& scene, description::MeshHandle mesh,
                  const Transform& object_to_world);

template <class Kind>
void add_light(description::SceneDescription& scene, Kind kind) {
  scene.lights.push_back({{}, std::move(kind)});
}

// Replaces all cameras by this one.
void set_camera(description::SceneDescription& scene, const Vec3d& eye, const Vec3d& target,
                double fovy_degrees = 60, const Vec3d& up = {0, 1, 0});

// A room of side 2 about the origin, its walls facing inwards, open towards +z, white but for a red
// left and a green right wall, with an emitting quad below its ceiling and a box on its floor.
// Camera at z = 3.5. All diffuse, every length O(1): the small scene that most tests can use.
[[nodiscard]] description::SceneDescription small_room();

// A diffuse ground, a ball of radius 1/2 on it that is glossy too, a camera before them; no light.
[[nodiscard]] description::SceneDescription ball_on_ground(const Vec3d& ball_centre);

// A closed surface about the origin, facing inwards, of reflectance `albedo` and emission
// `emission` everywhere: radiance within is emission / (1 - albedo) [white furnace]. Camera at the
// origin.
[[nodiscard]] description::SceneDescription furnace(description::Mesh inward_surface, double albedo,
                                                    double emission);

}  // namespace candela::test
