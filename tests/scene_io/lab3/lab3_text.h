// lab3 texts in memory, beside a folder of small files that they may name:
//   triangle.obj quad.obj triangle.ply with_mtl.obj (materials red, blue) picture.png up.png ...
//   and sky.hdr; a folder "folder", a FIFO "pipe".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"
#include "scene_io/load.h"

namespace candela::test {

// With '/' at its end. Made on the first call.
[[nodiscard]] const std::string& lab3_folder();

[[nodiscard]] Result<description::SceneDescription> parse_lab3_text(
    std::string_view text, const LoadOptions& options = {});

// The scene of a text that must have no errors; an empty scene (and a failed test) where it has.
[[nodiscard]] description::SceneDescription scene_of(std::string_view text,
                                                     const LoadOptions& options = {});

// All diagnostics of one severity, as "line:column: message" (without the line and column where
// they are not known).
[[nodiscard]] std::vector<std::string> said(Severity severity, std::string_view text,
                                            const LoadOptions& options = {});

// The only one of its severity, or a list of all where there is not one.
[[nodiscard]] std::string error_in(std::string_view text, const LoadOptions& options = {});
[[nodiscard]] std::string warning_in(std::string_view text, const LoadOptions& options = {});

}  // namespace candela::test
