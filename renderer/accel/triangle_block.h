// Up to four triangles side by side, and the watertight ray-triangle test [Woop13]: of two
// triangles that share an edge a ray through the edge hits at least one, whatever the rounding.
#pragma once

#include <cstdint>

#include "renderer/math/float4.h"
#include "renderer/math/ray.h"

namespace candela::bvh {

struct alignas(16) TriangleBlock {
  float vertices[3][3][4];    // vertex, axis, lane
  std::uint32_t geometry[4];  // lanes that are not used repeat lane 0
  std::uint32_t triangle[4];
};

// A ray in coordinates where it starts at the origin and runs along an axis: its largest component
// becomes z, the others are sheared away [Woop13, section 3.1].
struct ShearedRay {
  Ray ray;
  Float4 origin[3];
  Float4 shear_x, shear_y, shear_z;
  int axis_x, axis_y, axis_z;

  explicit ShearedRay(const Ray& unsheared) : ray(unsheared) {
    const Vec3f d = glm::abs(ray.direction);
    axis_z = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
    axis_x = (axis_z + 1) % 3;
    axis_y = (axis_z + 2) % 3;
    for (int axis = 0; axis < 3; ++axis) origin[axis] = broadcast(ray.origin[axis]);
    shear_x = broadcast(ray.direction[axis_x] / ray.direction[axis_z]);
    shear_y = broadcast(ray.direction[axis_y] / ray.direction[axis_z]);
    shear_z = broadcast(1 / ray.direction[axis_z]);
  }
};

struct BlockHits {
  int mask;        // lanes with 0 < t <= t_max
  Float4 t, u, v;  // weights of vertices 1 and 2
};

namespace detail {

// The sign of an edge function decides on which side of the edge the ray passes. A difference of
// rounded products has the right sign or is 0; where it is 0, double is exact.
inline void refine_zeros(Float4& edge, Float4 ax, Float4 by, Float4 ay, Float4 bx) {
  for (int mask = mask_of(edge == broadcast(0.0f)); mask != 0; mask &= mask - 1) {
    const int i = lowest_lane(mask);
    edge[i] = static_cast<float>(static_cast<double>(ax[i]) * static_cast<double>(by[i]) -
                                 static_cast<double>(ay[i]) * static_cast<double>(bx[i]));
  }
}

struct ShearedVertex {
  Float4 x, y, z;
};
inline ShearedVertex shear(const float (&vertex)[3][4], const ShearedRay& ray) {
  const Float4 z = load_aligned(vertex[ray.axis_z]) - ray.origin[ray.axis_z];
  return {load_aligned(vertex[ray.axis_x]) - ray.origin[ray.axis_x] - ray.shear_x * z,
          load_aligned(vertex[ray.axis_y]) - ray.origin[ray.axis_y] - ray.shear_y * z,
          ray.shear_z * z};
}

[[nodiscard]] inline Float4 largest(Float4 a, Float4 b, Float4 c) {
  return max(max(absolute(a), absolute(b)), absolute(c));
}

// Bound of the error of t, whose parts are the edge functions u, v, w and the sheared vertices
// [Pharr23, section 6.8.7]. Large for slivers, and where the ray grazes.
[[nodiscard]] inline Float4 error_of_t(const ShearedVertex& a, const ShearedVertex& b,
                                       const ShearedVertex& c, Float4 largest_edge,
                                       Float4 determinant, Float4 shear_z) {
  const Float4 x = largest(a.x, b.x, c.x);
  const Float4 y = largest(a.y, b.y, c.y);
  const Float4 z = largest(a.z, b.z, c.z);
  const Float4 depth = z / absolute(shear_z);  // before it was divided by the direction's part
  const Float4 error_x = broadcast(gamma_bound(5)) * (x + depth);
  const Float4 error_y = broadcast(gamma_bound(5)) * (y + depth);
  const Float4 error_z = broadcast(gamma_bound(3)) * z;
  const Float4 error_edge =
      broadcast(2.0f) * (broadcast(gamma_bound(2)) * x * y + error_y * x + error_x * y);
  return broadcast(3.0f) *
         (broadcast(gamma_bound(3)) * largest_edge * z + error_edge * z + error_z * largest_edge) /
         absolute(determinant);
}

// Where the ray meets the triangle's plane, in double.
[[nodiscard]] inline float exact_t(const TriangleBlock& block, int lane, const Ray& ray) {
  const auto vertex = [&](std::size_t k) {
    return Vec3d(block.vertices[k][0][lane], block.vertices[k][1][lane],
                 block.vertices[k][2][lane]);
  };
  const Vec3d p0 = vertex(0);
  const Vec3d normal = cross(vertex(1) - p0, vertex(2) - p0);
  return static_cast<float>(dot(normal, p0 - Vec3d(ray.origin)) /
                            dot(normal, Vec3d(ray.direction)));
}

}  // namespace detail

// Both sides count. [Woop13, appendix A], four lanes at a time.
[[nodiscard]] inline BlockHits intersect_block(const TriangleBlock& block, const ShearedRay& ray,
                                               float t_max) {
  const detail::ShearedVertex a = detail::shear(block.vertices[0], ray);
  const detail::ShearedVertex b = detail::shear(block.vertices[1], ray);
  const detail::ShearedVertex c = detail::shear(block.vertices[2], ray);
  const Float4 zero = broadcast(0.0f);
  Float4 u = c.x * b.y - c.y * b.x;
  Float4 v = a.x * c.y - a.y * c.x;
  Float4 w = b.x * a.y - b.y * a.x;
  if (mask_of((u == zero) | (v == zero) | (w == zero)) != 0) {
    detail::refine_zeros(u, c.x, b.y, c.y, b.x);
    detail::refine_zeros(v, a.x, c.y, a.y, c.x);
    detail::refine_zeros(w, b.x, a.y, b.y, a.x);
  }
  const Mask4 is_mixed =
      ((u < zero) | (v < zero) | (w < zero)) & ((u > zero) | (v > zero) | (w > zero));
  if (mask_of(is_mixed) == 0xf) return {0, zero, zero, zero};
  const Float4 determinant = u + v + w;
  Float4 t = (u * a.z + v * b.z + w * c.z) / determinant;  // NaN where all are 0
  // Whether what the ray starts on lies before or behind it must not be left to rounding.
  const Float4 error =
      detail::error_of_t(a, b, c, detail::largest(u, v, w), determinant, ray.shear_z);
  for (int mask = mask_of(~is_mixed & (absolute(t) <= error)); mask != 0; mask &= mask - 1) {
    const int lane = lowest_lane(mask);
    t[lane] = detail::exact_t(block, lane, ray.ray);
  }
  const Mask4 is_hit = ~is_mixed & (t > zero) & (t <= broadcast(t_max));
  return {mask_of(is_hit), t, v / determinant, w / determinant};
}

}  // namespace candela::bvh
