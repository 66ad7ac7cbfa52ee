// Triangles far larger than the scene, cut where they come near it.
#pragma once

#include <optional>

#include "renderer/description/scene_description.h"

namespace candela {

// A ground a million times as wide as what stands on it: its vertices are far outside of the unit
// that the scene is brought to (normalise.h), and a point interpolated between them has an error of
// their size, not of its own. So each edge is halved until it is no longer than four units or its
// distance from the centre; positions then have errors in proportion to that distance.
//
// Whether an edge is cut depends on it alone, so triangles that share one stay joined. Vertex
// normals and uvs are interpolated. Nothing where there is nothing to cut.
[[nodiscard]] std::optional<description::Mesh> split_large_triangles(
    const description::Mesh& mesh, const Transform& to_normalised);

}  // namespace candela
