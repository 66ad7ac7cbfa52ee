// A tile's pixels through the path kernel: camera rays in, film samples out.
#pragma once

#include "integrators/background_pixels.h"
#include "integrators/lamp_pixels.h"
#include "integrators/path/convoy.h"
#include "integrators/path/film_lanes.h"
#include "integrators/path/reuse_groups.h"
#include "integrators/path/seen_lamps.h"
#include "integrators/path/shared_block.h"
#include "integrators/path/sky_samples.h"
#include "integrators/tile_pass.h"

namespace candela {

// The paths of a block start at the camera.
template <FeatureSet F, class A>
inline void start(BlockTrip<A>& trip) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  CameraNumbers numbers;
  numbers.draw(context.camera, trip.samplers, Dimension::Filter, Dimension::Lens);
  const PlaceLanes places = sample_places(context.filter, {}, numbers);
  trip.alive = aim_camera_rays(context.camera, trip.place.pixels, places, numbers, trip.place.lanes,
                               block.rays);
  begin_paths(block.paths);
  if constexpr (F.media) block.media.fill(context.camera.medium);
  block.alpha.fill(1);
  for (std::uint32_t i = 0; i < block_size; ++i) block.weight[i] = context.filter.weight(places[i]);
  if (context.options.aovs != 0) block.first_hits.fill({});
  for_each_lane(trip.place.lanes & ~trip.alive, [&](std::uint32_t i) { lose_path(block, i); });
  trip.counts.rays.camera += lane_count(trip.place.lanes);
}

// What a block's rays took, to its pixels. To each what its own took: what else is in the block
// must not change the picture.
template <class A>
inline void add_cost(const BlockTrip<A>& trip, const PixelRect& tile, Film& film) {
  const PixelLanes& pixels = trip.place.pixels;
  if (trip.is_of_one_pixel()) {
    if (tile.contains(pixels.x[0], pixels.y[0]))
      film.add_cost(pixels.x[0], pixels.y[0],
                    static_cast<std::uint32_t>(cost_of(trip.counts.rays)));
    return;
  }
  const auto of_camera = static_cast<std::uint32_t>(cost_of({.camera = 1}));
  for_each_lane(trip.place.lanes, [&](std::uint32_t i) {
    if (tile.contains(pixels.x[i], pixels.y[i]))
      film.add_cost(pixels.x[i], pixels.y[i], of_camera + trip.costs[i]);
  });
}

// What lamps' own rays brought to the samples of a block where that is apart. Out of line: few have
// any.
template <class A>
[[gnu::noinline]] void add_weighted_lamps(const BlockTrip<A>& trip, const PixelRect& tile,
                                          Film& film, TileCounts& counts) {
  for_each_lane(trip.place.lanes, [&](std::uint32_t i) {
    const int x = trip.place.pixels.x[i];
    const int y = trip.place.pixels.y[i];
    if (tile.contains(x, y))
      add_weighted_or_count((*trip.weighted_lamps)[i], x, y, trip.place.samples[i], film, counts);
  });
}

// What the paths of a block found. Those of pixels beside the tile were company only.
template <class A>
inline void add_samples(BlockTrip<A>& trip, const PixelRect& tile, Film& film) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  const PixelLanes& pixels = trip.place.pixels;
  const float clamp = context.options.clamp;
  if (trip.is_of_one_pixel() && context.options.aovs == 0) {
    if (tile.contains(pixels.x[0], pixels.y[0]))
      add_or_count(trip.place, block.paths.radiance, block.weight, block.alpha, clamp, film,
                   trip.counts);
    return;
  }
  FilmSample bare;
  for_each_lane(trip.place.lanes, [&](std::uint32_t i) {
    const int x = pixels.x[i];
    const int y = pixels.y[i];
    if (!tile.contains(x, y)) return;
    FilmSample& sample = context.options.aovs != 0 ? block.first_hits[i] : bare;
    sample.radiance = block.paths.radiance[i];
    sample.weight = block.weight[i];
    sample.alpha = block.alpha[i];
    add_or_count(sample, x, y, trip.place.samples[i], clamp, film, trip.counts);
  });
}

// The paths of a block have ended.
template <FeatureSet F, class A>
inline void finish(BlockTrip<A>& trip, const PixelRect& tile, Film& film, TileCounts& counts) {
  const PathContext<A>& context = trip.context;
  PathBlock& block = trip.block;
  if constexpr (F.observed()) {
    if (context.observer != nullptr)
      for_each_lane(trip.place.lanes,
                    [&](std::uint32_t i) { context.observer->end(i, block.paths.radiance[i]); });
  }
  if (context.lamp_rays > 0) add_seen_lamps<F>(trip);
  add_samples(trip, tile, film);
  if (trip.weighted_lamps) add_weighted_lamps(trip, tile, film, trip.counts);
  add_cost(trip, tile, film);
  counts.add(trip.counts);
}

