#include "tests/stress/disturb.h"

#include "renderer/description/world_bounds.h"

namespace candela::test {
namespace {

using description::SceneDescription;

// What is placed in the world beside the meshes. `at` moves points, `along` turns directions.
template <class Point, class Direction>
void move_lights(SceneDescription& scene, const Point& at, const Direction& along) {
  for (description::Light& light : scene.lights) {
    if (auto* point = std::get_if<description::PointLight>(&light.kind)) {
      point->position = at(point->position);
    } else if (auto* spot = std::get_if<description::SpotLight>(&light.kind)) {
      spot->position = at(spot->position);
      spot->axis = along(spot->axis);
    } else if (auto* sun = std::get_if<description::DirectionalLight>(&light.kind)) {
      sun->to_light = along(sun->to_light);
    } else if (auto* triangle = std::get_if<description::TriangleLight>(&light.kind)) {
      for (Vec3d& vertex : triangle->vertices) vertex = at(vertex);
    }
  }
}

template <class Point, class Direction>
void move_cameras(SceneDescription& scene, const Point& at, const Direction& along) {
  for (description::Camera& camera : scene.cameras) {
    camera.eye = at(camera.eye);
    camera.target = at(camera.target);
    camera.up = along(camera.up);
  }
}

// Rodrigues' formula; k unit.
Mat3d rotation(double angle, const Vec3d& k) {
  const Mat3d cross_with(Vec3d(0, k.z, -k.y), Vec3d(-k.z, 0, k.x), Vec3d(k.y, -k.x, 0));
  return Mat3d(1.0) + cross_with * std::sin(angle) +
         cross_with * cross_with * (1 - std::cos(angle));
}

Vec3d same(const Vec3d& direction) {
  return direction;
}

}  // namespace

SceneDescription scaled(SceneDescription scene, double factor, Where where) {
  const auto at = [&](const Vec3d& p) { return p * factor; };
  if (where == Where::Vertices) {
    for (description::Mesh& mesh : scene.meshes)
      for (Vec3d& p : mesh.positions) p *= factor;
    for (description::Instance& instance : scene.instances)
      instance.object_to_world.translation *= factor;
  } else {
    for (description::Instance& instance : scene.instances)
      instance.object_to_world = Transform{Mat3d(factor), Vec3d(0.0)} * instance.object_to_world;
  }
  move_lights(scene, at, same);
  for (description::Light& light : scene.lights) {
    if (auto* point = std::get_if<description::PointLight>(&light.kind))
      point->intensity *= factor * factor;
    if (auto* spot = std::get_if<description::SpotLight>(&light.kind))
      spot->intensity *= factor * factor;
  }
  move_cameras(scene, at, same);
  for (description::Camera& camera : scene.cameras) {
    camera.lens_radius *= factor;
    camera.focus_distance *= factor;
  }
  return scene;
}

SceneDescription moved(SceneDescription scene, const Vec3d& offset, Where where) {
  const auto at = [&](const Vec3d& p) { return p + offset; };
  for (description::Mesh& mesh : scene.meshes)
    if (where == Where::Vertices)
      for (Vec3d& p : mesh.positions) p += offset;
  for (description::Instance& instance : scene.instances) {
    Transform& placement = instance.object_to_world;
    placement.translation += offset;
    // The mesh was moved already: what the placement makes of the offset is taken back.
    if (where == Where::Vertices) placement.translation -= placement.linear * offset;
  }
  move_lights(scene, at, same);
  move_cameras(scene, at, same);
  return scene;
}

SceneDescription rotated(SceneDescription scene, double angle_radians, const Vec3d& axis) {
  const Mat3d turn = rotation(angle_radians, normalize(axis));
  const auto apply = [&](const Vec3d& p) { return turn * p; };
  for (description::Instance& instance : scene.instances)
    instance.object_to_world = Transform{turn, Vec3d(0.0)} * instance.object_to_world;
  move_lights(scene, apply, apply);
  move_cameras(scene, apply, apply);
  return scene;
}

double diameter_of(const SceneDescription& scene) {
  return max_component(world_bounds(scene).extent());
}

}  // namespace candela::test
