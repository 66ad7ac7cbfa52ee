// Which triangles of a mesh rays can meet, and how.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/scene/drop_reason.h"
#include "renderer/scene/scene.h"

namespace candela {

// Coordinates of normalised space from here on are out of reach: near what Embree leaves out
// without a word.
inline constexpr double out_of_reach_at = 1e18;

// False for NaN and Inf, too.
template <class V>
[[nodiscard]] bool is_in_reach(const V& p) {
  constexpr auto limit = static_cast<typename V::value_type>(out_of_reach_at);
  return std::abs(p.x) < limit && std::abs(p.y) < limit && std::abs(p.z) < limit;
}

// How much of a triangle its material's opacity covers; looks at the texels within.
[[nodiscard]] Coverage coverage_of(const Scene& scene, const Material& material,
                                   const description::Mesh& mesh, std::uint32_t triangle);

// The triangles of one material, sorted by how rays meet them, in the mesh's order.
struct SortedTriangles {
  std::vector<std::uint32_t> opaque;
  std::vector<std::uint32_t> partial;
};

// Drops, and counts, what cannot be met: triangles out of reach, of no area, or wholly clear.
// Without `decides_cutouts` all others are opaque. `positions` are the mesh's vertices in
// normalised space.
[[nodiscard]] SortedTriangles sort_triangles(const Scene& scene, const Material& material,
                                             const description::Mesh& mesh,
                                             const std::vector<Vec3f>& positions,
                                             std::span<const std::uint32_t> triangles,
                                             bool decides_cutouts, DropCounts& dropped);

}  // namespace candela
