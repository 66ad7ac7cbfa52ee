// Wavefront MTL -> materials of a SceneDescription.
//
// Lab (MtlUse::Lab, what the lab's framework reads): every material is a LabMaterial. diffuse = Kd
// (absent: 0) or map_Kd, which replaces it; alpha = d (Tr = 1 - d; d wins) where there is no
// map_Kd; specular = Ks with exponent Ns (absent: 1), or map_Ks, which replaces both; height =
// map_Bump or bump, the last of them. Kd, Ks and d are clamped to [0, 1] and Ns to [0, 256]. All
// else is ignored.
//
// Full (MtlUse::Full): the first row that fits.
//   Pr, Pm or a map of Pr              CookTorrance: roughness Pr^2 (map_Pr as stored), a diffuse
//                                      part (1 - Pm) Kd under a specular one of reflectance
//                                      .04 (1 - Pm) + Pm Kd at normal incidence. With a map_Kd Pm
//                                      counts as 1 from .5 on, with a map of the specular part,
//                                      and below as 0, with one of the diffuse part
//   transmits, without map_Kd, map_d:  Dielectric of transmittance Tf (absent: 1). Ni > 1: that
//     illum 4 6 7 9 with Tf < 1 in a   index; else thin (straight through), index 1.5. Roughness
//     channel, d < 1 or Ni > 1;        sqrt(2/(Ns+2)) where Ns is given, below 100 and Ni > 1; else
//     any illum with Ni > 1 and        smooth. (Exporters write illum 4, Tf 1, Ni 1 for what is
//     Tf < 1 or d < 1                  opaque, so illum alone says nothing.)
//   mirrors: illum 3 to 9, Kd black,   Mirror of reflectance Ks
//     Ks not, no map of either, Ns
//     absent or at least 100
//   else                               LabMaterial as above; Ns is not clamped above
// For each: Ke = radiance emitted on both sides (MTL does not say on which), map_d = opacity
// (-imfchan names the channel; absent: alpha where the file has it), or d where the model has no
// use for it, or, where that is 1, map_Kd's alpha; bump's -bm = height_scale in units of
// `bump_height`; norm = normal map; -clamp on. Kd decodes by pow 2.2 as its maps do; Ks, Ke, Tf,
// Pr, Pm and d are linear as they stand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {

// The height of white of a bump map whose -bm is 1, in edges of the uv square: a bump map does not
// say how high it is; a fiftieth is mortar between bricks on a tile of a metre.
inline constexpr double bump_height = 0.02;

struct MtlLibrary {
  std::vector<description::Material> materials;  // in the order of the file; handles of images
                                                 // count within the library
  std::vector<description::Image> images;
};

// `path` is the MTL's own; textures are looked for beside it. Nothing for MtlUse::Ignore.
[[nodiscard]] MtlLibrary parse_mtl(const std::string& path, std::string_view text, MtlUse use,
                                   Diagnostics& diagnostics);

}  // namespace candela::obj
