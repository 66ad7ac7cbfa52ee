#include "integrators/path/find_lamp_pixels.h"

#include "integrators/trial.h"

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

// Where outlines would take long: the whole of each pixel.
std::vector<LampView> whole_views(const PixelMask& mask) {
  std::vector<LampView> views;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i] != 0) views.push_back({static_cast<std::uint32_t>(i), {}});
  return views;
}

}  // namespace

LampTrial plan_lamp_trial(const Scene& scene, const Filter& filter, const RenderOptions& options,
                          const std::function<bool()>& is_over) {
  const Camera& camera = scene.cameras[options.camera];
  if (options.lamp_rays == 0 || scene.features.media || filter.is_signed() ||
      !scene.features.area_lights || !PixelCover::has_projection(camera))
    return {};
  PixelCover cover(camera, scene.bounds, filter, options.width, options.height);
  add_lamps(scene, cover);
  const PixelMask mask = cover.covered();
  const auto pixels = std::count_if(mask.begin(), mask.end(), [](auto m) { return m != 0; });
  const std::uint32_t blocks =
      pixels == 0 ? 0 : affordable_blocks(static_cast<double>(pixels), options);
  if (blocks == 0) return {};
  constexpr double most_outlines = 8;  // a pixel
  if (cover.sum() > most_outlines * pixel_count(options)) return {whole_views(mask), blocks};
  LampViews views(camera, scene.bounds, filter, options.width, options.height);
  add_lamps(scene, views);
  return {views.views(is_over), blocks};
}

PixelMask lamp_edges(const std::vector<LampCoverage>& coverage, int width, int height) {
  PixelMask edges(coverage.size());
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

std::uint32_t affordable_lamp_rays(std::size_t pixels, const RenderOptions& options) {
  constexpr double share = 0.12;
  if (pixels == 0) return 0;
  const double affordable =
      share * cost_of_sample * pixel_count(options) / static_cast<double>(pixels);
  for (auto rays = static_cast<std::uint32_t>(options.lamp_rays); rays > 1; rays /= 2)
    if (rays <= affordable) return rays;
  return 0;
}

}  // namespace candela
