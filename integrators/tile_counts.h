// What a tile counts while it renders, and how its samples enter the film. For all integrators.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>

#include "integrators/ray_counts.h"
#include "renderer/film/film.h"

namespace candela {

// What rays cost, the steps between them included, in twentieths of a bounce: fitted to the times
// of eleven scenes with and without adaptive sampling, segments to those of thirteen with and
// without them (docs/decisions.md).
inline constexpr std::uint64_t cost_of_bounce = 20;
[[nodiscard]] inline std::uint64_t cost_of(const RayCounts& rays) {
  return 6 * rays.camera + cost_of_bounce * rays.indirect + 14 * (rays.shadow + rays.lamp) +
         11 * rays.segment;
}

// Summed over tiles at the end: no shared counters.
struct TileCounts {
  RayCounts rays;
  SkippedCounts skipped;
  std::uint64_t invalid_samples = 0;
  std::optional<InvalidSample> first_invalid;

  // Told is the picture's first, row by row, in whatever order they come.
  void add_invalid(const InvalidSample& sample) {
    const auto order = [](const InvalidSample& s) { return std::tuple(s.y, s.x, s.sample); };
    if (!first_invalid || order(sample) < order(*first_invalid)) first_invalid = sample;
  }

  void add(const TileCounts& other) {
    rays.camera += other.rays.camera;
    rays.indirect += other.rays.indirect;
    rays.shadow += other.rays.shadow;
    rays.lamp += other.rays.lamp;
    rays.segment += other.rays.segment;
    skipped.shadow_rays += other.skipped.shadow_rays;
    skipped.samples += other.skipped.samples;
    invalid_samples += other.invalid_samples;
    if (other.first_invalid) add_invalid(*other.first_invalid);
  }
};

// Of a sample one of whose rays cannot be traced.
inline constexpr Rgb invalid_radiance(std::numeric_limits<float>::quiet_NaN());

// To at most `clamp` in every channel.
[[nodiscard]] inline Rgb dimmed(const Rgb& radiance, float clamp) {
  const float largest = max_component(radiance);
  return largest > clamp ? radiance * (clamp / largest) : radiance;
}

// Invalid radiance never enters the film: it is counted and located. What is above `clamp` in any
// channel is dimmed to it.
inline void add_or_count(const FilmSample& sample, int x, int y, std::uint32_t index, float clamp,
                         Film& film, TileCounts& counts) {
  if (is_finite(sample.radiance) && min_component(sample.radiance) >= 0) {
    if (max_component(sample.radiance) > clamp) {
      FilmSample clamped = sample;
      clamped.radiance = dimmed(sample.radiance, clamp);
      film.add(x, y, index, clamped);
    } else {
      film.add(x, y, index, sample);
    }
    return;
  }
  film.add_invalid(x, y);
  ++counts.invalid_samples;
  counts.add_invalid({x, y, index});
}

// More light of a sample that is in the film, of either sign (Film::add_weighted()), likewise but
// that it is clamped before it is weighted.
inline void add_weighted_or_count(const Rgb& radiance, int x, int y, std::uint32_t index,
                                  Film& film, TileCounts& counts) {
  if (is_finite(radiance)) {
    film.add_weighted(x, y, index, radiance);
    return;
  }
  ++counts.invalid_samples;
  counts.add_invalid({x, y, index});
}

}  // namespace candela
