// The steps of those paths that met plain surfaces, from several blocks at once: what step_lane()
// does, bit by bit.
#pragma once

#include "integrators/path/fill_plain_lanes.h"
#include "integrators/path/trace_block.h"

namespace candela {

// Paths on plain surfaces of one model that wait until they are enough to take their steps
// together.
template <FeatureSet F, class A>
class PlainSteps {
 public:
  explicit PlainSteps(PlainLanes& lanes) : lanes_(lanes) {}

  void add(BlockTrip<A>& trip, std::uint32_t lane, PlainModel model) {
    places_[size_++] = {&trip, lane};
    if (size_ == block_size) step(model);
  }
  void end(PlainModel model) {
    constexpr std::uint32_t fewest = 4;  // that are worth it
    if (size_ >= fewest) return step(model);
    for (std::uint32_t i = 0; i < size_; ++i) step_lane<F>(*places_[i].trip, places_[i].lane);
    size_ = 0;
  }

 private:
  struct Place {
    BlockTrip<A>* trip;
    std::uint32_t lane;
  };

  void step(PlainModel model) {
    fill();
    size_ = 0;
    if (lanes_.size == 0) return;
    find_surfaces(model, scene(), lanes_);
    for (const std::uint32_t index : lights().always()) add_light_of(index, model);
    if (lights().has_table()) add_picked_light(model);
    scatter_paths(model);
  }

  [[nodiscard]] const PathContext<A>& context() const { return places_[0].trip->context; }
  [[nodiscard]] const Scene& scene() const { return context().scene; }
  [[nodiscard]] const LightSampler& lights() const { return scene().light_sampler; }

  // Those that are as deep as paths may be end here.
  void fill() {
    lanes_.clear();
    for (std::uint32_t k = 0; k < size_; ++k) {
      const Place place = places_[k];
      meet_surface(place);
      BlockTrip<A>& trip = *place.trip;
      if (trip.bounce >= trip.context.max_depth) continue;
      const StepNumbers numbers = numbers_of<F>(trip, place.lane);
      put_path(scene(), numbers, trip.bounce, trip.block.hits[place.lane],
               trip.block.rays[place.lane], trip.block.paths[place.lane], lanes_.size, lanes_);
      if (lights().has_table()) put_lamp(scene(), numbers, lanes_.size, lanes_.lamps);
      places_[lanes_.size++] = place;
    }
  }

  void meet_surface(const Place& place) {
    const PathContext<A>& context = place.trip->context;
    PathBlock& block = place.trip->block;
    const Hit hit = block.hits[place.lane];
    const Ray ray = block.rays[place.lane];
    const Geometry& geometry = context.scene.geometries[hit.geometry];
    if (is_emission_met(context, geometry, place.trip->bounce))
      add_emission<F>(context.scene, context.options, geometry, hit, ray.origin, ray.direction,
                      hit.t, block.paths[place.lane]);
    if (place.trip->bounce == 0 && context.options.aovs != 0)
      record_camera_hit<F>(context.scene, context.camera, ray, hit,
                           context.scene.materials[geometry.material.index],
                           block.samples[place.lane]);
  }

  // Of a light that is sampled at every hit.
  void add_light_of(std::uint32_t index, PlainModel model) {
    lanes_.light_samples.choice.fill(1);
    if (!sample_delta_light(scene().lights[index], lanes_))
      for (std::uint32_t slot = 0; slot < lanes_.size; ++slot) sample_alone(slot, index, Vec2f(0));
    for_each_lane(weighed_light(model), [&](std::uint32_t slot) {
      BlockTrip<A>& trip = *places_[slot].trip;
      const LightSampleLanes& samples = lanes_.light_samples;
      const DirectLight light{samples.contribution[slot], samples.shadow_ray(slot)};
      Rgb& radiance = trip.block.paths[places_[slot].lane].radiance;
      if constexpr (F.media)
        radiance += shadowed_in(context(), light, MediumHandle{}, trip.counts);
      else
        radiance += shadowed(context().accelerator, light, trip.counts);
    });
  }

  void add_picked_light(PlainModel model) {
    const LampLanes& lamps = lanes_.lamps;
    const LightSampleLanes& samples = lanes_.light_samples;
    LaneMask skies = 0;
    for_each_lane(sample_lamps(lanes_), [&](std::uint32_t slot) {
      if (sample_alone(slot, lamps.light[slot], {lamps.u_x[slot], lamps.u_y[slot]}))
        skies |= 1u << slot;
    });
    for_each_lane(weighed_light(model), [&](std::uint32_t slot) {
      const Place& place = places_[slot];
      PathBlock& block = place.trip->block;
      block.shadow_rays.set(place.lane, samples.shadow_ray(slot));
      block.unshadowed[place.lane] = samples.contribution[slot];
      if constexpr (F.media) block.shadow_media[place.lane] = {};
      place.trip->after.shadow_rays |= 1u << place.lane;
      place.trip->after.sky_rays |= (skies >> slot & 1u) << place.lane;
    });
  }

  // Of a light that lanes know nothing of; true where it is the sky, whose radiance is still to
  // come (next_event.h).
  [[gnu::noinline]] bool sample_alone(std::uint32_t slot, std::uint32_t light, Vec2f u) {
    const LightOrSky sample = sample_light_or_sky<F>(scene(), light, point_of(lanes_.met, slot), u);
    lanes_.light_samples.set(slot, sample.light);
    return sample.is_sky;
  }

  // Returns the lanes whose shadow rays are to be traced.
  [[nodiscard]] LaneMask weighed_light(PlainModel model) {
    const LightMasks masks = weigh_light(model, context().options, lanes_);
    for_each_lane(masks.dark,
                  [&](std::uint32_t slot) { ++places_[slot].trip->counts.skipped.shadow_rays; });
    return masks.shadow_rays;
  }

  void scatter_paths(PlainModel model) {
    const ScatterMasks scattered = scatter(model, context().inverse_roulette_threshold, lanes_);
    for_each_lane(scattered.going_on, [&](std::uint32_t slot) {
      const Place& place = places_[slot];
      take_scattered(lanes_, slot, place.lane, place.trip->block);
      place.trip->after.going_on |= 1u << place.lane;
    });
    for_each_lane(scattered.lost, [&](std::uint32_t slot) {
      lose_path(places_[slot].trip->block, places_[slot].lane);
    });
  }

  PlainLanes& lanes_;
  std::array<Place, block_size> places_;
  std::uint32_t size_ = 0;
};

}  // namespace candela
