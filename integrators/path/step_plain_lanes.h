// The steps of those paths that met plain surfaces, from several blocks at once: what step_lane()
// does, bit by bit.
#pragma once

#include "integrators/path/fill_plain_lanes.h"
#include "integrators/path/trace_block.h"

namespace candela {

// Steps of paths on plain surfaces of one model: those of a block in the lanes that they have there
// where they are many, else of several blocks, which wait until they are enough.
template <FeatureSet F, class A>
class PlainSteps {
 public:
  static constexpr std::uint32_t fewest_of_block = 8;
  static_assert(fewest_of_block >= fewest_drawn_together);  // their numbers are there
  static_assert(!F.guided);                                 // what guides need is not

  explicit PlainSteps(PlainLanes& lanes) : lanes_(lanes) {}

  void add(BlockTrip<A>& trip, LaneMask of_block, PlainModel model) {
    if (lane_count(of_block) >= fewest_of_block) return step_block(trip, of_block, model);
    for_each_lane(of_block, [&](std::uint32_t lane) {
      waiting_[size_++] = {&trip, lane};
      if (size_ == block_size) step_waiting(model);
    });
  }
  void end(PlainModel model) {
    constexpr std::uint32_t fewest = 4;  // that are worth it
    if (size_ >= fewest) return step_waiting(model);
    for (std::uint32_t i = 0; i < size_; ++i) step_lane<F>(*waiting_[i].trip, waiting_[i].lane);
    size_ = 0;
  }

 private:
  struct Place {
    BlockTrip<A>* trip;
    std::uint32_t lane;
  };

  void step_block(BlockTrip<A>& trip, LaneMask of_block, PlainModel model) {
    block_ = &trip;
    fill_from_block(of_block, model);
    step(model);
    block_ = nullptr;
  }
  void step_waiting(PlainModel model) {
    fill_from_waiting(model);
    size_ = 0;
    step(model);
  }
  void step(PlainModel model) {
    if (lanes_.filled == 0) return;
    find_surfaces(model, scene(), lanes_);
    if (!is_only_delta(model)) {
      for (const std::uint32_t index : lights().always()) add_light_of(index, model);
      if (lights().has_table()) add_picked_light(model);
    }
    scatter_paths(model);
  }

  // Whose path is in a lane.
  [[nodiscard]] Place place(std::uint32_t slot) const {
    return block_ != nullptr ? Place{block_, slot} : places_[slot];
  }

  [[nodiscard]] const PathContext<A>& context() const {
    return (block_ != nullptr ? block_ : places_[0].trip)->context;
  }
  [[nodiscard]] const Scene& scene() const { return context().scene; }
  [[nodiscard]] const LightSampler& lights() const { return scene().light_sampler; }

  // Those that are as deep as paths may be end here.
  void fill_from_waiting(PlainModel model) {
    lanes_.clear();
    const bool is_delta = is_only_delta(model);
    std::uint32_t slot = 0;
    for (std::uint32_t k = 0; k < size_; ++k) {
      BlockTrip<A>& trip = *waiting_[k].trip;
      const std::uint32_t lane = waiting_[k].lane;
      meet_surface(trip, lane, geometry_met(trip, lane));
      if (trip.bounce >= trip.context.max_depth) continue;
      const StepNumbers numbers =
          is_delta ? numbers_of_delta<F>(trip, lane) : numbers_of<F>(trip, lane);
      put_path(trip.context.scene, numbers, trip.bounce, trip.block.hits[lane],
               trip.block.rays[lane], trip.block.paths[lane], slot, lanes_);
      if (!is_delta)
        put_lamp_where_any(trip, lane, numbers.light_choice, numbers.light_point, slot);
      places_[slot++] = waiting_[k];
    }
  }
  void fill_from_block(LaneMask of_block, PlainModel model) {
    lanes_.clear();
    const bool is_delta = is_only_delta(model);
    BlockTrip<A>& trip = *block_;
    const Scene& scene = trip.context.scene;
    const HitBlock& hits = trip.block.hits;
    const bool goes_on = trip.bounce < trip.context.max_depth;
    if (goes_on) put_paths(trip.block, trip.numbers, trip.bounce, of_block, lanes_);
    for_each_lane(of_block, [&](std::uint32_t lane) {
      const Geometry& geometry = geometry_met(trip, lane);
      meet_surface(trip, lane, geometry);
      if (!goes_on) return;
      put_surface(scene, geometry, hits[lane], coherence_of(trip.bounce), lane, lanes_);
      if (!is_delta)
        put_lamp_where_any(trip, lane, trip.numbers.light_choice(lane),
                           trip.numbers.light_point(lane), lane);
    });
  }

  [[nodiscard]] static const Geometry& geometry_met(const BlockTrip<A>& trip, std::uint32_t lane) {
    return trip.context.scene.geometries[trip.block.hits.geometry[lane]];
  }
  void put_lamp_where_any(BlockTrip<A>& trip, std::uint32_t lane, std::uint32_t choice, Vec2f u,
                          std::uint32_t slot) {
    const Scene& scene = trip.context.scene;
    if (!scene.light_sampler.has_table()) return;
    std::uint32_t cell = LightCells::everywhere;
    if (scene.light_sampler.has_cells()) {
      cell = light_cell_at(scene, trip.block.rays[lane], trip.block.hits.t[lane], trip.bounce);
      trip.block.paths.light_cell[lane] = cell;
    }
    put_lamp(scene, cell, choice, u, slot, lanes_.lamps);
  }

