#include "integrators/pilot.h"

#include <algorithm>

#include "integrators/path/reuse_groups.h"
#include "integrators/path/shared_block.h"
#include "integrators/rounds.h"
#include "renderer/film/tiles.h"

namespace candela {
namespace {

// With all of the squares that share blocks or paths: kernels ask for the samples of their pixels,
// too.
PixelRect with_whole_squares(const PixelRect& crop, const RenderOptions& options) {
  const bool may_reuse = options.plan.reuses_paths || options.chooses_reuse;
  const int side = may_reuse ? reuse_square : shared_side;
  const auto square = [&](int x, int y) {
    return square_around(x, y, side, options.width, options.height);
  };
  const PixelRect first = square(crop.x0, crop.y0);
  const PixelRect last = square(crop.x1 - 1, crop.y1 - 1);
  return {first.x0, first.y0, last.x1, last.y1};
}

// One replicate is told by as many pieces as there are replicates by default.
std::uint32_t sums_of(const RenderOptions& options) {
  constexpr std::uint32_t pieces = 4;
  const std::uint32_t replicates = film_replicates(options);
  return replicates > 1 ? replicates : pieces;
}

PixelRect rect_of(const RenderOptions& options) {
  return may_end_early(options) ? with_whole_squares(rendered_rect(options), options)
                                : PixelRect{0, 0, options.width, options.height};
}

// A quarter of all samples, where it is known how many those are, leaves enough to deal out.
constexpr std::uint32_t pilots_a_picture = 4;

// Four a replicate are the fewest that tell noise from structure.
std::uint32_t fewest_samples(const RenderOptions& options) {
  const std::uint32_t sums = sums_of(options);
  return std::max((whole_block + sums - 1) / sums, 4u) * sums;
}

std::uint32_t samples_of(const RenderOptions& options) {
  constexpr std::uint32_t most_blocks = 4;
  const std::uint32_t fewest = fewest_samples(options);
  const std::uint32_t blocks =
      static_cast<std::uint32_t>(options.samples_per_pixel) / (pilots_a_picture * fewest);
  if (!options.adaptive || blocks == 0 || !is_wide_enough_for_pilot(options)) return 0;
  return may_end_early(options) ? fewest : std::min(blocks, most_blocks) * fewest;
}

}  // namespace

Pilot pilot_of(const RenderOptions& options) {
  return {rect_of(options), samples_of(options), sums_of(options)};
}

std::uint32_t least_samples_for_pilot(const RenderOptions& options) {
  return pilots_a_picture * fewest_samples(options);
}

bool is_wide_enough_for_pilot(const RenderOptions& options) {
  const PixelRect rect = rect_of(options);
  return rect.width() > 1 && rect.height() > 1;
}

}  // namespace candela
