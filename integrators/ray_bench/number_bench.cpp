#include "integrators/ray_bench/number_bench.h"

#include <vector>

#include "integrators/ray_bench/spread.h"
#include "renderer/base/thread_clock.h"
#include "renderer/sampling/sampler_block.h"

namespace candela {
namespace {

constexpr std::uint32_t bounces = 6;
constexpr std::uint32_t first_roulette_bounce = 3;
constexpr std::uint32_t pixels = 256;
constexpr std::uint32_t samples = 64;  // a pixel
constexpr std::uint32_t dimensions = 2 + 5 * bounces + (bounces - first_roulette_bounce);

// Calls draw_2d(bounce, dimension) and draw_1d(bounce, dimension) for all that a path takes.
void draw_path(const auto& draw_2d, const auto& draw_1d) {
  draw_2d(0, Dimension::Filter);
  for (std::uint32_t bounce = 0; bounce < bounces; ++bounce) {
    draw_2d(bounce, Dimension::LightPoint);
    draw_1d(bounce, Dimension::LobeChoice);
    draw_2d(bounce, Dimension::Direction);
    if (bounce >= first_roulette_bounce) draw_1d(bounce, Dimension::Roulette);
  }
}

// Each returns a sum of what was drawn, so that no call can be left out as unused.
std::uint32_t draw_in_blocks(const PixelSampler& pixel) {
  std::uint32_t sum = 0;
  for (std::uint32_t first = 0; first < samples; first += block_size) {
    const SamplerBlock block(pixel, first);
    draw_path(
        [&](std::uint32_t bounce, Dimension dimension) {
          SobolPointLanes points;
          block.sample_2d(bounce, dimension, points);
          sum += points.x[bounce] + points.y[bounce];
        },
        [&](std::uint32_t bounce, Dimension dimension) {
          Lanes<std::uint32_t> numbers;
          block.sample_1d(bounce, dimension, numbers);
          sum += numbers[bounce];
        });
  }
  return sum;
}

std::uint32_t draw_one_by_one(const PixelSampler& pixel) {
  std::uint32_t sum = 0;
  for (std::uint32_t sample = 0; sample < samples; ++sample) {
    const Sampler sampler = pixel.at(sample);
    draw_path(
        [&](std::uint32_t bounce, Dimension dimension) {
          const SobolPoint point = sampler.sample_2d_bits(bounce, dimension);
          sum += point.x + point.y;
        },
        [&](std::uint32_t bounce, Dimension dimension) {
          sum += sampler.sample_1d_bits(bounce, dimension);
        });
  }
  return sum;
}

double nanoseconds(const auto& draw) {
  volatile std::uint32_t sum = 0;
  const double start = thread_cpu_seconds();
  for (std::uint32_t x = 0; x < pixels; ++x) sum = sum + draw(PixelSampler(1, x, 0, 1));
  return (thread_cpu_seconds() - start) * 1e9 / (pixels * samples * dimensions);
}

}  // namespace

NumberFigures run_number_bench(double seconds) {
  const double start = thread_cpu_seconds();
  std::vector<double> block, single;
  do {
    block.push_back(nanoseconds(draw_in_blocks));
    single.push_back(nanoseconds(draw_one_by_one));
  } while (block.size() < 5 || thread_cpu_seconds() - start < 2 * seconds);
  return {spread_of(std::move(block)).median, spread_of(std::move(single)).median};
}

}  // namespace candela
