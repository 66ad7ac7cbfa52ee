#include "integrators/path/plain_lanes.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// Booleans as numbers: what && makes is a branch, which vectors do not have.
[[nodiscard]] constexpr std::uint32_t flag(bool condition) {
  return condition ? 1 : 0;
}
// Of the lanes that are filled.
[[nodiscard]] inline LaneMask filled_mask(const LaneFlags& flags, const PlainLanes& lanes) {
  return mask_of(flags) & ((1u << lanes.size) - 1);
}

[[nodiscard]] inline Light lamp_of(const LampLanes& lamps, std::size_t i) {
  Light light;
  light.emits_both_sides = lamps.emits_both_sides[i] != 0;
  light.position = lamps.position[i];
  light.edge1 = lamps.edge1[i];
  light.edge2 = lamps.edge2[i];
  light.normal = lamps.normal[i];
  light.emission = lamps.emission[i];
  light.area = lamps.area[i];
  light.offset = lamps.offset[i];
  light.near_distance2 = lamps.near_distance2[i];
  return light;
}

constexpr BsdfModel bsdf_model(PlainModel model) {
  switch (model) {
    case PlainModel::CookTorrance:
      return BsdfModel::CookTorrance;
    case PlainModel::Lab:
      return BsdfModel::Lab;
    case PlainModel::Conductor:
      return BsdfModel::Conductor;
    case PlainModel::Diffuse:
    case PlainModel::None:
      break;
  }
  return BsdfModel::Diffuse;
}
template <PlainModel model>
inline constexpr FeatureSet features_of = lane_features.with_models(model_bit(bsdf_model(model)));

template <PlainModel model>
[[nodiscard]] inline Bsdf bsdf_of(const BsdfLanes& bsdfs, std::size_t i) {
  if constexpr (model == PlainModel::Diffuse) return {.diffuse = bsdfs.diffuse[i]};
  if constexpr (model == PlainModel::Lab)
    return {.model = BsdfModel::Lab,
            .alpha = bsdfs.alpha[i],
            .diffuse = bsdfs.diffuse[i],
            .specular = bsdfs.specular[i]};
  if constexpr (model == PlainModel::Conductor)
    return {.model = BsdfModel::Conductor,
            .alpha = bsdfs.alpha[i],
            .eta = bsdfs.eta[i],
            .k = bsdfs.k[i]};
  return {.model = BsdfModel::CookTorrance,
          .alpha = bsdfs.alpha[i],
          .diffuse = bsdfs.diffuse[i],
          .specular = bsdfs.specular[i],
          .f0 = bsdfs.f0[i]};
}

template <PlainModel model>
[[nodiscard]] inline LightMasks weigh_light_by(const RenderOptions& options, PlainLanes& lanes) {
  const MetLanes& met = lanes.met;
  LightSampleLanes& samples = lanes.light_samples;
  LaneFlags dark, to_trace;
  for (std::size_t i = 0; i < block_size; ++i) {
    SurfacePoint point = point_of(met, i);
    Bsdf bsdf = bsdf_of<model>(lanes.bsdfs, i);
    Rgb contribution(0);
    if (samples.pdf[i] > 0)
      contribution = unshadowed_contribution<features_of<model>>(
          options, point, bsdf, {}, point.shading.to_local(-met.direction[i]), samples.wi[i],
          samples.pdf[i], samples.is_delta[i] != 0, samples.choice[i], samples.radiance[i]);
    samples.contribution.set(i, contribution);
  }
  for (std::size_t i = 0; i < block_size; ++i) {
    const std::uint32_t is_valid = flag(samples.pdf[i] > 0);
    Rgb contribution = samples.contribution[i];
    dark[i] = is_valid & flag(is_black(contribution));
    contribution *= met.throughput[i];
    samples.contribution.set(i, contribution);
    Ray shadow_ray = samples.shadow_ray(i);
    to_trace[i] = is_valid & flag(!is_black(contribution)) & flag(is_traceable(shadow_ray));
  }
  return {filled_mask(dark, lanes), filled_mask(to_trace, lanes)};
}

