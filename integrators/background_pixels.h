// Pixels of which the geometry proves that no camera ray meets anything: their samples are all the
// background's, and no ray need be traced for them.
// (Covered are all triangles' and spheres' projections, and those of instances' boxes.)
#pragma once

#include <optional>

#include "integrators/pixel_cover.h"
#include "integrators/render_options.h"
#include "renderer/film/filter.h"

namespace candela {

class BackgroundPixels {
 public:
  // Of the whole picture, for a camera of the scene. Without media around it; empty (no pixel is
  // proven) where the filter has weights, the camera no projection though there is something to
  // see, or the scene more triangles than looking at them could spare.
  BackgroundPixels(const Scene& scene, const Filter& filter, const RenderOptions& options);

  [[nodiscard]] bool is_empty() const { return !covered_; }
  [[nodiscard]] bool contains(int x, int y) const { return covered_ && !covered_->contains(x, y); }
  // What each sample of these pixels brings; none where that is the sky's image, which differs.
  [[nodiscard]] const std::optional<FilmSample>& sample() const { return sample_; }

 private:
  std::optional<CoveredPixels> covered_;
  std::optional<FilmSample> sample_;
};

}  // namespace candela
