// What a scene's lights refer to.
#pragma once

#include "renderer/light/sample_light.h"
#include "renderer/scene/scene.h"

namespace candela {

[[nodiscard]] inline LightTables light_tables(const Scene& scene) {
  return {scene.environment ? &*scene.environment : nullptr, &scene.textures, &scene.geometries};
}

}  // namespace candela
