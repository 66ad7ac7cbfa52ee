// Samples of single pixels that tell how bright they are and do not enter the picture: what its
// error is held against where the picture does not know (renderer/film/doubtful_pixels.h).
#pragma once

#include <functional>
#include <map>
#include <span>

#include "integrators/kernel.h"
#include "integrators/render_options.h"
#include "renderer/film/doubtful_pixels.h"

namespace candela {

class CloserLook {
 public:
  // `options` outlive it. `is_over`: asked between parts whether to leave it at what has been seen.
  CloserLook(const RenderOptions& options, TileFunction render_tile, std::function<bool()> is_over);

  // Looks at the pixels of `film` that need it, and replaces the errors of all that were looked at
  // by those that this tells. `settings`: of the picture's passes; tile, range and seed are the
  // look's own. Returns how many samples were invalid, which like its rays are none of the
  // picture's.
  std::uint64_t correct(const Film& film, const TilePass& settings, PixelErrors& errors);

  [[nodiscard]] std::size_t pixels() const { return seen_.size(); }
  [[nodiscard]] std::uint64_t samples() const { return samples_; }

 private:
  // Of a pixel, in parts of equally many samples that are independent of each other.
  struct Seen {
    Vec3d means{0.0};      // summed over the parts
    Vec3d variances{0.0};  // of those means, likewise
    std::uint32_t parts = 0;
  };
  struct Part {
    std::size_t index = 0;  // of the pixel in the film
    std::uint32_t number = 0;
  };
  struct Look {
    Vec3d mean{0.0};
    Vec3d variance{0.0};  // of the mean
    std::uint64_t invalid_samples = 0;
  };

  void replace(const Film& film, PixelErrors& errors) const;
  [[nodiscard]] std::vector<Part> parts_to_render(const Film& film,
                                                  const PixelErrors& errors) const;
  // Likewise.
  std::uint64_t look_at(const Film& film, const TilePass& settings, std::span<const Part> parts);
  [[nodiscard]] Look render_part(const Film& film, const TilePass& settings,
                                 const Part& part) const;

  const RenderOptions& options_;
  TileFunction render_tile_;
  std::function<bool()> is_over_;
  std::map<std::size_t, Seen> seen_;  // by the pixel's index in the film
  std::uint64_t samples_ = 0;         // of all of them
};

}  // namespace candela
