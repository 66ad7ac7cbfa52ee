// Meshes as PLY files: binary, little-endian, which every reader of the format takes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "renderer/description/scene_description.h"

namespace candela::ply {

struct WriteOptions {
  // Of every vertex where the mesh has no texture coordinates; nothing: none are written.
  std::optional<Vec2f> missing_uv;
};

// The bytes of a file of the triangles that `triangles` lists by their places in the mesh, with
// just the vertices they use, in the order in which they use them. Positions are floats where all
// of them are floats, else doubles: reading gives back the same numbers.
[[nodiscard]] std::string write_ply(const description::Mesh& mesh,
                                    std::span<const std::uint32_t> triangles,
                                    const WriteOptions& options);

}  // namespace candela::ply
