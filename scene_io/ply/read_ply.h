// PLY (ascii, binary of either byte order, any of them gzip'ed) -> a mesh.
//
// Read: element vertex with x y z, nx ny nz, and u v | s t | texture_u texture_v | texture_s
// texture_t; element face with a list vertex_indices | vertex_index of any length (triangulated:
// scene_io/mesh/triangulate.h); tristrips. Other elements and properties are stepped over. v = 0 is
// the image's bottom row. Counts of the header are believed only as far as the file has bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::ply {

struct PlyOptions {
  bool smooth_missing_normals = true;  // false: a file without normals gives a mesh without
};

// A file's vertices, as a mesh without triangles, and its faces: the corners of one after another.
// Strips are their triangles.
struct PolygonMesh {
  description::Mesh mesh;
  std::vector<std::uint32_t> corners;  // vertices
  std::vector<std::uint32_t> sizes;    // of each face, 3 or more
};

// `bytes` are those of the file `path`. No value: the diagnostics have errors.
[[nodiscard]] std::optional<PolygonMesh> parse_polygons(const std::string& path,
                                                        std::string_view bytes,
                                                        Diagnostics& diagnostics);
// With all faces as triangles, in their order.
[[nodiscard]] description::Mesh triangulated(PolygonMesh polygons);

// Reads `path`. Touches no scene, so several files may be read in parallel. No value: the
// diagnostics have errors. `materials` is left empty.
[[nodiscard]] std::optional<description::Mesh> read_ply(const std::string& path,
                                                        const PlyOptions& options,
                                                        Diagnostics& diagnostics);

// The same with `bytes` in place of the file's.
[[nodiscard]] std::optional<description::Mesh> parse_ply(const std::string& path,
                                                         std::string_view bytes,
                                                         const PlyOptions& options,
                                                         Diagnostics& diagnostics);

}  // namespace candela::ply