template <PlainModel model>
[[nodiscard]] inline ScatterMasks scatter_by(const RenderOptions& options,
                                             float inverse_roulette_threshold, PlainLanes& lanes) {
  const MetLanes& met = lanes.met;
  ScatteredLanes& scattered = lanes.scattered;
  LaneFlags going_on, lost;
  for (std::size_t i = 0; i < block_size; ++i) {
    StepNumbers numbers;
    numbers.lobe = scattered.lobe[i];
    numbers.direction = {scattered.direction_x[i], scattered.direction_y[i]};
    const std::uint32_t bounce = scattered.bounce[i];
    const float roulette = scattered.roulette[i];
    SurfacePoint point = point_of(met, i);
    Bsdf bsdf = bsdf_of<model>(lanes.bsdfs, i);
    PathState path;
    path.throughput = met.throughput[i];
    path.roulette_scale = met.roulette_scale[i];
    Ray ray;
    const std::uint32_t is_scattered = flag(scatter_from<features_of<model>>(
        options, numbers, {}, point, bsdf, point.shading.to_local(-met.direction[i]), ray, path));
    const std::uint32_t survives =
        is_scattered & flag(survives_roulette(roulette, bounce, inverse_roulette_threshold, path));
    const std::uint32_t can_be_traced = flag(is_traceable(ray));
    going_on[i] = survives & can_be_traced;
    lost[i] = survives & (can_be_traced ^ 1);
    scattered.throughput.set(i, path.throughput);
    scattered.pdf[i] = path.bsdf_pdf;
    scattered.origin.set(i, ray.origin);
    scattered.direction.set(i, ray.direction);
  }
  return {filled_mask(going_on, lanes), filled_mask(lost, lanes)};
}

