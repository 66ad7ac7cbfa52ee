#include "integrators/path/reflectance_lanes.h"

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"
#include "renderer/material/bsdf_at.h"
#include "renderer/math/lanes_power.h"

namespace candela {
namespace {

template <class Bound>
inline void decode(const LaneFlags& are_decoded, Vec3Lanes& colours, const Bound& bound) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const Vec3f colour = colours[i];
    const Vec3f decoded =
        bound(Vec3f(power_2_2(colour.x), power_2_2(colour.y), power_2_2(colour.z)));
    colours.set(i, are_decoded[i] != 0 ? decoded : colour);
  }
}

CANDELA_LANES void decode_all(const LaneFlags& are_decoded, Vec3Lanes& colours) {
  decode(are_decoded, colours, [](const Vec3f& colour) { return colour; });
}
CANDELA_LANES void decode_and_clamp(const LaneFlags& are_decoded, Vec3Lanes& colours) {
  decode(are_decoded, colours, [](const Vec3f& colour) { return clamp_unit(colour); });
}

CANDELA_LANES void limit_all(Vec3Lanes& diffuse, Vec3Lanes& specular) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    Rgb d = diffuse[i], s = specular[i];
    limit_reflectance(d, s);
    diffuse.set(i, d);
    specular.set(i, s);
  }
}

}  // namespace

void decode_gamma(LaneMask lanes, Vec3Lanes& colours) {
  const FloatingPointTraps traps(Traps::Off);  // lanes that nothing is in
  decode_all(flags_of(lanes), colours);
}

void decode_reflectance(LaneMask lanes, Vec3Lanes& colours) {
  const FloatingPointTraps traps(Traps::Off);
  decode_and_clamp(flags_of(lanes), colours);
}

void limit_reflectances(Vec3Lanes& diffuse, Vec3Lanes& specular) {
  const FloatingPointTraps traps(Traps::Off);
  limit_all(diffuse, specular);
}

}  // namespace candela