// How many independent sequences the samples of a pixel are dealt to: one a replicate, or one each.
[[nodiscard]] inline std::uint32_t sequences_of(const RenderOptions& options, const Film& film) {
  return options.sampler == SamplerKind::Independent ? std::numeric_limits<std::uint32_t>::max()
                                                     : film.sequences();
}

[[nodiscard]] inline PairOrder pair_order_of(const RenderOptions& options) {
  return options.sampler == SamplerKind::Padded ? PairOrder::Padded : PairOrder::Joint;
}

// A trial's samples without what sharing added to them.
template <class A>
inline void add_unshared(const BlockTrip<A>& trip, const Vec3Lanes& gain, const TilePass& pass) {
  TileCounts not_told;
  for_each_lane(trip.place.lanes, [&](std::uint32_t i) {
    const int x = trip.place.pixels.x[i];
    const int y = trip.place.pixels.y[i];
    if (!pass.tile.contains(x, y)) return;
    FilmSample sample;
    sample.radiance = glm::max(trip.block.paths.radiance[i] - gain[i], Rgb(0));  // but for rounding
    sample.weight = trip.block.weight[i];
    add_or_count(sample, x, y, trip.place.samples[i], trip.context.options.clamp,
                 *pass.trial->alone, not_told);
  });
  if (trip.weighted_lamps) add_weighted_lamps(trip, pass.tile, *pass.trial->alone, not_told);
}

// The samples of a pass.
template <FeatureSet F, class A>
class TileRenderer {
 public:
  TileRenderer(const PathContext<A>& of_render, const TilePass& pass, Film& film)
      : context_(of_render),
        pass_(pass),
        film_(film),
        shared_(of_render.options),
        dealer_(film.replicates()),
        convoy_(of_render.options.savings.has_convoys) {
    context_.roulette = pass.plan.roulette();
    context_.guide = pass.guide;
    context_.observer = pass.observer;
  }

  [[nodiscard]] TileCounts run() {
    const RenderOptions& options = context_.options;
    const auto for_each_square_of = [&](int side, const auto& visit) {
      for_each_square(side, pass_.tile, options.width, options.height, visit);
    };
    if (F.reuses_paths() && reuses_paths(pass_)) {
      for_each_square_of(reuse_square, [&](const PixelRect& square) { add_groups(square); });
    } else if (shares_blocks(options, pass_)) {
      for_each_square_of(shared_side, [&](const PixelRect& square) { add_square(square); });
    } else {
      for (int y = pass_.tile.y0; y < pass_.tile.y1; ++y)
        for (int x = pass_.tile.x0; x < pass_.tile.x1; ++x)
          if (!add_if_background(x, y)) add_alone(x, y);
    }
    travel();
    return counts_;
  }

 private:
  [[nodiscard]] PixelSampler sampler_of(int x, int y) const {
    return {pass_.seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
            sequences_of(context_.options, film_), pair_order_of(context_.options)};
  }

  // Adds the samples of a pixel at once that is known to see nothing; false of others.
  [[nodiscard]] bool add_if_background(int x, int y) {
    if (context_.background == nullptr || !context_.background->contains(x, y)) return false;
    if (pass_.trial == nullptr && pass_.tile.contains(x, y))
      add_background(pass_.of_pixel(x, y), x, y);
    return true;
  }
  // What their samples bring, and what rays would have taken.
  void add_background(const SampleRange& range, int x, int y) {
    if (range.is_empty()) return;
    const RenderOptions& options = context_.options;
    const std::optional<FilmSample>& constant = context_.background->sample();
    if (constant)
      for (std::uint32_t i = range.first; i < range.end; ++i)
        add_or_count(*constant, x, y, i, options.clamp, film_, counts_);
    else
      add_sky_samples(context_.scene, context_.filter, options, sampler_of(x, y), range, x, y,
                      film_, counts_);
    const std::uint32_t count = range.end - range.first;
    film_.add_cost(x, y, static_cast<std::uint32_t>(cost_of({.camera = count})));
    counts_.skipped.samples += count;
  }

  // In blocks of the pixel's own.
  void add_alone(int x, int y) {
    const SampleRange range = pass_.of_pixel(x, y);
    if (range.is_empty()) return;
    const PathContext<A> here = context_at(context_, x, y);
    const PixelSampler pixel = sampler_of(x, y);
    for (std::uint32_t base = first_block(range); base < range.end; base += block_size)
      add_block(here, place_in_pixel(context_.options, x, y, base, lanes_in(base, range)), pixel,
                pass_.plan.splitting);
  }

