#include "integrators/path/find_lamp_pixels.h"

namespace candela {
namespace {

double pixel_count(const RenderOptions& options) {
  return static_cast<double>(options.width) * options.height;
}

double count_of(const PixelMask& mask) {
  return static_cast<double>(
      std::count_if(mask.begin(), mask.end(), [](auto m) { return m != 0; }));
}

// In rays of a packet, of which a path's ray takes some five times as long.
constexpr double cost_of_sample = 20;

// The most rays a sample that take at most a thirtieth or so of the picture's time, by twos.
std::uint32_t affordable_rays(double lamp_pixels, const RenderOptions& options) {
  constexpr double share = 0.03;
  const double affordable = share * cost_of_sample * pixel_count(options) / lamp_pixels;
  for (std::uint32_t rays = static_cast<std::uint32_t>(options.lamp_rays); rays > 1; rays /= 2)
    if (rays <= affordable) return rays;
  return 0;
}

}  // namespace

LampTrial plan_lamp_trial(const Scene& scene, const Filter& filter, const RenderOptions& options) {
  const Camera& camera = scene.cameras[options.camera];
  if (options.lamp_rays == 0 || scene.features.media || filter.is_signed() ||
      !scene.features.area_lights || !PixelCover::has_projection(camera))
    return {};
  PixelCover cover(camera, scene.bounds, filter, options.width, options.height);
  for (const GeometryHandle handle : scene.world.geometries) {
    const Geometry& geometry = scene.geometries[handle.index];
    if (geometry.is_emissive()) cover.add(geometry);
  }
  PixelMask mask = cover.covered();
  const double pixels = count_of(mask);
  if (pixels == 0) return {};
  constexpr double most_blocks = 4;
  constexpr double share = 0.01;  // of the picture's time, at most
  const double samples = pixel_count(options) * options.samples_per_pixel;
  const double affordable = share * cost_of_sample * samples / (pixels * block_size);
  return {std::move(mask), static_cast<std::uint32_t>(std::min(affordable, most_blocks))};
}

LampPixels lamp_edges(const std::vector<LampCoverage>& coverage, const RenderOptions& options) {
  PixelMask edges(coverage.size());
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(options.width) +
           static_cast<std::size_t>(x);
  };
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const LampCoverage own = coverage[at(x, y)];
      bool is_edge = own == LampCoverage::Part;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, options.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, options.width - 1); ++u)
          is_edge |= coverage[at(u, v)] != own;
      edges[at(x, y)] = is_edge ? 1 : 0;
    }
  }
  const double count = count_of(edges);
  const std::uint32_t rays = count > 0 ? affordable_rays(count, options) : 0;
  if (rays == 0) return {};
  return {std::move(edges), options.width, rays};
}

}  // namespace candela
