// Paths on flat surfaces, sixteen side by side: loops over lanes around the very functions that
// take a single path's step, written so that the compiler makes vector code of them. Lanes that
// hold no such path are calculated along and mean nothing.
#pragma once

#include "integrators/path/block_numbers.h"

namespace candela {

template <class T>
using Lanes = SamplerLanes<T>;
using LaneFlags = Lanes<std::uint32_t>;  // 1 in lanes where something holds, else 0

struct Vec3Lanes {
  Lanes<float> x{}, y{}, z{};

  [[nodiscard]] Vec3f operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3f& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

// The triangles that rays met, and where (plane_point()).
struct MetLanes {
  // In lanes that nothing has been put in, a triangle with an area.
  MetLanes() {
    corner1.x.fill(1);
    corner2.y.fill(1);
  }

  Vec3Lanes corner0, corner1, corner2;
  Lanes<float> u{}, v{};
  Vec3Lanes direction;   // of the rays
  Vec3Lanes throughput;  // of the paths
  // By find_points():
  Vec3Lanes position;
  Vec3Lanes normal;  // the geometric one, on the ray's side
  Lanes<float> offset{};
};

// The emitting triangles and quads that the paths' light samples were dealt to (Light), and those
// samples (LightSample).
struct LampLanes {
  Lanes<std::uint32_t> light{};
  LaneFlags is_triangle{}, emits_both_sides{};
  Vec3Lanes position, edge1, edge2, normal, emission;
  Lanes<float> area{}, offset{}, near_distance2{};
  Lanes<float> probability{};
  Lanes<float> u_x{}, u_y{};  // random numbers
  // By sample_lamps():
  Vec3Lanes wi, radiance;
  Lanes<float> pdf{};
  Vec3Lanes shadow_origin, shadow_direction;
  // By weigh_lamps(), as DirectLight's:
  Vec3Lanes contribution;
};

// The members of Bsdf that the models have; GGX with Schlick's terms where there is a highlight.
struct BsdfLanes {
  BsdfLanes() { alpha.fill(1); }

  Vec3Lanes diffuse, specular, f0;
  Lanes<float> alpha;
};

// How the paths go on, by scatter().
struct ScatteredLanes {
  Vec3Lanes throughput;
  Lanes<float> pdf{};
  Vec3Lanes origin, direction;
};

struct FlatLanes {
  MetLanes met;
  LampLanes lamps;
  BsdfLanes bsdfs;
  ScatteredLanes scattered;
};

// With its frame.
[[nodiscard]] inline SurfacePoint point_of(const MetLanes& met, std::size_t i) {
  SurfacePoint point;
  point.position = met.position[i];
  point.offset = met.offset[i];
  point.geometric_normal = met.normal[i];
  set_shading_frame(point, -met.direction[i]);
  point.receiving_normal = point.shading.z;
  return point;
}

enum class FlatModel : std::uint8_t { Diffuse, CookTorrance };

void find_points(MetLanes& met);

// Returns the lanes that are left to others, since the lamp wants to be sampled by solid angle.
[[nodiscard]] LaneMask sample_lamps(FlatLanes& lanes);

// Of the lanes whose surfaces are of the model.
struct LampMasks {
  LaneMask dark = 0;         // there is a light sample, and it brings nothing
  LaneMask shadow_rays = 0;  // to be traced
};
[[nodiscard]] LampMasks weigh_lamps(FlatModel model, const RenderOptions& options,
                                    FlatLanes& lanes);

struct ScatterMasks {
  LaneMask going_on = 0;
  LaneMask traceable = 0;  // whose ray is
};
[[nodiscard]] ScatterMasks scatter(FlatModel model, const RenderOptions& options,
                                   const BlockNumbers& numbers, std::uint32_t bounce,
                                   float inverse_roulette_threshold, FlatLanes& lanes);

}  // namespace candela
