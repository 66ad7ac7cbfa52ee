#include "tests/scenes/soups.h"

#include "renderer/sampling/hash.h"
#include "tests/scenes/meshes.h"

namespace candela::test {
namespace {

Material constant_opacity(float opacity) {
  Material material;
  material.diffuse.constant = Rgb{0.5f};
  material.opacity.constant = opacity;
  return material;
}

Vec3f power_of_ten_vector(std::mt19937& random, float lowest, float highest) {
  const float exponent = lowest + (highest - lowest) * uniform(random);
  return uniform_in_cube(random) * std::pow(10.0f, exponent);
}

}  // namespace

Geometry geometry_of(const Soup& soup) {
  Geometry geometry;
  std::vector<TriangleCorners> triangles;
  geometry.positions.reserve(3 * soup.size() + 1);
  for (const Triangle& triangle : soup) {
    const auto first = static_cast<std::uint32_t>(geometry.positions.size());
    geometry.positions.insert(geometry.positions.end(), triangle.begin(), triangle.end());
    triangles.push_back({first, first + 1, first + 2});
  }
  geometry.triangles = std::move(triangles);
  geometry.material = MaterialHandle(0);
  return geometry;
}

Scene scene_of(std::vector<Geometry> geometries) {
  Scene scene;
  scene.materials.push_back(constant_opacity(1));
  scene.geometries = std::move(geometries);
  for (std::size_t i = 0; i < scene.geometries.size(); ++i) scene.world.geometries.emplace_back(i);
  return scene;
}

Scene scene_of(const Soup& soup) {
  std::vector<Geometry> geometries;
  geometries.push_back(geometry_of(soup));
  return scene_of(std::move(geometries));
}

void add_cutout(Scene& scene, const Soup& soup, float opacity) {
  scene.materials.push_back(constant_opacity(opacity));
  scene.geometries.push_back(geometry_of(soup));
  scene.geometries.back().material = MaterialHandle(scene.materials.size() - 1);
  scene.geometries.back().has_cutouts = true;
  scene.world.geometries.emplace_back(scene.geometries.size() - 1);
}

void add_instances(Scene& scene, const Soup& soup, std::vector<Instance> instances) {
  scene.geometries.push_back(geometry_of(soup));
  scene.objects.push_back({{GeometryHandle(scene.geometries.size() - 1)}});
  for (Instance& instance : instances) {
    instance.object = ObjectHandle(scene.objects.size() - 1);
    scene.instances.push_back(instance);
  }
}

Instance placement(const Vec3f& x, const Vec3f& y, const Vec3f& z, const Vec3f& translation) {
  Instance instance;
  instance.x = x;
  instance.y = y;
  instance.z = z;
  instance.translation = translation;
  instance.normal_x = cross(y, z);
  instance.normal_y = cross(z, x);
  instance.normal_z = cross(x, y);
  return instance;
}

float uniform(std::mt19937& random) {
  return unit_float(static_cast<std::uint32_t>(random()));
}

Vec3f uniform_in_cube(std::mt19937& random) {
  const float x = uniform(random);
  const float y = uniform(random);
  const float z = uniform(random);
  return Vec3f(x, y, z) * 2.0f - 1.0f;
}

Soup random_soup(std::size_t count, float size, std::uint32_t seed) {
  std::mt19937 random(seed);
  Soup soup(count);
  for (Triangle& triangle : soup) {
    const Vec3f centre = uniform_in_cube(random);
    for (Vec3f& vertex : triangle) vertex = centre + uniform_in_cube(random) * size;
  }
  return soup;
}

Soup sliver_soup(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  Soup soup(count);
  for (std::size_t i = 0; i < count; ++i) {
    Triangle& t = soup[i];
    t[0] = uniform_in_cube(random);
    t[1] = uniform_in_cube(random);
    t[2] = t[0] + (t[1] - t[0]) * uniform(random);
    if (i % 8 == 0) t[2] = t[i % 16 == 0 ? 0 : 1];
    if (i % 8 > 1) t[2] += power_of_ten_vector(random, -7, -2);
  }
  return soup;
}

Soup duplicate_soup(std::size_t count, std::uint32_t seed) {
  Soup soup;
  for (const Triangle& triangle : random_soup(count / 3, 0.2f, seed)) {
    const auto& [a, b, c] = triangle;
    soup.push_back(triangle);
    soup.push_back({b, c, a});
    if (soup.size() % 2 == 0) soup.push_back({a, c, b});
    if (soup.size() % 3 == 0) soup.push_back(triangle);
  }
  return soup;
}

Soup coplanar_soup(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::array<std::array<Vec3f, 2>, 5> planes{
      {{Vec3f(1, 0, 0), Vec3f(0, 1, 0)},
       {Vec3f(0, 1, 0), Vec3f(0, 0, 1)},
       {Vec3f(1, 0, 0), Vec3f(0, 0, 1)},
       {Vec3f(1, 1, 0), Vec3f(0, 1, 1)},
       {Vec3f(0.3f, 0.7f, -0.1f), Vec3f(-1, 0.2f, 0.9f)}}};
  Soup soup(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [u, v] = planes[i % planes.size()];
    const Vec3f centre = uniform_in_cube(random);
    for (Vec3f& vertex : soup[i]) {
      const Vec3f offset = uniform_in_cube(random) * 0.2f;
      vertex = u * (centre.x + offset.x) + v * (centre.y + offset.y);
    }
  }
  return soup;
}

Soup mixed_scale_soup(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  Soup soup(count);
  for (Triangle& triangle : soup) {
    const Vec3f centre = power_of_ten_vector(random, -4, 1);
    const float size = std::pow(10.0f, -7 + 8 * uniform(random));
    for (Vec3f& vertex : triangle) vertex = centre + uniform_in_cube(random) * size;
  }
  return soup;
}

Soup closed_surface(int subdivisions, float bumps, std::uint32_t seed) {
  description::Mesh mesh = sphere({0, 0, 0}, 1, subdivisions, false);
  std::mt19937 random(seed);
  for (Vec3d& p : mesh.positions) p *= 1 + bumps * uniform(random);
  Soup soup;
  for (const auto& [a, b, c] : mesh.triangles)
    soup.push_back({Vec3f(mesh.positions[a]), Vec3f(mesh.positions[b]), Vec3f(mesh.positions[c])});
  return soup;
}

Soup scaled(Soup soup, float factor) {
  for (Triangle& triangle : soup)
    for (Vec3f& vertex : triangle) vertex *= factor;
  return soup;
}

Scene scene_of_all_kinds() {
  Scene scene = scene_of(random_soup(20, 0.3f, 41));
  add_cutout(scene, random_soup(2000, 0.5f, 42), 0.5f);
  add_instances(scene, random_soup(1000, 0.4f, 43),
                {placement({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}),
                 placement({0, 1, 0}, {1, 0, 0}, {0, 0, 0.5f}, {0, 1, 0})});
  scene.geometries.back().has_cutouts = true;
  scene.geometries.back().material = MaterialHandle(1);
  return scene;
}

}  // namespace candela::test
