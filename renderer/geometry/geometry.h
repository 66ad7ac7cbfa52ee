// The compiled scene's surfaces: flat arrays of triangles and spheres in normalised space.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/base/handle.h"
#include "renderer/geometry/sphere.h"
#include "renderer/geometry/triangle_list.h"
#include "renderer/math/bounds.h"
#include "renderer/math/vec.h"

namespace candela {

struct Geometry;
struct Object;
struct Instance;
struct Material;
using GeometryHandle = Handle<Geometry>;
using ObjectHandle = Handle<Object>;
using MaterialHandle = Handle<Material>;

// Triangles, or spheres, that share one material and one kind of visibility. What is absent is
// empty.
struct Geometry {
  // Embree reads 16 bytes a vertex and so 4 past the last one: where the capacity exceeds the size
  // (compile() reserves one more than it needs) it shares this array, else it copies.
  std::vector<Vec3f> positions;
  TriangleList triangles;
  std::vector<Vec3f> normals;   // empty, or one a vertex; zero: "use the triangle's"
  std::vector<Vec2f> uvs;       // empty, or one a vertex
  std::vector<Sphere> spheres;  // in place of all those
  MaterialHandle material;
  bool reads_tangents = true;  // dp/du and dp/dv of surface points
  // Some triangles are neither wholly opaque nor wholly clear: visibility asks alpha_test.h.
  bool has_cutouts = false;
  // Index into the light table of primitive 0's light (triangle or sphere); primitive i has
  // first_light + i. none: dark.
  std::uint32_t first_light = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] bool is_emissive() const {
    return first_light != std::numeric_limits<std::uint32_t>::max();
  }
};

// Texture coordinates between the corners of a triangle that has them.
[[nodiscard]] inline Vec2f uv_of(const Geometry& geometry, const TriangleCorners& corners, float u,
                                 float v) {
  const Vec2f t0 = geometry.uvs[corners[0]];
  return t0 + (geometry.uvs[corners[1]] - t0) * u + (geometry.uvs[corners[2]] - t0) * v;
}

// Texture coordinates where a hit has u and v.
[[nodiscard]] inline Vec2f uv_at(const Geometry& geometry, std::uint32_t triangle, float u,
                                 float v) {
  if (geometry.uvs.empty()) {
    if (geometry.spheres.empty()) return {0.5f, 0.5f};
    return sphere_uv(geometry.spheres[triangle], from_octahedron({u, v}));
  }
  return uv_of(geometry, geometry.triangles[triangle], u, v);
}

// Geometries that are placed together.
struct Object {
  std::vector<GeometryHandle> geometries;
};

// An affine placement of an object, float, in normalised space. p' = x*p.x + y*p.y + z*p.z + t.
struct Instance {
  ObjectHandle object;
  Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, translation{0};
  // Columns of the inverse's transpose, up to a positive factor: normals transform by these, to
  // where the winding calls outside, whatever the determinant's sign.
  Vec3f normal_x{1, 0, 0}, normal_y{0, 1, 0}, normal_z{0, 0, 1};
  // Bounds of rounding: of placed points, per axis of the world; and of the origins of rays that
  // leave the instance, once moved into the object's space, per axis of that.
  Vec3f placing_error{0}, ray_error{0};

  [[nodiscard]] Vec3f point(const Vec3f& p) const {
    return x * p.x + y * p.y + z * p.z + translation;
  }
  [[nodiscard]] Vec3f vector(const Vec3f& v) const { return x * v.x + y * v.y + z * v.z; }
  [[nodiscard]] Vec3f normal(const Vec3f& n) const {
    return normal_x * n.x + normal_y * n.y + normal_z * n.z;
  }
  // How far along the unit normal n of a surface both may move it.
  [[nodiscard]] float offset(const Vec3f& n) const {
    return dot(glm::abs(n), placing_error) +
           dot(glm::abs(Vec3f(dot(n, x), dot(n, y), dot(n, z))), ray_error);
  }
};

// What an accelerator returns. (u, v) are the barycentric weights of vertices 1 and 2; of a sphere
// the direction from its centre, as sphere.h unfolds it.
struct Hit {
  float t = std::numeric_limits<float>::infinity();
  float u = 0;
  float v = 0;
  std::uint32_t geometry =
      std::numeric_limits<std::uint32_t>::max();  // index into Scene::geometries
  std::uint32_t triangle = 0;                     // or sphere: index into the geometry's
  std::uint32_t instance = std::numeric_limits<std::uint32_t>::max();  // none: of the world itself

  [[nodiscard]] bool is_hit() const {
    return geometry != std::numeric_limits<std::uint32_t>::max();
  }
  [[nodiscard]] bool is_instanced() const {
    return instance != std::numeric_limits<std::uint32_t>::max();
  }
};

}  // namespace candela
