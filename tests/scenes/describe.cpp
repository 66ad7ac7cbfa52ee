#include "tests/scenes/describe.h"

#include <cmath>

namespace candela::test {
namespace {

struct Triangles {
  std::vector<Vec3d> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Triangles icosahedron() {
  const double t = (1 + std::sqrt(5.0)) / 2;
  Triangles s;
  s.positions = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  s.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Vec3d& p : s.positions) p = normalize(p);
  return s;
}

// Vertices are not shared between the new triangles: simple, and no test needs it.
Triangles subdivided(const Triangles& s) {
  Triangles out;
  for (const auto& t : s.triangles) {
    const Vec3d a = s.positions[t[0]], b = s.positions[t[1]], c = s.positions[t[2]];
    const Vec3d ab = normalize(a + b), bc = normalize(b + c), ca = normalize(c + a);
    for (const auto& corner :
         std::vector<std::array<Vec3d, 3>>{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      const auto first = static_cast<std::uint32_t>(out.positions.size());
      out.positions.insert(out.positions.end(), corner.begin(), corner.end());
      out.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return out;
}

description::MeshHandle place(SceneDescription& scene, description::Mesh mesh) {
  const description::MeshHandle handle(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({handle, {}, {}, {}});
  return handle;
}

}  // namespace

description::Material diffuse_material(const std::string& name, Vec3d reflectance) {
  description::Material material;
  material.name = name;
  material.model = description::DiffuseMaterial{{reflectance, {}}};
  return material;
}

description::Material emitter(const std::string& name, Vec3d radiance, bool both_sides) {
  description::Material material = diffuse_material(name, Vec3d(0.0));
  material.emission = radiance;
  material.emits_both_sides = both_sides;
  return material;
}

description::MaterialHandle add_material(SceneDescription& scene, description::Material material) {
  scene.materials.push_back(std::move(material));
  return description::MaterialHandle(scene.materials.size() - 1);
}

description::MeshHandle add_quad(SceneDescription& scene, description::MaterialHandle material,
                                 Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
  description::Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {material};
  return place(scene, std::move(mesh));
}

description::MeshHandle add_sphere(SceneDescription& scene, description::MaterialHandle material,
                                   Vec3d centre, double radius, int levels, bool smooth_normals) {
  Triangles sphere = icosahedron();
  for (int i = 0; i < levels; ++i) sphere = subdivided(sphere);
  description::Mesh mesh;
  for (const Vec3d& p : sphere.positions) {
    mesh.positions.push_back(centre + radius * p);
    if (smooth_normals) mesh.normals.emplace_back(p);
  }
  mesh.triangles = sphere.triangles;
  mesh.materials = {material};
  return place(scene, std::move(mesh));
}

void add_box(SceneDescription& scene, description::MaterialHandle material, Vec3d lower,
             Vec3d upper, bool inwards) {
  const auto corner = [&](int i) {
    return Vec3d((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                 (i & 4) != 0 ? upper.z : lower.z);
  };
  // Seen from outside, counter-clockwise.
  const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces) {
    if (inwards)
      add_quad(scene, material, corner(f[3]), corner(f[2]), corner(f[1]), corner(f[0]));
    else
      add_quad(scene, material, corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
  }
}

void add_camera(SceneDescription& scene, Vec3d eye, Vec3d target, double fovy_degrees, Vec3d up) {
  description::Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.up = up;
  camera.fovy_degrees = fovy_degrees;
  scene.cameras.push_back(camera);
}

void add_constant_environment(SceneDescription& scene, Vec3d radiance) {
  scene.lights.push_back({{}, description::ConstantEnvironment{radiance, true}});
}

SceneDescription small_room() {
  SceneDescription scene;
  const auto white = add_material(scene, diffuse_material("white", Vec3d(0.7)));
  const auto red = add_material(scene, diffuse_material("red", {0.6, 0.05, 0.05}));
  const auto green = add_material(scene, diffuse_material("green", {0.1, 0.5, 0.1}));
  const auto lamp = add_material(scene, emitter("lamp", {12, 10, 7}));
  add_quad(scene, white, {-1, -1, 1}, {1, -1, 1}, {1, -1, -1}, {-1, -1, -1});  // floor
  add_quad(scene, white, {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1});      // ceiling
  add_quad(scene, white, {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1});  // back
  add_quad(scene, red, {-1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1});
  add_quad(scene, green, {1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {1, 1, -1});
  add_quad(scene, lamp, {-0.3, 0.99, -0.3}, {0.3, 0.99, -0.3}, {0.3, 0.99, 0.3}, {-0.3, 0.99, 0.3});
  add_box(scene, white, {-0.6, -1, -0.6}, {0.0, 0.0, -0.1}, false);
  add_camera(scene, {0, 0, 3.6}, {0, 0, 0}, 40);
  return scene;
}

}  // namespace candela::test
