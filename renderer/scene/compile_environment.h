// The environments of the description -> the one that a scene has.
#pragma once

#include <optional>
#include <span>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "renderer/light/environment.h"
#include "renderer/texture/texture.h"

namespace candela {

// Of one light; nothing for lights of other kinds. `images` are the description's.
[[nodiscard]] std::optional<Environment> compile_environment(
    const description::Light& light, std::span<const description::Image> images,
    TextureStore& textures, Diagnostics& diagnostics);

// Of all lights: their sum (light/sum_environments.h), where black ones do not count; a note says
// where it is resampled. Nothing where there is none.
[[nodiscard]] std::optional<Environment> compile_environments(
    const description::SceneDescription& description, TextureStore& textures,
    Diagnostics& diagnostics);

// The radiance of all constant ones together.
[[nodiscard]] Vec3d sum_of_constants(const description::SceneDescription& description);

}  // namespace candela
