// Splitting [Arvo90]: from the first hit of a camera ray several paths go on, one after the other,
// and count as their mean. What lies before, the camera ray and the light that comes straight from
// lights, is paid once; it pays where that brings little of the noise. Scenes with media are not
// split: what a camera ray meets there is a matter of chance.
#pragma once

#include <optional>

#include "integrators/path/fill_plain_lanes.h"

namespace candela {

// Another path from the first hit of lane i; false where it ends there. Out of line: most renders
// do without.
template <FeatureSet F, class A>
[[nodiscard, gnu::noinline]] bool branch_off(const PathContext<A>& context,
                                             const StepNumbers& numbers, std::uint32_t i,
                                             PathBlock& block) {
  const Hit hit = block.split.hits[i];
  const Scene& scene = context.scene;
  if (!hit.is_hit() || context.max_depth == 0) return false;
  Ray ray = block.split.camera_rays[i];
  Vec3f wo = -ray.direction;
  SurfacePoint point = met_point_at<F>(scene, hit, wo);
  const Material& material =
      material_at(scene, scene.geometries[hit.geometry], point, numbers.material);
  set_material_frame(scene, material, wo, point);
  PathState path;
  path.light_cell = light_cell_at(scene, ray, hit.t, 0);
  Bsdf bsdf = bsdf_at(material, scene.textures, texture_point_of(point), point.is_front);
  const bool goes_on =
      scatter_from<F>(context.options, numbers, guide_at<F>(context.guide, point, bsdf), point,
                      bsdf, point.shading.to_local(wo), ray, path) &&
      survives_roulette(numbers.roulette, 0, context.roulette, path);
  block.paths.set(i, path);
  return goes_on && set_ray(block, i, ray);
}

class Branches {
 public:
  Branches() = default;  // unsplit
  // Of each of the sixteen samples of the pixel that begin with first_sample.
  Branches(const PixelSampler& pixel, std::uint32_t first_sample, std::uint32_t splitting)
      : pixel_(&pixel), first_sample_(first_sample), splitting_(splitting) {}

  [[nodiscard]] bool is_split() const { return splitting_ > 1; }
  // The running branch's random numbers; those of the samples themselves where there is but one.
  [[nodiscard]] const SamplerBlock& samplers(const SamplerBlock& unsplit) const {
    return own_ ? *own_ : unsplit;
  }

  void begin(LaneMask lanes, PathBlock& block) {
    lanes_ = lanes;
    block.split.camera_rays = block.rays;
    draw_branch();
  }
  // What the first hit itself brought is no branch's.
  void keep_direct_light(PathBlock& block) const {
    for_each_lane(lanes_, [&](std::uint32_t i) {
      block.split.radiance.set(i, block.paths.radiance[i]);
      block.paths.radiance.set(i, Rgb(0));
    });
  }
  // The running branch has ended; false where it was the last.
  [[nodiscard]] bool next(PathBlock& block) {
    const float share = 1.0f / static_cast<float>(splitting_);
    for_each_lane(lanes_, [&](std::uint32_t i) {
      block.split.radiance.set(i, block.split.radiance[i] + block.paths.radiance[i] * share);
      block.paths.radiance.set(i, Rgb(0));
    });
    return ++branch_ < splitting_;
  }
  // The next branch's paths leave the first hits, whose own numbers are `unsplit`; returns those
  // that go on.
  template <FeatureSet F, class A>
  [[nodiscard]] LaneMask start(const PathContext<A>& context, const SamplerBlock& unsplit,
                               PathBlock& block, PlainLanes& lanes) {
    draw_branch();
    BlockNumbers numbers;
    numbers.draw_material(context.scene, unsplit, 0);
    numbers.draw_direction<F>(context.scene, context.roulette, *own_, 0);
    LaneMask going_on = 0;
    LaneMask single = lanes_;
    if constexpr (F.lanes) {
      PlainMasks plain_lanes;
      find_plain_lanes(context.scene, block.split.hits, lanes_, plain_lanes);
      for (const PlainModel model : plain_models)
        going_on |=
            branch_plain_lanes<F>(context, numbers, model, plain_lanes.of(model), block, lanes);
      single &= ~plain_lanes.all();
    }
    for_each_lane(single, [&](std::uint32_t i) {
      if (branch_off<F>(context, numbers.lane<F>(i), i, block)) going_on |= 1u << i;
    });
    return going_on;
  }
  void end(PathBlock& block) const {
    for_each_lane(lanes_,
                  [&](std::uint32_t i) { block.paths.radiance.set(i, block.split.radiance[i]); });
  }

 private:
  void draw_branch() { own_.emplace(*pixel_, first_sample_, splitting_, branch_); }

  const PixelSampler* pixel_ = nullptr;
  std::uint32_t first_sample_ = 0;
  std::uint32_t splitting_ = 1;
  std::uint32_t branch_ = 0;
  LaneMask lanes_ = 0;
  std::optional<SamplerBlock> own_;
};

}  // namespace candela
