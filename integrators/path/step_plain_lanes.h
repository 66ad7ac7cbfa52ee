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
    find_points(lanes_);
    if (has_lights()) add_light(model);
    scatter_paths(model);
  }

  [[nodiscard]] bool has_lights() const {
    return places_[0].trip->context.scene.light_sampler.has_table();
  }

  // Those that are as deep as paths may be end here.
  void fill() {
    lanes_.clear();
    for (std::uint32_t k = 0; k < size_; ++k) {
      const Place place = places_[k];
      meet_surface(place);
      BlockTrip<A>& trip = *place.trip;
      if (trip.bounce >= trip.context.max_depth) continue;
      const Scene& scene = trip.context.scene;
      const StepNumbers numbers = numbers_of<F>(trip, place.lane);
      put_path(scene, numbers, trip.bounce, trip.block.hits[place.lane],
               trip.block.rays[place.lane], trip.block.paths[place.lane].throughput, lanes_.size,
               lanes_);
      if (has_lights()) put_lamp(scene, numbers, lanes_.size, lanes_.lamps);
      places_[lanes_.size++] = place;
    }
  }

  void meet_surface(const Place& place) {
    const PathContext<A>& context = place.trip->context;
    PathBlock& block = place.trip->block;
    const Hit& hit = block.hits[place.lane];
    const Ray& ray = block.rays[place.lane];
    const Geometry& geometry = context.scene.geometries[hit.geometry];
    if (is_emission_met(context, geometry, place.trip->bounce))
      add_emission<F>(context.scene, context.options, geometry, hit, ray.origin, ray.direction,
                      hit.t, block.paths[place.lane]);
    if (place.trip->bounce == 0 && context.options.aovs != 0)
      record_camera_hit<F>(context.scene, context.camera, ray, hit,
                           context.scene.materials[geometry.material.index],
                           block.samples[place.lane]);
  }

  void add_light(PlainModel model) {
    const LampLanes& lamps = lanes_.lamps;
    const LaneMask near = sample_lamps(lanes_);
    const LampMasks masks = weigh_lamps(model, places_[0].trip->context.options, lanes_);
    for_each_lane(masks.dark & ~near,
                  [&](std::uint32_t slot) { ++places_[slot].trip->counts.skipped.shadow_rays; });
    for_each_lane(masks.shadow_rays & ~near, [&](std::uint32_t slot) {
      add_shadow_ray(places_[slot],
                     {lamps.shadow_origin[slot], lamps.shadow_direction[slot], shadow_segment_end},
                     lamps.contribution[slot]);
    });
    for_each_lane(near, [&](std::uint32_t slot) { add_near_lamp(slot); });
  }

  static void add_shadow_ray(const Place& place, const Ray& ray, const Rgb& contribution) {
    place.trip->block.shadow_rays[place.lane] = ray;
    place.trip->block.unshadowed[place.lane] = contribution;
    place.trip->after.shadow_rays |= 1u << place.lane;
  }

  // A lamp that is near to its path's surface is sampled by itself.
  [[gnu::noinline]] void add_near_lamp(std::uint32_t slot) {
    BlockTrip<A>& trip = *places_[slot].trip;
    const Scene& scene = trip.context.scene;
    const LampLanes& lamps = lanes_.lamps;
    SurfacePoint point = point_of(lanes_.met, slot);
    const Hit& hit = trip.block.hits[places_[slot].lane];
    const Material& material = scene.materials[scene.geometries[hit.geometry].material.index];
    Bsdf bsdf = bsdf_at<F.models, F.textures>(material, scene.textures, texture_point_of(point),
                                              point.is_front);
    DirectLight picked = sample_direct_light<F>(
        trip.context, lamps.light[slot], Vec2f(lamps.u_x[slot], lamps.u_y[slot]),
        lamps.probability[slot], point, bsdf, {},
        point.shading.to_local(-lanes_.met.direction[slot]), trip.counts);
    picked.contribution *= lanes_.met.throughput[slot];
    if (!is_black(picked.contribution) && is_traceable(picked.shadow_ray))
      add_shadow_ray(places_[slot], picked.shadow_ray, picked.contribution);
  }

  void scatter_paths(PlainModel model) {
    const PathContext<A>& context = places_[0].trip->context;
    const LaneMask scattered =
        scatter(model, context.options, context.inverse_roulette_threshold, lanes_);
    for_each_lane(scattered, [&](std::uint32_t slot) {
      const Place& place = places_[slot];
      if (take_scattered(lanes_, slot, place.lane, place.trip->block))
        place.trip->after.going_on |= 1u << place.lane;
    });
  }

  PlainLanes& lanes_;
  std::array<Place, block_size> places_;
  std::uint32_t size_ = 0;
};

}  // namespace candela
