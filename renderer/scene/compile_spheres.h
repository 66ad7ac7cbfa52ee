// Spheres of the description -> geometries in normalised space.
#pragma once

#include <optional>

#include "renderer/scene/compile_geometry.h"

namespace candela {

// The reasons under which spheres are counted as triangles are under out_of_reach and too_small.
inline constexpr char spheres_out_of_reach[] = "spheres that are not finite or too far away";
inline constexpr char spheres_too_small[] = "spheres that are too small beside the scene";

// None for a sphere that no ray can meet, which is counted. `to_normalised` is a similarity.
[[nodiscard]] std::optional<Geometry> compile_sphere(const Scene& scene,
                                                     const description::Sphere& sphere,
                                                     const Transform& to_normalised,
                                                     std::uint32_t material, bool decides_cutouts,
                                                     DropCounts& dropped);

}  // namespace candela
