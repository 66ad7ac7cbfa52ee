// The random numbers that the paths of a block take at one bounce.
#pragma once

#include "integrators/path/path_step.h"
#include "renderer/accel/ray_block.h"
#include "renderer/sampling/sampler_block.h"

namespace candela {

[[nodiscard]] inline Vec2f unit_point(const SobolPointLanes& points, std::size_t lane) {
  return {unit_float(points.x[lane]), unit_float(points.y[lane])};
}

// Whether anything in the scene reads the number that picks a lobe.
[[nodiscard]] inline bool needs_lobes(const Scene& scene) {
  return (scene.features.bsdf_models & models_with_lobes) != 0;
}

class BlockNumbers {
 public:
  // Of what a scene has no use for, nothing is drawn. First, what a hit itself takes.
  template <FeatureSet F>
  void draw_hit(const Scene& scene, const SamplerBlock& samplers, std::uint32_t bounce) {
    if (scene.light_sampler.has_table()) {
      samplers.sample_2d(bounce, Dimension::LightPoint, light_point_);
      if (scene.light_sampler.tells_rest())
        light_choice_ = light_point_.x;
      else
        samplers.sample_1d(bounce, Dimension::LightChoice, light_choice_);
    }
    if constexpr (F.media) {
      free_flight_ = {};
      if (scene.features.scattering_media)
        samplers.sample_1d(bounce, Dimension::FreeFlight, free_flight_);
    }
    draw_material(scene, samplers, bounce);
  }
  void draw_material(const Scene& scene, const SamplerBlock& samplers, std::uint32_t bounce) {
    if (scene.features.mixes) samplers.sample_1d(bounce, Dimension::MaterialChoice, material_);
  }
  // What a path takes that goes on.
  template <FeatureSet F>
  void draw_direction(const Scene& scene, Roulette roulette, const SamplerBlock& samplers,
                      std::uint32_t bounce) {
    if (needs_lobes(scene)) samplers.sample_1d(bounce, Dimension::LobeChoice, lobe_);
    samplers.sample_2d(bounce, Dimension::Direction, direction_);
    if constexpr (F.guided) samplers.sample_1d(bounce, Dimension::GuideChoice, guide_choice_);
    if (bounce >= roulette.first_bounce) samplers.sample_1d(bounce, Dimension::Roulette, roulette_);
  }

  [[nodiscard]] std::uint32_t light_choice(std::size_t i) const { return light_choice_[i]; }
  [[nodiscard]] Vec2f light_point(std::size_t i) const { return unit_point(light_point_, i); }
  [[nodiscard]] const Lanes<std::uint32_t>& lobe() const { return lobe_; }
  [[nodiscard]] const SobolPointLanes& direction() const { return direction_; }
  [[nodiscard]] const Lanes<std::uint32_t>& roulette() const { return roulette_; }

  template <FeatureSet F>
  [[nodiscard]] StepNumbers lane(std::size_t i) const {
    return {light_choice_[i],
            unit_point(light_point_, i),
            unit_float(lobe_[i]),
            unit_point(direction_, i),
            unit_float(roulette_[i]),
            unit_float(material_[i]),
            F.media ? free_flight_[i] : 0,
            F.guided ? unit_float(guide_choice_[i]) : 0};
  }

 private:
  Lanes<std::uint32_t> light_choice_{};
  SobolPointLanes light_point_{};
  Lanes<std::uint32_t> lobe_{};
  SobolPointLanes direction_{};
  Lanes<std::uint32_t> roulette_{};
  Lanes<std::uint32_t> material_{};
  Lanes<std::uint32_t> free_flight_{};
  // Not even set in kernels without guides.
  Lanes<std::uint32_t> guide_choice_;
};

// The same for a single sample.
template <FeatureSet F>
inline void draw_hit(const Scene& scene, const Sampler& sampler, std::uint32_t bounce,
                     StepNumbers& numbers) {
  if (scene.light_sampler.has_table()) {
    const SobolPoint point = sampler.sample_2d_bits(bounce, Dimension::LightPoint);
    numbers.light_point = {unit_float(point.x), unit_float(point.y)};
    numbers.light_choice = scene.light_sampler.tells_rest()
                               ? point.x
                               : sampler.sample_1d_bits(bounce, Dimension::LightChoice);
  }
  if (scene.features.mixes) numbers.material = sampler.sample_1d(bounce, Dimension::MaterialChoice);
  if (F.media && scene.features.scattering_media)
    numbers.free_flight = sampler.sample_1d_bits(bounce, Dimension::FreeFlight);
}
// Of surfaces that scatter into single directions alone, which no light sample reaches.
inline void draw_delta(const Scene& scene, Roulette roulette, const Sampler& sampler,
                       std::uint32_t bounce, StepNumbers& numbers) {
  if (needs_lobes(scene)) numbers.lobe = sampler.sample_1d(bounce, Dimension::LobeChoice);
  if (bounce >= roulette.first_bounce)
    numbers.roulette = sampler.sample_1d(bounce, Dimension::Roulette);
}
template <FeatureSet F>
inline void draw_direction(const Scene& scene, Roulette roulette, const Sampler& sampler,
                           std::uint32_t bounce, StepNumbers& numbers) {
  draw_delta(scene, roulette, sampler, bounce, numbers);
  numbers.direction = sampler.sample_2d(bounce, Dimension::Direction);
  if constexpr (F.guided) numbers.guide_choice = sampler.sample_1d(bounce, Dimension::GuideChoice);
}

}  // namespace candela
