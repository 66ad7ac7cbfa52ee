#include "integrators/ray_limit/ray_limit.h"

#include <algorithm>

#include "integrators/check_options.h"
#include "integrators/feasible_options.h"
#include "integrators/path/kernels.h"
#include "renderer/base/thread_clock.h"
#include "renderer/film/tiles.h"

namespace candela {
namespace {

// Every seventeenth tile: spread over the picture, since that is coprime to most rows' lengths.
std::vector<PixelRect> share_of_tiles(const RenderOptions& options) {
  const std::vector<PixelRect> all = tiles_of(rendered_rect(options), options.tile_size);
  std::vector<PixelRect> share;
  for (std::size_t i = 0; i < all.size(); i += 17) share.push_back(all[i]);
  return share;
}

// Bare calls of the back end.
Hit intersect_barely(const EmbreeAccel& embree, const Ray& ray) {
  return embree.intersect_by_tree(ray);
}
bool occluded_barely(const EmbreeAccel& embree, const Ray& ray) {
  return embree.occluded_by_tree(ray);
}
Hit intersect_barely(const BvhAccel& bvh, const Ray& ray) {
  return bvh.intersect(ray);
}
bool occluded_barely(const BvhAccel& bvh, const Ray& ray) {
  return bvh.occluded(ray);
}

// Replays the rays of one tile; the sum keeps the compiler from leaving them out.
template <class A>
double replay(const A& accelerator, const std::vector<RecordedRay>& rays) {
  double sum = 0;
  for (const RecordedRay& recorded : rays) {
    if (recorded.is_shadow) {
      sum += occluded_barely(accelerator, recorded.ray) ? 1 : 0;
    } else {
      const Hit hit = intersect_barely(accelerator, recorded.ray);
      sum += hit.is_hit() ? static_cast<double>(hit.t) : 0;
    }
  }
  return sum;
}

template <class A>
std::optional<RayLimit> measure(const Scene& scene, const A& accelerator,
                                const RenderOptions& options, const CancelFlag* cancel) {
  const Filter filter = make_filter(options);
  const RecordingAccel<A> recorder(accelerator);
  const PathContext<A> context = make_path_context(scene, accelerator, filter, options);
  const auto recording = make_path_context(scene, recorder, filter, options);
  const auto samples = static_cast<std::uint32_t>(options.samples_per_pixel);
  const PathKernel<A> kernel = select_path_kernel<A>(scene.features, options.uses_general_kernel);
  const PathPlan plan = feasible_options(scene, options).plan;
  Film film(options.width, options.height, rendered_rect(options), options.aovs);

  const auto recorded =
      select_path_kernel<RecordingAccel<A>>(scene.features, options.uses_general_kernel);

  RayLimit limit;
  volatile double sink = 0;
  const auto measure_samples = [&](const PixelRect& tile, SampleRange range) {
    const TilePass pass{tile, range, nullptr, options.seed, plan};
    recorder.rays().clear();
    recorded.render(recording, pass, film);
    const double start = thread_cpu_seconds();
    kernel.render(context, pass, film);
    const double middle = thread_cpu_seconds();
    sink = sink + replay(accelerator, recorder.rays());
    limit.rays_seconds += thread_cpu_seconds() - middle;
    limit.render_seconds += middle - start;
    limit.rays += recorder.rays().size();
  };
  // All rays of a tile at once would take memory without end.
  constexpr std::uint32_t most_at_once = 256;
  const auto measure_tile = [&](const PixelRect& tile) {
    for (std::uint32_t first = 0; first < samples; first += most_at_once)
      measure_samples(tile, {first, std::min(samples, first + most_at_once)});
  };
  // Small pictures again and again, until the clock of some machines (4 ms) has seen enough.
  constexpr double least_seconds = 0.02;
  constexpr int most_rounds = 1000;
  const std::vector<PixelRect> tiles = share_of_tiles(options);
  for (int round = 0; round < most_rounds && limit.rays_seconds < least_seconds; ++round)
    for (const PixelRect& tile : tiles) {
      if (is_set(cancel)) return {};
      measure_tile(tile);
    }
  return limit;
}

}  // namespace

std::optional<RayLimit> measure_ray_limit(const Scene& scene, const AnyAccelerator& accelerator,
                                          const RenderOptions& options, const CancelFlag* cancel) {
  require_valid(scene, options);
  return std::visit([&](const auto& a) { return measure(scene, a, options, cancel); }, accelerator);
}

}  // namespace candela
