// Samples of single pixels that tell how bright they are and do not enter the picture: what its
// error is held against where the picture does not know (renderer/film/doubtful_pixels.h).
#pragma once

#include <map>

#include "integrators/kernel.h"
#include "integrators/render.h"
#include "renderer/film/doubtful_pixels.h"

namespace candela {

class CloserLook {
 public:
  CloserLook(const RenderOptions& options, TileFunction render_tile,
             const CancelFlag* cancel);

  // Looks at the pixels of `film` that need it, and replaces their errors by those that this tells.
  // `settings`: of the picture's passes; tile, range and seed are the look's own.
  void correct(const Film& film, const TilePass& settings, PixelErrors& errors);

  [[nodiscard]] std::size_t pixels() const { return films_.size(); }
  [[nodiscard]] std::uint64_t samples() const { return samples_; }

 private:
  [[nodiscard]] std::uint64_t budget(const Film& film) const;
  void look_at(const std::vector<DoubtfulPixel>& pixels, const Film& film,
               const TilePass& settings);

  const RenderOptions& options_;
  TileFunction render_tile_;
  const CancelFlag* cancel_;
  std::map<std::size_t, Film> films_;  // of one pixel each, by its index in the picture
  std::uint64_t samples_ = 0;          // in all of them
};

}  // namespace candela
