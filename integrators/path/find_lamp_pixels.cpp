#include "integrators/path/find_lamp_pixels.h"

#include <atomic>

#include "integrators/trial.h"
#include "renderer/base/parallel.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

double pixel_count(const RenderOptions& options) {
  return static_cast<double>(options.width) * options.height;
}

// In rays of a packet, of which a path's ray takes some five times as long.
constexpr double cost_of_sample = 20;

// How many blocks of rays a trial of so many pixels may have: a fiftieth of the picture's time.
std::uint32_t affordable_blocks(double pixels, const RenderOptions& options) {
  constexpr double most = 4;
  constexpr double share = 0.02;
  const double affordable = share * cost_of_sample * picture_samples(options);
  return static_cast<std::uint32_t>(std::min(affordable / (pixels * block_size), most));
}

template <class Views>
void add_lamps(const Scene& scene, Views& views) {
  for (const GeometryHandle handle : scene.world.geometries) {
    const Geometry& geometry = scene.geometries[handle.index];
    if (geometry.is_emissive()) views.add(geometry);
  }
}

// Places of some of so many patches, in order.
std::vector<std::size_t> some_patches(std::size_t count, std::uint64_t seed) {
  constexpr std::size_t most = 1024;
  const std::size_t some = std::min(count, most);
  std::vector<std::size_t> patches;
  for (std::size_t i = 0; i < some; ++i) {
    const std::size_t first = i * count / some;
    const std::size_t end = (i + 1) * count / some;
    patches.push_back(first + hash_counter(seed, i) % (end - first));
  }
  return patches;
}

}  // namespace

std::vector<LampView> LampTrial::views(const PixelRect& rect, int width) const {
  if (outlines) return outlines->views(rect);
  std::vector<LampView> views;
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x)
      if (pixels.contains(x, y)) views.push_back({pixel_index(x, y, width), {}});
  return views;
}

LampTrial plan_lamp_trial(const Scene& scene, const Filter& filter, const RenderOptions& options) {
  const Camera& camera = scene.cameras[options.camera];
  if (options.lamp_rays == 0 || scene.features.media || !scene.features.area_lights ||
      !PixelCover::has_projection(camera))
    return {};
  PixelCover cover(camera, scene.bounds, filter, options.width, options.height);
  add_lamps(scene, cover);
  LampTrial trial;
  trial.pixels = cover.covered();
  const double pixels = trial.pixels.count();
  trial.blocks = pixels == 0 ? 0 : affordable_blocks(pixels, options);
  constexpr double most_outlines = 8;  // a pixel
  if (trial.blocks == 0 || cover.sum() > most_outlines * pixel_count(options)) return trial;
  trial.outlines.emplace(camera, scene.bounds, filter, options.width, options.height);
  add_lamps(scene, *trial.outlines);
  return trial;
}

PixelRect with_neighbours(const PixelRect& rect, const RenderOptions& options) {
  return {std::max(rect.x0 - 1, 0), std::max(rect.y0 - 1, 0), std::min(rect.x1 + 1, options.width),
          std::min(rect.y1 + 1, options.height)};
}

std::optional<double> count_lamp_pixels(const LampPixels& pixels, std::uint64_t seed,
                                        const std::function<bool()>& is_over) {
  const std::vector<std::size_t> patches = some_patches(pixels.patch_count(), seed);
  std::atomic<std::uint64_t> count = 0;
  parallel_for(patches.size(), [&](std::size_t i) {
    if (!is_over()) count += pixels.of_patch(patches[i]).size();
  });
  if (is_over()) return {};
  const double share =
      static_cast<double>(patches.size()) / static_cast<double>(pixels.patch_count());
  // There may be a few although none was met.
  if (share < 1) return std::max(static_cast<double>(count), 1.0) / share;
  return static_cast<double>(count);
}

std::vector<std::uint8_t> lamp_edges(const std::vector<LampCoverage>& coverage, int width,
                                     int height) {
  std::vector<std::uint8_t> edges(coverage.size());
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const LampCoverage own = coverage[at(x, y)];
      bool is_edge = own == LampCoverage::Part;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
          is_edge |= coverage[at(u, v)] != own;
      edges[at(x, y)] = is_edge ? 1 : 0;
    }
  }
  return edges;
}

std::uint32_t affordable_lamp_rays(double pixels, const RenderOptions& options) {
  constexpr double share = 0.12;
  if (pixels == 0) return 0;
  const double affordable = share * cost_of_sample * pixel_count(options) / pixels;
  for (auto rays = static_cast<std::uint32_t>(options.lamp_rays); rays > 1; rays /= 2)
    if (rays <= affordable) return rays;
  return 0;
}

}  // namespace candela
