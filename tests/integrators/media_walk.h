// An independent estimate of what a homogeneous medium in a box looks like: an analog random walk
// in double, channel by channel, without light sampling, weights or meshes.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/math/vec.h"
#include "tests/statistics/moments.h"

namespace candela::test {

// A box from -1 to 1 in a sky, with a black square lamp that shines to both sides.
struct BoxOfMedium {
  Vec3d absorption{0.0};
  Vec3d scattering{0.0};
  double asymmetry = 0;
  double ior = 1;  // of the box; 1: nothing but its medium is there
  Vec3d sky{0.0};
  Vec3d lamp_corner{0.0}, lamp_edge1{0.0}, lamp_edge2{0.0};
  Vec3d lamp_radiance{0.0};
};

// The radiance that arrives at `eye` along `direction` (unit, away from it), a channel each.
[[nodiscard]] std::array<statistics::Moments, 3> walked_radiance(const BoxOfMedium& scene,
                                                                 const Vec3d& eye,
                                                                 const Vec3d& direction, int count,
                                                                 std::uint64_t seed);

}  // namespace candela::test
