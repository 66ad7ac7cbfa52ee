// pbrt texts in memory, beside a folder of small files that they may name: triangle.ply and
// quad.ply (4 x 4; both without normals and uvs), picture.png, picture.exr, white.spd, world.pbrt
// (a shape), self.pbrt (includes itself), broken.pbrt, spot.pbrt and mesh.pbrt (an error each),
// folder/, a FIFO "pipe".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"

namespace candela::test {

// With '/' at its end. Made on the first call.
[[nodiscard]] const std::string& pbrt_folder();

[[nodiscard]] Result<description::SceneDescription> parse_pbrt_text(std::string_view text);

void expect_near(const Vec3d& vector, const Vec3d& expected);

// The scene of a text that must have no errors; an empty scene (and a failed test) where it has.
[[nodiscard]] description::SceneDescription pbrt_scene(std::string_view text);
// The same of what stands behind WorldBegin.
[[nodiscard]] description::SceneDescription pbrt_world(std::string_view text);

// The only diagnostic of its severity as "line:column: message", or a list of all where there is
// not one. Of what stands in the line behind WorldBegin: line 2.
[[nodiscard]] std::string pbrt_error(std::string_view text);
[[nodiscard]] std::string pbrt_warning(std::string_view text);
[[nodiscard]] std::string pbrt_world_error(std::string_view text);
[[nodiscard]] std::string pbrt_world_warning(std::string_view text);
// The same of the only one of any severity.
[[nodiscard]] std::string pbrt_message(std::string_view text);
[[nodiscard]] std::string pbrt_world_message(std::string_view text);

}  // namespace candela::test