CANDELA_LANES LightMasks weigh_light_by_diffuse(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::Diffuse>(options, lanes);
}
CANDELA_LANES LightMasks weigh_light_by_glossy(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::CookTorrance>(options, lanes);
}
CANDELA_LANES LightMasks weigh_light_by_lab(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::Lab>(options, lanes);
}
CANDELA_LANES LightMasks weigh_light_by_metal(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::Conductor>(options, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_metal(const RenderOptions& options, float inverse_threshold,
                                            PlainLanes& lanes) {
  return scatter_by<PlainModel::Conductor>(options, inverse_threshold, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_diffuse(const RenderOptions& options, float inverse_threshold,
                                              PlainLanes& lanes) {
  return scatter_by<PlainModel::Diffuse>(options, inverse_threshold, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_glossy(const RenderOptions& options, float inverse_threshold,
                                             PlainLanes& lanes) {
  return scatter_by<PlainModel::CookTorrance>(options, inverse_threshold, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_lab(const RenderOptions& options, float inverse_threshold,
                                          PlainLanes& lanes) {
  return scatter_by<PlainModel::Lab>(options, inverse_threshold, lanes);
}

CANDELA_LANES void find_planes(MetLanes& met) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    surface_point_detail::PlanePoint<Vec3f> plane = surface_point_detail::plane_point(
        met.corner0[i], met.corner1[i], met.corner2[i], met.u[i], met.v[i]);
    const bool is_front = dot(plane.normal, -met.direction[i]) > 0;
    met.position.set(i, plane.position);
    met.front_normal.set(i, plane.normal);
    met.normal.set(i, is_front ? plane.normal : -plane.normal);
    met.offset[i] = plane.offset;
  }
}

CANDELA_LANES void find_front_normals(MetLanes& met) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const float u = met.u[i];
    const float v = met.v[i];
    SurfacePoint point;
    point.front_normal = met.front_normal[i];
    Vec3f n = met.normal0[i] * (1 - u - v) + met.normal1[i] * u + met.normal2[i] * v;
    if (met.has_normals[i] == 0) n = Vec3f(0);
    surface_point_detail::set_front_normal(n, point);
    met.front_normal.set(i, point.front_normal);
    met.is_flat[i] = flag(point.is_flat);
  }
}

CANDELA_LANES void find_bent_frames(MetLanes& met) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    SurfacePoint point;
    point.front_normal = met.front_normal[i];
    point.geometric_normal = met.normal[i];
    point.is_flat = met.is_flat[i] != 0;
    set_shading_frame(point, -met.direction[i]);
    met.shading_normal.set(i, point.shading.z);
  }
}

// By value: stores to the lanes cannot change the light.
CANDELA_LANES void sample_point_light_in_lanes(Light light, PlainLanes& lanes) {
  for (std::size_t i = 0; i < block_size; ++i)
    lanes.light_samples.set(
        i, sample_from_point(light, point_of(lanes.met, i), [](const Vec3f&) { return 1.0f; }));
}
CANDELA_LANES void sample_spot_light_in_lanes(Light light, PlainLanes& lanes) {
  for (std::size_t i = 0; i < block_size; ++i)
    lanes.light_samples.set(
        i, sample_from_point(light, point_of(lanes.met, i),
                             [&](const Vec3f& w) { return spot_falloff(light, w); }));
}
CANDELA_LANES void sample_directional_light_in_lanes(Light light, PlainLanes& lanes) {
  for (std::size_t i = 0; i < block_size; ++i)
    lanes.light_samples.set(i, sample_directional_light(light, point_of(lanes.met, i)));
}

}  // namespace

void find_points(PlainLanes& lanes) {
  MetLanes& met = lanes.met;
  find_planes(met);
  met.is_flat.fill(1);
  met.all_are_flat = !met.any_has_normals;
  if (met.any_has_normals) find_front_normals(met);
}

void find_frames(PlainLanes& lanes) {
  MetLanes& met = lanes.met;
  if (met.all_are_flat)
    met.shading_normal = met.normal;
  else
    find_bent_frames(met);
}

CANDELA_LANES LaneMask sample_lamps(PlainLanes& lanes) {
  const LampLanes& lamps = lanes.lamps;
  LaneFlags left;
  for (std::size_t i = 0; i < block_size; ++i) {
    SurfacePoint point = point_of(lanes.met, i);
    Light light = lamp_of(lamps, i);
    const Vec2f u{lamps.u_x[i], lamps.u_y[i]};
    Vec2f weights = square_to_triangle(u);
    if (lamps.is_triangle[i] == 0) weights = u;
    left[i] = lamps.is_other[i] |
              (flag(lamps.is_triangle[i] == 0) & flag(is_near(light, point.position)));
    lanes.light_samples.set(i, light_from_place(light, point, weights));
    lanes.light_samples.choice[i] = lamps.probability[i];
  }
  return filled_mask(left, lanes);
}

bool sample_delta_light(const Light& light, PlainLanes& lanes) {
  switch (light.kind) {
    case LightKind::Point:
      sample_point_light_in_lanes(light, lanes);
      return true;
    case LightKind::Spot:
      sample_spot_light_in_lanes(light, lanes);
      return true;
    case LightKind::Directional:
      sample_directional_light_in_lanes(light, lanes);
      return true;
    default:
      return false;
  }
}

LightMasks weigh_light(PlainModel model, const RenderOptions& options, PlainLanes& lanes) {
  switch (model) {
    case PlainModel::Diffuse:
      return weigh_light_by_diffuse(options, lanes);
    case PlainModel::CookTorrance:
      return weigh_light_by_glossy(options, lanes);
    case PlainModel::Lab:
      return weigh_light_by_lab(options, lanes);
    case PlainModel::Conductor:
      return weigh_light_by_metal(options, lanes);
    case PlainModel::None:
      break;
  }
  return {};
}

ScatterMasks scatter(PlainModel model, const RenderOptions& options,
                     float inverse_roulette_threshold, PlainLanes& lanes) {
  switch (model) {
    case PlainModel::Diffuse:
      return scatter_by_diffuse(options, inverse_roulette_threshold, lanes);
    case PlainModel::CookTorrance:
      return scatter_by_glossy(options, inverse_roulette_threshold, lanes);
    case PlainModel::Lab:
      return scatter_by_lab(options, inverse_roulette_threshold, lanes);
    case PlainModel::Conductor:
      return scatter_by_metal(options, inverse_roulette_threshold, lanes);
    case PlainModel::None:
      break;
  }
  return {};
}

}  // namespace candela
