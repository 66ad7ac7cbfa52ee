// What is wrong with a scene as written, whatever format it came from.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Of lights and surfaces that shine: above, products of 32-bit numbers would be infinite.
inline constexpr double largest_radiance = 1e30;

// Errors for what cannot be rendered (handles out of range, numbers that are not finite, eye at
// target, singular transforms, ...) and warnings for what will be but surprises (no light at all,
// kd + ks above 1). compile() may rely on all that this calls an error.
// Touches no file; linear in the size of the scene.
[[nodiscard]] Diagnostics validate(const SceneDescription& scene);

// What does no harm but is probably not meant (unused materials, black lights, cameras with their
// back to the scene), as warnings, for `candela check`. Missing images are not looked for: the
// texture store warns of them.
[[nodiscard]] Diagnostics lint(const SceneDescription& scene);

// Whether anything shines by its numbers, images aside.
[[nodiscard]] bool has_light(const SceneDescription& scene);

// Whether some instance has a triangle or a sphere, or a light is a triangle.
[[nodiscard]] bool has_surface(const SceneDescription& scene);

}  // namespace candela::description