  static void meet_surface(BlockTrip<A>& trip, std::uint32_t lane, const Geometry& geometry) {
    const PathContext<A>& context = trip.context;
    PathBlock& block = trip.block;
    if (is_emission_met(context, geometry, trip.bounce)) {
      PathState path = block.paths[lane];
      add_emission<F>(context.scene, context.options, geometry, block.hits[lane],
                      block.rays.origin[lane], block.rays.direction[lane], block.hits.t[lane],
                      path);
      block.paths.radiance.set(lane, path.radiance);
    }
    if (trip.bounce == 0 && context.options.aovs != 0)
      record_camera_hit<F>(context.scene, context.camera, block.rays[lane], block.hits[lane],
                           context.scene.materials[geometry.material.index],
                           block.first_hits[lane]);
  }

  // Of a light that is sampled at every hit.
  void add_light_of(std::uint32_t index, PlainModel model) {
    lanes_.light_samples.choice.fill(1);
    if (!sample_delta_light(scene().lights[index], lanes_))
      for_each_lane(lanes_.filled,
                    [&](std::uint32_t slot) { sample_alone(slot, index, Vec2f(0)); });
    const LightSampleLanes& samples = lanes_.light_samples;
    const LaneMask to_trace = weighed_light(model);
    if constexpr (!F.media) {
      if (context().accelerator.allows_any_company()) return add_unoccluded(to_trace);
    }
    for_each_lane(to_trace, [&](std::uint32_t slot) {
      const Place at = place(slot);
      const DirectLight light{samples.contribution[slot], samples.shadow_ray(slot)};
      BlockTrip<A>& trip = *at.trip;
      trip.count_for(at.lane, [&] {
        if constexpr (F.media)
          trip.block.paths.add_radiance(at.lane,
                                        shadowed_in(context(), light, MediumHandle{}, trip.counts));
        else
          trip.block.paths.add_radiance(at.lane,
                                        shadowed(context().accelerator, light, trip.counts));
      });
    });
  }

  // What the samples in these lanes bring whose shadow rays, which are traced together, arrive.
  void add_unoccluded(LaneMask to_trace) {
    const LightSampleLanes& samples = lanes_.light_samples;
    const RayBlock rays{samples.shadow_origin, samples.shadow_direction, samples.shadow_end};
    const LaneMask occluded = context().accelerator.occluded(rays, to_trace);
    for_each_lane(to_trace, [&](std::uint32_t slot) {
      const Place at = place(slot);
      at.trip->count_shadow_rays(1u << at.lane);
      if ((occluded >> slot & 1) == 0)
        at.trip->block.paths.add_radiance(at.lane, samples.contribution[slot]);
    });
  }

  void add_picked_light(PlainModel model) {
    put_lights(scene(), lanes_.lamps);
    const LampLanes& lamps = lanes_.lamps;
    const LightSampleLanes& samples = lanes_.light_samples;
    const LaneMask others = sample_lamps(lanes_);
    LaneMask skies = sample_sky(others);
    for_each_lane(others & ~skies, [&](std::uint32_t slot) {
      if (sample_alone(slot, lamps.light[slot], {lamps.u_x[slot], lamps.u_y[slot]}))
        skies |= 1u << slot;
    });
    const LaneMask to_trace = weighed_light(model);
    if (block_ != nullptr) {
      take_shadow_rays(samples, to_trace, block_->block);
      block_->after.shadow_rays |= to_trace;
      block_->after.sky_rays |= to_trace & skies;
    }
    for_each_lane(to_trace, [&](std::uint32_t slot) {
      const Place at = place(slot);
      PathBlock& block = at.trip->block;
      if constexpr (F.media) block.shadow_media[at.lane] = {};
      if (block_ != nullptr) return;
      block.shadow_rays.set(at.lane, samples.shadow_ray(slot));
      block.unshadowed.set(at.lane, samples.contribution[slot]);
      at.trip->after.shadow_rays |= 1u << at.lane;
      at.trip->after.sky_rays |= (skies >> slot & 1u) << at.lane;
    });
  }

  // Where many samples are of the sky's map. Returns their lanes.
  [[nodiscard]] LaneMask sample_sky(LaneMask others) {
    if (lane_count(others) < fewest_in_sky || !has_sky_map(scene())) return 0;
    LaneMask skies = 0;
    for_each_lane(others, [&](std::uint32_t slot) {
      skies |= flag(lanes_.lamps.light[slot] == scene().environment_light) << slot;
    });
    if (skies != 0) sample_sky_in_lanes(*scene().environment, skies, lanes_);
    return skies;
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
                  [&](std::uint32_t slot) { ++place(slot).trip->counts.skipped.shadow_rays; });
    return masks.shadow_rays;
  }

  void scatter_paths(PlainModel model) {
    const ScatterMasks scattered = scatter(model, context().roulette, lanes_);
    if (block_ != nullptr) {
      take_scattered(lanes_, scattered.going_on, block_->block);
      block_->after.going_on |= scattered.going_on;
    } else {
      for_each_lane(scattered.going_on, [&](std::uint32_t slot) {
        const Place at = places_[slot];
        take_scattered(lanes_, slot, at.lane, at.trip->block);
        at.trip->after.going_on |= 1u << at.lane;
      });
    }
    if (is_only_delta(model))
      for_each_lane(scattered.going_on, [&](std::uint32_t slot) {
        take_delta(lanes_, slot, place(slot).lane, place(slot).trip->block);
      });
    for_each_lane(scattered.lost, [&](std::uint32_t slot) {
      lose_path(place(slot).trip->block, place(slot).lane);
    });
  }

  PlainLanes& lanes_;
  BlockTrip<A>* block_ = nullptr;         // whose paths are in the lanes, each in its own; else:
  std::array<Place, block_size> places_;  // of the paths in the lanes
  std::array<Place, block_size> waiting_;
  std::uint32_t size_ = 0;  // of those that wait
};

}  // namespace candela
