// Pixels that lamps are seen in, but not all over. What noise they have is mostly that a camera ray
// meets the lamp or does not, since lamps are much brighter than what they light. More camera rays,
// of which only what lamps themselves send along them counts, cost little (packets of rays that
// nothing is shaded for) and take that noise away (path/seen_lamps.h). They go through that part of
// the pixel alone that the lamps' outlines leave (lamp_view.h).
//
// The picture lies in patches, in each of which they are found when the first of its pixels is
// asked for: a crop asks for its own, and gets what the whole picture would.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "integrators/lamp_view.h"
#include "renderer/film/film.h"

namespace candela {

class LampPixels {
 public:
  static constexpr int patch_side = 64;

  // Those in a patch, by index. Called on any thread; must not wait for others.
  using Finder = std::function<std::vector<LampView>(const PixelRect& patch)>;

  LampPixels() = default;  // none
  LampPixels(int width, int height, Finder finder)
      : width_(width),
        height_(height),
        columns_(patches_along(width)),
        finder_(std::move(finder)),
        patches_(new Patch[patch_count()]) {}

  [[nodiscard]] std::size_t patch_count() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(patches_along(height_));
  }
  [[nodiscard]] const std::vector<LampView>& of_patch(std::size_t index) const {
    Patch& patch = patches_[index];
    std::call_once(patch.is_known, [&] { patch.pixels = finder_(rect_of_patch(index)); });
    return patch.pixels;
  }

  // How many camera rays look for lamps for each sample of a pixel that is found.
  [[nodiscard]] std::uint32_t rays_a_sample() const { return rays_a_sample_; }
  void set_rays_a_sample(std::uint32_t rays) { rays_a_sample_ = rays; }
  // Null: the sample's own ray does.
  [[nodiscard]] const LampView* find(int x, int y) const {
    if (rays_a_sample_ == 0) return nullptr;
    const std::vector<LampView>& pixels =
        of_patch(static_cast<std::size_t>(y / patch_side) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(x / patch_side));
    const std::uint32_t index = pixel_index(x, y, width_);
    const auto found = std::lower_bound(
        pixels.begin(), pixels.end(), index,
        [](const LampView& pixel, std::uint32_t wanted) { return pixel.index < wanted; });
    return found != pixels.end() && found->index == index ? &*found : nullptr;
  }

 private:
  struct Patch {
    std::once_flag is_known;
    std::vector<LampView> pixels;
  };

  [[nodiscard]] static int patches_along(int size) { return (size + patch_side - 1) / patch_side; }
  [[nodiscard]] PixelRect rect_of_patch(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(columns_);
    const int x = static_cast<int>(index % columns) * patch_side;
    const int y = static_cast<int>(index / columns) * patch_side;
    return {x, y, std::min(x + patch_side, width_), std::min(y + patch_side, height_)};
  }

  int width_ = 0;
  int height_ = 0;
  int columns_ = 0;
  Finder finder_;
  std::unique_ptr<Patch[]> patches_;
  std::uint32_t rays_a_sample_ = 0;
};

}  // namespace candela
