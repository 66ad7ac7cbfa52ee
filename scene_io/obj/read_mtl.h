// Wavefront MTL -> materials of a SceneDescription.
//
// Lab (MtlUse::Lab; LAB3.md section 3): every material is a LabMaterial. diffuse = Kd (absent: 0;
// .6 where map_Kd stands alone) or map_Kd, which replaces it; alpha = d (Tr = 1 - d; d wins) where
// there is no map_Kd; specular = Ks, exponent = Ns (absent: 1), or map_Ks, which replaces both;
// height = map_Bump/bump. Kd, Ks and d are clamped to [0, 1] and Ns to [0, 256]. All else is
// ignored.
//
// Full (MtlUse::Full): the first row that fits.
//   Pr or Pm, or a map of either     CookTorrance: a = Pr^2 (map_Pr: as stored), ks = 1,
//                                    kd = (1 - Pm) Kd, f0 = .04 (1 - Pm) + Pm Kd; illum is ignored
//   illum 4, 6, 7, 9, or Tf/d < 1    Dielectric of Ni, transmittance Tf (illum 4/6/7/9: (1 - d)
//     with Ni > 1 and no map_d       where Tf is absent; Kd is ignored); a = sqrt(2/(Ns+2)) where
//                                    0 < Ns < 1000, else smooth
//   illum 3, 5, 8 with Ks > 0        Mirror of reflectance Ks where Kd is black, else LabMaterial
//   else                             LabMaterial as above, but Ns is not clamped above
// and for each: Ke = emitted radiance (as it stands), map_d = opacity (else d, where not used
// above), bump -bm = height_scale in units of `bump_height`, norm = normal map. Kd, Ks, Tf decode
// by pow 2.2 like their maps where the model's colours are linear; Ke, Pr, Pm, d are linear as they
// stand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {

// The height of white of a bump map whose -bm is 1, in edges of the uv square: a bump map says no
// more than "rougher"; a fiftieth is mortar between bricks on a tile of a metre.
inline constexpr double bump_height = 0.02;

struct MtlLibrary {
  std::vector<description::Material> materials;  // in the order of the file; handles of images
                                                 // count within the library
  std::vector<description::Image> images;
};

// `path` is the MTL's own; textures are looked for beside it.
[[nodiscard]] MtlLibrary parse_mtl(const std::string& path, std::string_view text, MtlUse use,
                                   Diagnostics& diagnostics);

}  // namespace candela::obj
