// Environments from what a scene says.
#pragma once

#include <span>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "renderer/light/environment.h"
#include "renderer/texture/texture.h"

namespace candela {

// A grid for sampling has a cell a texel, or about this many in all where there are more texels;
// fewer where it would take more memory than the texels do (of maps of bytes: half of them), and
// where fewer do as well (cell_weights.h).
inline constexpr std::size_t default_environment_cells = std::size_t{2048} * 1024;

[[nodiscard]] Environment build_environment(const description::ConstantEnvironment& constant);

// Of an image of all directions that counts as a map of equal areas, which is square.
void warn_unless_square(const TextureStore& textures, TextureHandle map, const SourceSpan& span,
                        Diagnostics& diagnostics);

// `images` are the description's. Textures are added to the store with the wrap mode that the map
// needs, whatever the image says, and decoded: sampling needs their luminance. Values that are not
// finite or below 0 count as 0, and a warning says how many there are.
[[nodiscard]] Environment build_environment(const description::CubeEnvironment& cube,
                                            std::span<const description::Image> images,
                                            TextureStore& textures, Diagnostics& diagnostics,
                                            std::size_t max_cells = default_environment_cells);
[[nodiscard]] Environment build_environment(const description::LatLongEnvironment& map,
                                            std::span<const description::Image> images,
                                            TextureStore& textures, Diagnostics& diagnostics,
                                            std::size_t max_cells = default_environment_cells);

[[nodiscard]] Environment build_environment(const description::EqualAreaEnvironment& map,
                                            std::span<const description::Image> images,
                                            TextureStore& textures, Diagnostics& diagnostics,
                                            std::size_t max_cells = default_environment_cells);

// Of a map that is in the store, with a scale of 1: a latitude-longitude one that repeats, or an
// equal-area one that is clamped.
[[nodiscard]] Environment build_environment(EnvironmentMapping mapping, TextureHandle map,
                                            const std::array<Vec3f, 3>& map_from_world,
                                            const TextureStore& textures,
                                            std::size_t max_cells = default_environment_cells);

}  // namespace candela
