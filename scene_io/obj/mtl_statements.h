// What an MTL file says, before it is given a meaning.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/math/vec.h"
#include "scene_io/obj/read_obj.h"
#include "scene_io/text/source.h"

namespace candela::obj {

struct MtlTexture {
  std::string path;  // resolved
  SourceSpan span;
  double bump_multiplier = 1.0;  // -bm
  bool is_clamped = false;       // -clamp on
  std::optional<char> channel;   // -imfchan: r g b m l z
};

struct MtlStatements {
  std::string name;
  SourceSpan span;
  std::optional<Vec3d> kd, ks, ke, tf;
  std::optional<double> ns, ni, d, tr, pr, pm;
  std::optional<int> illum;
  std::optional<MtlTexture> map_kd, map_ks, map_ke, map_d, map_pr, bump, norm;
};

// One entry for each newmtl; of equal names all are kept. With MtlUse::Lab statements that have no
// meaning there are not even looked at.
[[nodiscard]] std::vector<MtlStatements> parse_mtl_statements(const std::string& path,
                                                              const text::Source& source,
                                                              MtlUse use, Diagnostics& diagnostics);

}  // namespace candela::obj
