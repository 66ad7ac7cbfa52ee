// A scene file -> SceneDescription. The first of the five doors; the format goes by the extension.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"

namespace candela {

struct LoadOptions {
  bool use_mtl_materials = false;          // --materials mtl: Ke, Ni, illum, map_d, ... count
  std::optional<std::string> lab3_ground;  // --lab3-ground IMAGE: docs/scene_format.md
  std::optional<Vec3d> ambient;            // --ambient R,G,B
  // --fresnel, --geometry: of all cook_torrance materials
  std::optional<description::FresnelModel> fresnel;
  std::optional<description::GeometryModel> geometry;
};

// All problems at once, as far as recovery goes (errors at most 20). Reads files only; decodes no
// texture.
[[nodiscard]] Result<description::SceneDescription> load(const std::string& path,
                                                         const LoadOptions& options);

}  // namespace candela
