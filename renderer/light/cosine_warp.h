// The cosine at a receiving surface, as a density over the unit square whose corners are the
// corners of a lamp: what samples by solid angle lack to those by what arrives [Hart20].
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "renderer/math/float4.h"
#include "renderer/sampling/bilinear.h"

namespace candela {

// The corners as the receiver sees them, in the order of BilinearDensity's weights.
struct CornerLanes {
  Float4 x, y, z;
};

// The receiver's cosines towards the corners, none of them far below the others: between them they
// may be larger. Nothing where all of them are below its horizon; even where its normal is 0.
[[nodiscard]] inline std::optional<BilinearDensity> cosine_warp(const CornerLanes& corners,
                                                                const Vec3f& normal) {
  constexpr float least_weight = 0.05f;
  constexpr float least_share = 0.1f;  // of the largest
  if (normal == Vec3f(0)) return BilinearDensity{};
  const Float4 x = corners.x;
  const Float4 y = corners.y;
  const Float4 z = corners.z;
  const Float4 height = x * normal.x + y * normal.y + z * normal.z;
  const Float4 distance2 = x * x + y * y + z * z;  // 0 where the receiver touches a corner
  const Float4 cosine =
      height / square_root(max(distance2, broadcast(std::numeric_limits<float>::min())));
  const float most = std::max(std::max(cosine[0], cosine[1]), std::max(cosine[2], cosine[3]));
  if (!(most > 0)) return std::nullopt;
  const float least = std::max(least_weight, least_share * most);
  return BilinearDensity{std::max(least, cosine[0]), std::max(least, cosine[1]),
                         std::max(least, cosine[2]), std::max(least, cosine[3])};
}

}  // namespace candela
