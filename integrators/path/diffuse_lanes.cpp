#include "integrators/path/diffuse_lanes.h"

#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

constexpr FeatureSet diffuse_features = plain_features.with_models(model_bit(BsdfModel::Diffuse));
const Vec3f any_direction{0, 0, 1};  // to where the path comes from: Lambert's law does not ask

// Booleans as numbers: what && makes is a branch, which vectors do not have.
[[nodiscard]] constexpr std::uint32_t flag(bool condition) {
  return condition ? 1 : 0;
}
[[nodiscard]] inline LaneMask mask_of(const LaneFlags& flags) {
  LaneMask mask = 0;
  for (std::uint32_t i = 0; i < block_size; ++i) mask |= flags[i] << i;
  return mask;
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

}  // namespace

CANDELA_EACH_VECTOR_WIDTH [[gnu::flatten]] void find_points(MetLanes& met) {
  for (std::size_t i = 0; i < block_size; ++i) {
    surface_point_detail::PlanePoint<Vec3f> plane = surface_point_detail::plane_point(
        met.corner0[i], met.corner1[i], met.corner2[i], met.u[i], met.v[i]);
    const bool is_front = dot(plane.normal, -met.direction[i]) > 0;
    met.position.set(i, plane.position);
    met.normal.set(i, is_front ? plane.normal : -plane.normal);
    met.offset[i] = plane.offset;
  }
}

CANDELA_EACH_VECTOR_WIDTH [[gnu::flatten]] LampMasks sample_lamps(const RenderOptions& options,
                                                                  DiffuseLanes& lanes) {
  const MetLanes& met = lanes.met;
  LampLanes& lamps = lanes.lamps;
  LaneFlags near, dark, to_trace;
  for (std::size_t i = 0; i < block_size; ++i) {
    SurfacePoint point = point_of(met, i);
    Light light = lamp_of(lamps, i);
    const Vec2f u{lamps.u_x[i], lamps.u_y[i]};
    Vec2f weights = square_to_triangle(u);
    if (lamps.is_triangle[i] == 0) weights = u;
    near[i] = flag(lamps.is_triangle[i] == 0) & flag(is_near(light, point.position));
    LightSample sample = light_from_place(light, point, weights);
    Bsdf bsdf{.diffuse = met.reflectance[i]};
    Rgb contribution(0);
    if (sample.is_valid())
      contribution = unshadowed_contribution<diffuse_features>(
          options, point, bsdf, {}, any_direction, sample.wi, sample.pdf, false,
          lamps.probability[i], sample.radiance);
    lamps.pdf[i] = sample.pdf;
    lamps.contribution.set(i, contribution);
    lamps.shadow_origin.set(i, sample.shadow_ray.origin);
    lamps.shadow_direction.set(i, sample.shadow_ray.direction);
  }
  for (std::size_t i = 0; i < block_size; ++i) {
    Rgb contribution = lamps.contribution[i];
    dark[i] = flag(lamps.pdf[i] > 0) & flag(is_black(contribution));
    contribution *= met.throughput[i];
    lamps.contribution.set(i, contribution);
    Ray shadow_ray{lamps.shadow_origin[i], lamps.shadow_direction[i]};
    to_trace[i] = flag(!is_black(contribution)) & flag(is_traceable(shadow_ray));
  }
  return {mask_of(near), mask_of(dark), mask_of(to_trace)};
}

CANDELA_EACH_VECTOR_WIDTH [[gnu::flatten]] ScatterMasks scatter(const RenderOptions& options,
                                                                const BlockNumbers& numbers,
                                                                std::uint32_t bounce,
                                                                float inverse_roulette_threshold,
                                                                DiffuseLanes& lanes) {
  const MetLanes& met = lanes.met;
  ScatteredLanes& scattered = lanes.scattered;
  LaneFlags going_on, traceable;
  for (std::size_t i = 0; i < block_size; ++i) {
    const StepNumbers own = numbers.lane<diffuse_features>(i);
    const float roulette = own.roulette;
    SurfacePoint point = point_of(met, i);
    Bsdf bsdf{.diffuse = met.reflectance[i]};
    PathState path;
    path.throughput = met.throughput[i];
    Ray ray;
    const std::uint32_t is_scattered = flag(
        scatter_from<diffuse_features>(options, own, {}, point, bsdf, any_direction, ray, path));
    going_on[i] =
        is_scattered & flag(survives_roulette(roulette, bounce, inverse_roulette_threshold, path));
    traceable[i] = flag(is_traceable(ray));
    scattered.throughput.set(i, path.throughput);
    scattered.pdf[i] = path.bsdf_pdf;
    scattered.origin.set(i, ray.origin);
    scattered.direction.set(i, ray.direction);
  }
  return {mask_of(going_on), mask_of(traceable)};
}

}  // namespace candela
