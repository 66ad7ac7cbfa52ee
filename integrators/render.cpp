#include "integrators/render.h"

#include "integrators/path/kernels.h"
#include "integrators/tiles.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

bool is_set(const CancelFlag* flag) {
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

template <class A>
TileCounts render_passes(const PathContext<A>& context, TileKernel<A> kernel, Film& film,
                         ProgressSink* progress, const CancelFlag* cancel) {
  const std::vector<PixelRect> tiles = tiles_of(film.crop(), context.options.tile_size);
  std::vector<TileCounts> counts(tiles.size());
  for (const SampleRange pass :
       passes_of(static_cast<std::uint32_t>(context.options.samples_per_pixel))) {
    parallel_for(tiles.size(), [&](std::size_t i) {
      if (is_set(cancel)) return;
      const PixelRect& tile = tiles[i];
      counts[i].add(kernel(context, tile, pass.first, pass.end, film));
      if (progress != nullptr)
        progress->advance(static_cast<std::uint64_t>(tile.width()) *
                          static_cast<std::uint64_t>(tile.height()) * (pass.end - pass.first));
    });
  }
  TileCounts sum;
  for (const TileCounts& tile : counts) sum.add(tile);
  return sum;
}

}  // namespace

RenderResult render(const Scene& scene, const AnyAccelerator& accelerator,
                    const RenderOptions& options, ProgressSink* progress,
                    const CancelFlag* cancel) {
  const Filter filter = make_filter(options);
  RenderResult result{Film(options.width, options.height, rendered_rect(options), options.aovs),
                      {}};
  std::visit(
      [&]<class A>(const A& backend) {
        const PathKernel<A> kernel =
            select_path_kernel<A>(scene.features, options.use_general_kernel);
        const TileCounts counts = render_passes(make_path_context(scene, backend, filter, options),
                                                kernel.render, result.film, progress, cancel);
        result.statistics = {counts.rays,
                             counts.skipped,
                             counts.invalid_samples,
                             counts.first_invalid,
                             "path/" + std::string(kernel.name),
                             is_set(cancel)};
      },
      accelerator);
  return result;
}

std::string kernel_name(const Scene& scene, const RenderOptions& options) {
  return "path/" +
         std::string(
             select_path_kernel<EmbreeAccel>(scene.features, options.use_general_kernel).name);
}

}  // namespace candela
