// Small scenes written in code: descriptions, so that they pass through compile() like files do.
#pragma once

#include <string>
#include <vector>

#include "renderer/description/scene_description.h"

namespace candela::test {

using description::SceneDescription;

[[nodiscard]] description::Material diffuse_material(const std::string& name, Vec3d reflectance);
[[nodiscard]] description::Material emitter(const std::string& name, Vec3d radiance,
                                            bool both_sides = false);

description::MaterialHandle add_material(SceneDescription& scene, description::Material material);

// Two triangles a b c, a c d; the normal is (b-a) x (c-a).
description::MeshHandle add_quad(SceneDescription& scene, description::MaterialHandle material,
                                 Vec3d a, Vec3d b, Vec3d c, Vec3d d);
// Triangles of a subdivided icosahedron; 20 * 4^levels of them.
description::MeshHandle add_sphere(SceneDescription& scene, description::MaterialHandle material,
                                   Vec3d centre, double radius, int levels, bool smooth_normals);
// Six quads whose normals point inwards (a room) or outwards.
void add_box(SceneDescription& scene, description::MaterialHandle material, Vec3d lower,
             Vec3d upper, bool inwards);

void add_camera(SceneDescription& scene, Vec3d eye, Vec3d target, double fovy_degrees,
                Vec3d up = {0, 1, 0});
void add_constant_environment(SceneDescription& scene, Vec3d radiance);

// A room of 2 x 2 x 2 about the origin, open towards the camera on +z, red left, green right, with
// a lamp below the ceiling and a block.
[[nodiscard]] SceneDescription small_room();

}  // namespace candela::test