  // The samples of a square, in groups that share what their paths find. Blocks are of one pixel
  // where all pixels get the same samples, and where there are lamp rays.
  void add_groups(const PixelRect& square) {
    std::array<std::vector<PixelPlace>, 2> with_own_blocks;  // by colour
    dealer_.clear();
    for (const PixelPlace& pixel : pixels_to_deal(square)) {
      if (add_if_background(pixel.x, pixel.y)) continue;
      if (pass_.density == nullptr || has_lamp_rays(context_, pixel.x, pixel.y))
        with_own_blocks[pixel.colour()].push_back(pixel);
      else
        dealer_.add(pixel, pass_.of_pixel(pixel.x, pixel.y));
    }
    std::vector<Hand<PixelPlace>> groups;
    for (const std::vector<PixelPlace>& pixels : with_own_blocks) deal(std::span(pixels), groups);
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (pass_.trial == nullptr || pass_.trial->number % groups.size() == i) add_group(groups[i]);
    dealer_.for_each_group([&](std::span<const SampleColumn> columns) { add_group(columns); });
  }

  void add_group(const Hand<PixelPlace>& pixels) {
    std::array<SampleRange, reuse_group_size> ranges;
    SampleRange all{std::numeric_limits<std::uint32_t>::max(), 0};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      ranges[i] = pass_.of_pixel(pixels[i].x, pixels[i].y);
      if (ranges[i].is_empty()) continue;
      all = {std::min(all.first, ranges[i].first), std::max(all.end, ranges[i].end)};
    }
    for (std::uint32_t base = first_block(all); base < all.end; base += block_size) {
      if (!convoy_.has_room_for(pixels.size())) travel();
      for (std::size_t i = 0; i < pixels.size(); ++i)
        add_block_of_pixel(pixels[i], ranges[i], base);
      convoy_.end_group();
    }
  }
  void add_block_of_pixel(const PixelPlace& pixel, const SampleRange& range, std::uint32_t base) {
    const auto& [x, y] = pixel;
    if (range.is_empty() || base < first_block(range) || base >= range.end) return;
    start<F>(convoy_.add(context_at(context_, x, y),
                         place_in_pixel(context_.options, x, y, base, lanes_in(base, range)),
                         sampler_of(x, y), pass_.plan.splitting));
  }

  void add_group(std::span<const SampleColumn> columns) {
    const std::size_t blocks = std::ranges::max(columns, {}, [](const SampleColumn& column) {
                                 return column.size();
                               }).size();
    if (!convoy_.has_room_for(blocks)) travel();
    for (std::size_t i = 0; i < blocks; ++i) {
      SharedBlock block(context_.options);
      for (std::uint32_t lane = 0; lane < columns.size(); ++lane) {
        if (i >= columns[lane].size()) continue;
        const auto& [pixel, sample] = columns[lane][i];
        block.set(lane, pixel.x, pixel.y, sampler_of(pixel.x, pixel.y), sample);
      }
      start<F>(convoy_.add(context_, block.place(), block.samplers()));
    }
    convoy_.end_group();
  }

  void add_square(const PixelRect& square) {
    for_each_pixel_near(square, [&](int x, int y) {
      if (add_if_background(x, y)) return;
      if (has_lamp_rays(context_, x, y)) {
        if (pass_.tile.contains(x, y)) add_alone(x, y);
        return;
      }
      const SampleRange range = pass_.of_pixel(x, y);
      const PixelSampler pixel = sampler_of(x, y);
      for (std::uint32_t sample = range.first; sample < range.end; ++sample) {
        shared_.add(x, y, pixel, sample);
        if (shared_.is_full()) add_shared();
      }
    });
    if (!shared_.is_empty()) add_shared();
  }
  void add_shared() {
    add_block(context_, shared_.place(), shared_.samplers());
    shared_.clear();
  }

  template <class... Arguments>
  void add_block(const Arguments&... arguments) {
    start<F>(convoy_.add(arguments...));
    if (convoy_.is_full()) travel();
  }
  void travel() {
    convoy_.travel();
    convoy_.for_each_trip([&](BlockTrip<A>& trip) { finish<F>(trip, pass_.tile, film_, counts_); });
    if constexpr (F.reuses_paths()) {
      if (pass_.trial != nullptr)
        convoy_.for_each_gain([&](const BlockTrip<A>& trip, const Vec3Lanes& gain) {
          add_unshared(trip, gain, pass_);
        });
    }
    convoy_.clear();
  }

  PathContext<A> context_;
  const TilePass& pass_;
  Film& film_;
  TileCounts counts_;
  SharedBlock shared_;
  SampleDealer dealer_;
  Convoy<F, A> convoy_;
};

template <FeatureSet F, class A>
TileCounts render_tile(const PathContext<A>& of_render, const TilePass& pass, Film& film) {
  return TileRenderer<F, A>(of_render, pass, film).run();
}

}  // namespace candela
