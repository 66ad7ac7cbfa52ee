// A tile's pixels through the path kernel: camera rays in, film samples out.
#pragma once

#include "integrators/path/trace_path.h"

namespace candela {

// The camera ray of one sample; the filter chooses its place (filter importance sampling).
template <FeatureSet F, class A>
[[nodiscard]] inline Ray camera_ray(const PathContext<A>& context, const Sampler& sampler, int x,
                                    int y) {
  Vec2f place = context.filter.sample(sampler.sample_2d(0, Dimension::Filter));
  Vec2f film{(static_cast<float>(x) + 0.5f + place.x) / static_cast<float>(context.options.width),
             (static_cast<float>(y) + 0.5f + place.y) / static_cast<float>(context.options.height)};
  if constexpr (!F.thin_lens) return context.camera.generate_ray(film, Vec2f(0));
  Vec2f lens = context.camera.lens_radius > 0 ? sampler.sample_2d(0, Dimension::Lens) : Vec2f(0);
  return context.camera.generate_ray(film, lens);
}

// Samples [first_sample, end_sample) of each pixel of the tile, in order.
template <FeatureSet F, class A>
TileCounts render_tile(const PathContext<A>& context, const PixelRect& tile,
                       std::uint32_t first_sample, std::uint32_t end_sample, Film& film) {
  TileCounts counts;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const PixelSampler pixel(context.options.seed, static_cast<std::uint32_t>(x),
                               static_cast<std::uint32_t>(y), film.replicates());
      for (std::uint32_t s = first_sample; s < end_sample; ++s) {
        Sampler sampler = pixel.at(s);
        Ray ray = camera_ray<F>(context, sampler, x, y);
        FilmSample sample = trace_path<F>(context, sampler, ray, counts);
        add_or_count(sample, x, y, s, context.options.clamp, film, counts);
      }
    }
  }
  return counts;
}

}  // namespace candela
