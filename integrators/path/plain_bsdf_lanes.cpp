// What the surfaces' BSDFs do in lanes: the light that they reflect, and how paths go on.
#include "integrators/path/plain_lanes.h"
#include "renderer/base/vector_widths.h"
#include "renderer/bsdf/coated_lobes.h"

namespace candela {
namespace {

constexpr BsdfModel bsdf_model(PlainModel model) {
  switch (model) {
    case PlainModel::CookTorrance:
    case PlainModel::SmithCookTorrance:
      return BsdfModel::CookTorrance;
    case PlainModel::Lab:
      return BsdfModel::Lab;
    case PlainModel::Conductor:
      return BsdfModel::Conductor;
    case PlainModel::CoatedDiffuse:
      return BsdfModel::CoatedDiffuse;
    case PlainModel::Mirror:
      return BsdfModel::Mirror;
    case PlainModel::Glass:
      return BsdfModel::Dielectric;
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
  if constexpr (model == PlainModel::Mirror)
    return {.model = BsdfModel::Mirror, .diffuse = bsdfs.diffuse[i]};
  if constexpr (model == PlainModel::Glass)
    return {.model = BsdfModel::Dielectric,
            .is_smooth = true,
            .eta = bsdfs.eta[i],
            .transmittance = bsdfs.transmittance[i]};
  return {.model = BsdfModel::CookTorrance,
          .geometry = model == PlainModel::SmithCookTorrance ? GeometryTerm::Smith
                                                             : GeometryTerm::SchlickGgx,
          .alpha = bsdfs.alpha[i],
          .diffuse = bsdfs.diffuse[i],
          .specular = bsdfs.specular[i],
          .f0 = bsdfs.f0[i]};
}

[[nodiscard]] inline CoatedLobes coated_lobes_of(const BsdfLanes& bsdfs, std::size_t i) {
  return {bsdfs.coat_eta[i], Vec2f(bsdfs.alpha[i]), bsdfs.diffuse[i], bsdfs.transmittance_o[i],
          bsdfs.mean_transmittance[i]};
}

template <PlainModel model>
[[nodiscard]] inline BsdfEvaluation evaluate_in_lane(const BsdfLanes& bsdfs, std::size_t i,
                                                     const Vec3f& wo, const Vec3f& wi) {
  if constexpr (model == PlainModel::CoatedDiffuse) {
    return evaluate_coated_lobes(coated_lobes_of(bsdfs, i), wo, wi, bsdfs.transmittance_i[i]);
  } else {
    Bsdf bsdf = bsdf_of<model>(bsdfs, i);
    return evaluate_bsdf<features_of<model>.models>(bsdf, wo, wi);
  }
}

template <PlainModel model>
[[nodiscard]] inline BsdfSample sample_in_lane(const BsdfLanes& bsdfs,
                                               const ScatteredLanes& scattered, std::size_t i,
                                               const Vec3f& wo) {
  if constexpr (model == PlainModel::CoatedDiffuse) {
    Vec3f wi = scattered.wi[i];
    return to_sample(wi, evaluate_in_lane<model>(bsdfs, i, wo, wi));
  } else {
    Bsdf bsdf = bsdf_of<model>(bsdfs, i);
    return sample_bsdf<features_of<model>.models>(
        bsdf, wo, scattered.lobe[i], {scattered.direction_x[i], scattered.direction_y[i]});
  }
}

template <PlainModel model>
[[nodiscard]] inline LightMasks weigh_light_by(const RenderOptions& options, PlainLanes& lanes) {
  const MetLanes& met = lanes.met;
  LightSampleLanes& samples = lanes.light_samples;
  LaneFlags dark, to_trace;
  for (std::size_t i = 0; i < block_size; ++i) {
    SurfacePoint point = point_of(met, i);
    Rgb contribution(0);
    if (samples.pdf[i] > 0) {
      Vec3f wo = point.shading.to_local(-met.direction[i]);
      contribution = unshadowed_contribution<features_of<model>>(
          options, point, {}, samples.wi[i], samples.pdf[i], samples.is_delta[i] != 0,
          samples.choice[i], samples.radiance[i],
          [&](const Vec3f& wi) { return evaluate_in_lane<model>(lanes.bsdfs, i, wo, wi); });
    }
    samples.contribution.set(i, contribution);
  }
  for (std::size_t i = 0; i < block_size; ++i) {
    Rgb contribution = samples.contribution[i];
    dark[i] = flag(is_black(contribution));
    contribution *= met.throughput[i];
    samples.contribution.set(i, contribution);
    Ray shadow_ray = samples.shadow_ray(i);
    to_trace[i] = flag(!is_black(contribution)) & flag(is_traceable(shadow_ray));
  }
  return {filled_mask(dark, lanes), filled_mask(to_trace, lanes)};
}

template <PlainModel model>
[[nodiscard]] inline ScatterMasks scatter_by(Roulette roulette, PlainLanes& lanes) {
  const MetLanes& met = lanes.met;
  ScatteredLanes& scattered = lanes.scattered;
  LaneFlags going_on, lost;
  for (std::size_t i = 0; i < block_size; ++i) {
    const std::uint32_t bounce = scattered.bounce[i];
    const float u = scattered.roulette[i];
    SurfacePoint point = point_of(met, i);
    PathState path;
    path.throughput = met.throughput[i];
    path.roulette_scale = met.roulette_scale[i];
    Ray ray;
    BsdfSample sample =
        sample_in_lane<model>(lanes.bsdfs, scattered, i, point.shading.to_local(-met.direction[i]));
    const std::uint32_t is_scattered = flag(scatter(point, sample, ray, path));
    const std::uint32_t survives =
        is_scattered & flag(survives_roulette(u, bounce, roulette, path));
    const std::uint32_t can_be_traced = flag(is_traceable(ray));
    going_on[i] = survives & can_be_traced;
    lost[i] = survives & (can_be_traced ^ 1);
    scattered.throughput.set(i, path.throughput);
    scattered.pdf[i] = path.bsdf_pdf;
    if constexpr (is_only_delta(model)) scattered.roulette_scale[i] = path.roulette_scale;
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
CANDELA_LANES LightMasks weigh_light_by_smith(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::SmithCookTorrance>(options, lanes);
}
CANDELA_LANES LightMasks weigh_light_by_lab(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::Lab>(options, lanes);
}
CANDELA_LANES LightMasks weigh_light_by_metal(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::Conductor>(options, lanes);
}
CANDELA_LANES LightMasks weigh_light_by_coat(const RenderOptions& options, PlainLanes& lanes) {
  return weigh_light_by<PlainModel::CoatedDiffuse>(options, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_diffuse(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::Diffuse>(roulette, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_glossy(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::CookTorrance>(roulette, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_smith(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::SmithCookTorrance>(roulette, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_lab(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::Lab>(roulette, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_metal(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::Conductor>(roulette, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_coat(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::CoatedDiffuse>(roulette, lanes);
}

CANDELA_LANES ScatterMasks scatter_by_mirror(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::Mirror>(roulette, lanes);
}
CANDELA_LANES ScatterMasks scatter_by_glass(Roulette roulette, PlainLanes& lanes) {
  return scatter_by<PlainModel::Glass>(roulette, lanes);
}

CANDELA_LANES void sample_coats(PlainLanes& lanes) {
  ScatteredLanes& scattered = lanes.scattered;
  for (std::size_t i = 0; i < block_size; ++i) {
    Frame frame = frame_from_normal(lanes.met.shading_normal[i]);
    scattered.wi.set(i,
                     sample_coated_lobes(coated_lobes_of(lanes.bsdfs, i),
                                         frame.to_local(-lanes.met.direction[i]), scattered.lobe[i],
                                         {scattered.direction_x[i], scattered.direction_y[i]}));
  }
}

// A coat's table is asked path by path. `cosine(slot)`: of the direction that light comes from.
template <class Cosine>
void put_transmittances(const Cosine& cosine, PlainLanes& lanes) {
  BsdfLanes& bsdfs = lanes.bsdfs;
  for_each_lane(lanes.filled, [&](std::uint32_t slot) {
    bsdfs.transmittance_i[slot] =
        bsdfs.material[slot]->coat->transmittance(cosine(slot), bsdfs.alpha[slot]);
  });
}

}  // namespace

LightMasks weigh_light(PlainModel model, const RenderOptions& options, PlainLanes& lanes) {
  switch (model) {
    case PlainModel::Diffuse:
      return weigh_light_by_diffuse(options, lanes);
    case PlainModel::CookTorrance:
      return weigh_light_by_glossy(options, lanes);
    case PlainModel::SmithCookTorrance:
      return weigh_light_by_smith(options, lanes);
    case PlainModel::Lab:
      return weigh_light_by_lab(options, lanes);
    case PlainModel::Conductor:
      return weigh_light_by_metal(options, lanes);
    case PlainModel::CoatedDiffuse:
      put_transmittances(
          [&](std::uint32_t slot) {
            return dot(lanes.light_samples.wi[slot], lanes.met.shading_normal[slot]);
          },
          lanes);
      return weigh_light_by_coat(options, lanes);
    case PlainModel::Mirror:
    case PlainModel::Glass:
    case PlainModel::None:
      break;
  }
  return {};
}

ScatterMasks scatter(PlainModel model, Roulette roulette, PlainLanes& lanes) {
  switch (model) {
    case PlainModel::Diffuse:
      return scatter_by_diffuse(roulette, lanes);
    case PlainModel::CookTorrance:
      return scatter_by_glossy(roulette, lanes);
    case PlainModel::SmithCookTorrance:
      return scatter_by_smith(roulette, lanes);
    case PlainModel::Lab:
      return scatter_by_lab(roulette, lanes);
    case PlainModel::Conductor:
      return scatter_by_metal(roulette, lanes);
    case PlainModel::CoatedDiffuse:
      sample_coats(lanes);
      put_transmittances([&](std::uint32_t slot) { return lanes.scattered.wi.z[slot]; }, lanes);
      return scatter_by_coat(roulette, lanes);
    case PlainModel::Mirror:
      return scatter_by_mirror(roulette, lanes);
    case PlainModel::Glass:
      return scatter_by_glass(roulette, lanes);
    case PlainModel::None:
      break;
  }
  return {};
}

}  // namespace candela
