// Shading normals from height maps and from tangent-space normal maps.
//
// All functions take a unit normal n and the surface's derivatives dp/du, dp/dv, and return a unit
// normal within 90 degrees of n. Where the uv map is degenerate (dp/du parallel to dp/dv, zero or
// not finite) or the map's answer is not a direction, they return n.
#pragma once

#include "renderer/material/material.h"
#include "renderer/math/constants.h"

namespace candela {

// How much of the square of edges |dp/du|, |dp/dv| the uv parallelogram must fill; below, rounding
// of dp/du and dp/dv would decide. A pure number.
inline constexpr float smallest_uv_shear = 1e-5f;

// n.(dp/du x dp/dv): the area of the uv square on the surface, negative where the map is mirrored;
// 0 where it is degenerate.
[[nodiscard]] inline float uv_area(const Vec3f& n, const Vec3f& dp_du, const Vec3f& dp_dv) {
  const float area = dot(n, cross(dp_du, dp_dv));
  const float edges = std::sqrt(length_squared(dp_du)) * std::sqrt(length_squared(dp_dv));
  return std::abs(area) > smallest_uv_shear * edges && edges < infinity ? area : 0;
}

// `v` normalised, or `n` where v is no direction or does not lie on n's side.
[[nodiscard]] inline Vec3f unit_on_side_of(const Vec3f& n, const Vec3f& v) {
  const float length2 = length_squared(v);
  if (!(length2 > 0) || !(length2 < infinity) || !(dot(n, v) > 0)) return n;
  return v / std::sqrt(length2);
}

// The normal of the surface p + h n, whose height above p is
//   h = height_scale * height(u, v) * (edge of the uv square on the surface = sqrt(area)),
// so that slopes depend neither on the scene's unit nor on the object's size, only on the map:
// height_scale = 0.01 makes white rise by 1 % of the picture's width. Without the edge where
// heights are lengths. By surface gradients [Mikkelsen10, eqs. 3-5]; `slope` is (dh/du, dh/dv) of
// the map.
[[nodiscard]] inline Vec3f bump_normal(const Vec3f& n, const Vec3f& dp_du, const Vec3f& dp_dv,
                                       Vec2f slope, float height_scale,
                                       bool heights_are_lengths = false) {
  const float area = uv_area(n, dp_du, dp_dv);
  if (area == 0) return n;
  const float unit = heights_are_lengths ? 1 : std::sqrt(std::abs(area));
  const Vec3f gradient = (cross(dp_dv, n) * slope.x + cross(n, dp_du) * slope.y) / area;
  return unit_on_side_of(n, n - gradient * (height_scale * unit));
}

// (dh/du, dh/dv) of a height map by central differences over one texel, which are continuous where
// forward differences of a bilinear map jump. Maps by place are moved along the surface.
[[nodiscard]] inline Vec2f height_slope(const TextureStore& textures, TextureHandle map,
                                        const TexturePoint& at, const Vec3f& dp_du,
                                        const Vec3f& dp_dv) {
  if (const std::optional<Vec2f> slope = textures.slope(map, at.uv)) return *slope;
  const TextureInfo& info = textures.info(map);
  const auto width = static_cast<float>(info.width);
  const auto height = static_cast<float>(info.height);
  if (!(width > 0) || !(height > 0)) return {0, 0};
  const float du = 0.5f / width;
  const float dv = 0.5f / height;
  const bool is_by_place = textures.is_by_place(map);
  const auto height_at = [&](float u, float v) {
    if (!is_by_place) return textures.lookup(map, at.uv + Vec2f(u, v)).x;
    return textures
        .lookup_at(map, {at.uv + Vec2f(u, v), at.position + dp_du * u + dp_dv * v, at.normal})
        .x;
  };
  return {(height_at(du, 0) - height_at(-du, 0)) * width,
          (height_at(0, dv) - height_at(0, -dv)) * height};
}

// A tangent-space normal encoded as (n + 1) / 2: x along u, y along v (up in the picture), z along
// n. The frame is dp/du made perpendicular to n, with the uv map's handedness, or right-handed even
// where that is mirrored.
[[nodiscard]] inline Vec3f mapped_normal(const Vec3f& n, const Vec3f& dp_du, const Vec3f& dp_dv,
                                         const Vec3f& encoded, bool is_right_handed) {
  const float area = uv_area(n, dp_du, dp_dv);
  const Vec3f along = dp_du - n * dot(n, dp_du);
  const float length2 = length_squared(along);
  if (area == 0 || !(length2 > 0)) return n;
  const Vec3f tangent = along / std::sqrt(length2);
  const Vec3f bitangent = cross(n, tangent) * (is_right_handed ? 1 : std::copysign(1.0f, area));
  const Vec3f local = encoded * 2.0f - 1.0f;
  return unit_on_side_of(n, tangent * local.x + bitangent * local.y + n * local.z);
}

[[nodiscard]] inline bool has_bump(const Material& material) {
  return material.height.is_valid() || material.normal_map.is_valid();
}

// The material's normal at a point: the normal map's first, the height map's on top of it. `n` is
// the shading normal on the front side; dp/du and dp/dv in the same space as n.
[[nodiscard]] inline Vec3f shading_normal_at(const Material& material, const TextureStore& textures,
                                             const TexturePoint& at, const Vec3f& n,
                                             const Vec3f& dp_du, const Vec3f& dp_dv) {
  Vec3f normal = n;
  if (material.normal_map)
    normal = mapped_normal(normal, dp_du, dp_dv, Vec3f(textures.lookup_at(material.normal_map, at)),
                           material.normal_map_is_right_handed);
  if (material.height)
    normal =
        bump_normal(normal, dp_du, dp_dv, height_slope(textures, material.height, at, dp_du, dp_dv),
                    material.height_scale, material.heights_are_lengths);
  return normal;
}

}  // namespace candela
