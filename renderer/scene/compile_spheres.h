// Spheres of the description -> geometries in normalised space.
#pragma once

#include <optional>

#include "renderer/description/scene_description.h"
#include "renderer/scene/drop_reason.h"
#include "renderer/scene/scene.h"

namespace candela {

// None for a sphere that no ray can meet, which is counted. `to_normalised` is a similarity.
[[nodiscard]] std::optional<Geometry> compile_sphere(const Scene& scene,
                                                     const description::Sphere& sphere,
                                                     const Transform& to_normalised,
                                                     std::uint32_t material, bool decides_cutouts,
                                                     DropCounts& dropped);

}  // namespace candela
