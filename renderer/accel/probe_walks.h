// Where rays go in a scene, roughly and soon: a few walks from its first camera, on which light
// that surfaces scatter goes anywhere by the cosine, and glass bends none.
#pragma once

#include <functional>

#include "renderer/math/ray.h"
#include "renderer/scene/scene.h"

namespace candela {

// Calls trace(ray) for each ray of the walks, always the same ones. None where there is no camera.
void probe_walks(const Scene& scene, const std::function<Hit(const Ray&)>& trace);

}  // namespace candela
