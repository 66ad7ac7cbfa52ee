// What the command line says of how scenes are read.
#pragma once

#include <optional>
#include <string>

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

}  // namespace candela
