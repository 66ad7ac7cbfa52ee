// Paths on plain surfaces of one model, side by side: loops over lanes around the very functions
// that take a single path's step, written so that the compiler makes vector code of them. What
// lanes hold that no path fills means nothing.
#pragma once

#include <array>

#include "integrators/path/path_step.h"
#include "renderer/material/material.h"
#include "renderer/math/lanes.h"

namespace candela {

// The triangles that rays met, and where (plane_point()).
struct MetLanes {
  // In lanes that nothing has been put in, a triangle with an area seen from straight above.
  MetLanes() {
    corner1.x.fill(1);
    corner2.y.fill(1);
    direction.z.fill(-1);
  }

  Lanes<std::uint32_t> geometry{}, triangle{};  // as Hit has them
  Vec3Lanes corner0, corner1, corner2;          // in the object's space
  LaneMask instanced = 0;                       // of instances:
  Lanes<const Instance*> instance{};
  LaneFlags has_normals{};
  bool any_has_normals = false;         // of the lanes that are filled
  Vec3Lanes normal0, normal1, normal2;  // of the corners, in the object's space
  Lanes<float> u{}, v{};
  Vec3Lanes direction;            // of the rays
  Vec3Lanes throughput;           // of the paths
  Lanes<float> roulette_scale{};  // likewise
  // By find_points(), as SurfacePoint's:
  Vec3Lanes position;
  Vec3Lanes normal;  // the geometric one, on the ray's side
  Vec3Lanes front_normal;
  Lanes<float> offset{};
  LaneFlags is_front{};  // the ray is on the side that the triangle's winding says
  LaneFlags is_flat{};
  bool all_are_flat = true;
  Vec3Lanes shading_normal;  // by find_frames(): that of the shading frame
};

// The lights that the paths' samples were dealt to (Light), and the samples' random numbers.
struct LampLanes {
  LampLanes() { light.fill(Light::none); }

  Lanes<std::uint32_t> light;
  Lanes<float> probability{};  // with which it was picked
  LaneMask awaited = 0;        // whose light is not yet put into what follows (put_lights)
  // Neither a triangle, a quad nor a plain sphere, of which alone there is more:
  LaneFlags is_other{};
  LaneFlags is_triangle{}, is_sphere{}, emits_both_sides{}, faces_inwards{};
  Vec3Lanes position, edge1, edge2, normal, emission;
  Lanes<float> area{}, offset{}, near_distance2{};
  Lanes<float> u_x{}, u_y{};
};

// What lights' samples have (LightSample), and what they bring (DirectLight).
struct LightSampleLanes {
  void set(std::size_t i, const LightSample& sample) {
    wi.set(i, sample.wi);
    radiance.set(i, sample.radiance);
    pdf[i] = sample.pdf;
    is_delta[i] = sample.is_delta ? 1 : 0;
    shadow_origin.set(i, sample.shadow_ray.origin);
    shadow_direction.set(i, sample.shadow_ray.direction);
    shadow_end[i] = sample.shadow_ray.t_max;
  }
  [[nodiscard]] LightSample operator[](std::size_t i) const {
    return {wi[i], radiance[i], pdf[i], is_delta[i] != 0, shadow_ray(i)};
  }
  [[nodiscard]] Ray shadow_ray(std::size_t i) const {
    return {shadow_origin[i], shadow_direction[i], shadow_end[i]};
  }

  Vec3Lanes wi, radiance;
  Lanes<float> pdf{};
  LaneFlags is_delta{};
  Vec3Lanes shadow_origin, shadow_direction;
  Lanes<float> shadow_end{};
  Lanes<float> choice{};   // the probability of the light
  Vec3Lanes contribution;  // by weigh_light()
};

// What the surfaces' materials look at, and the members of Bsdf that the models have.
struct BsdfLanes {
  BsdfLanes() {
    alpha.fill(1);
    coat_eta.fill(1);
    eta.x.fill(1);
  }

  Lanes<const Material*> material{};
  Lanes<Vec2f> uv{};
  Vec3Lanes diffuse, specular, f0, eta, k, transmittance;
  Lanes<float> alpha;
  // What a coat's table says (CoatedLobes): of light from wo, on average, and from wi.
  Lanes<float> coat_eta;
  Lanes<float> transmittance_o{}, mean_transmittance{}, transmittance_i{};
};

// How the paths go on.
struct ScatteredLanes {
  Lanes<std::uint32_t> bounce{};
  Lanes<float> lobe{}, direction_x{}, direction_y{}, roulette{};  // random numbers
  // By scatter():
  Vec3Lanes wi;  // local; of coats
  Vec3Lanes throughput;
  Lanes<float> pdf{};
  Lanes<float> roulette_scale{};  // of delta lobes; others leave it as it is
  Vec3Lanes origin, direction;
};

struct PlainLanes {
  void clear() {
    filled = 0;
    met.any_has_normals = false;
    met.instanced = 0;
  }

  LaneMask filled = 0;
  MetLanes met;
  LampLanes lamps;
  LightSampleLanes light_samples;
  BsdfLanes bsdfs;
  ScatteredLanes scattered;
};

[[nodiscard]] inline SurfacePoint point_of(const MetLanes& met, std::size_t i) {
  SurfacePoint point;
  point.position = met.position[i];
  point.offset = met.offset[i];
  point.geometric_normal = met.normal[i];
  point.is_flat = met.is_flat[i] != 0;
  point.shading = frame_from_normal(met.shading_normal[i]);
  point.receiving_normal = point.shading.z;
  return point;
}

// Of the lanes that are filled.
[[nodiscard]] inline LaneMask filled_mask(const LaneFlags& flags, const PlainLanes& lanes) {
  return mask_of(flags) & lanes.filled;
}

inline constexpr std::array plain_models{
    PlainModel::Diffuse, PlainModel::CookTorrance, PlainModel::SmithCookTorrance,
    PlainModel::Lab,     PlainModel::Conductor,    PlainModel::CoatedDiffuse,
    PlainModel::Mirror,  PlainModel::Glass};

void find_points(PlainLanes& lanes);
void find_frames(PlainLanes& lanes);

// Samples of the lamps: of triangles and quads by area, of spheres by the cone in which they are
// seen. Returns the lanes that are left to others: their lamps are none of these, or want to be
// sampled in another way.
[[nodiscard]] LaneMask sample_lamps(PlainLanes& lanes);

// Samples of a point, spot or directional light, for all lanes; false of others.
[[nodiscard]] bool sample_delta_light(const Light& light, PlainLanes& lanes);

struct LightMasks {
  LaneMask dark = 0;         // there is a light sample, and it brings nothing
  LaneMask shadow_rays = 0;  // to be traced
};
[[nodiscard]] LightMasks weigh_light(PlainModel model, const RenderOptions& options,
                                     PlainLanes& lanes);

struct ScatterMasks {
  LaneMask going_on = 0;
  LaneMask lost = 0;  // of the lanes that would go on those whose rays cannot be traced
};
[[nodiscard]] ScatterMasks scatter(PlainModel model, Roulette roulette, PlainLanes& lanes);

}  // namespace candela
