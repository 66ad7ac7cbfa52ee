#include "tools/candela/memory_need.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <unistd.h>

#include "integrators/pilot.h"
#include "renderer/film/sample_density.h"

namespace candela::cli {
namespace {

double pixels_of(const PixelRect& rect) {
  return static_cast<double>(rect.width()) * rect.height();
}

// Bytes, of what is held at one time.
struct Need {
  double film = 0;   // and the image made of it
  double pilot = 0;  // and the film; 0: there is none

  [[nodiscard]] double most() const { return std::max(film, pilot); }
};

Need need_of(const RenderOptions& options) {
  const PixelRect crop = rendered_rect(options);
  const double film_bytes =
      static_cast<double>(Film::bytes_a_pixel(options.aovs, film_replicates(options)));
  const double channel_bytes = 4.0 * (4 + 3 * std::popcount(options.aovs));
  const Pilot pilot = pilot_of(options);
  const double pilot_bytes =
      static_cast<double>(SampleDensity::bytes_a_pixel) +
      (pilot.fits(crop, film_replicates(options))
           ? 0
           : static_cast<double>(Film::bytes_a_pixel(options.aovs, pilot.sums)));
  const double film = pixels_of(crop) * film_bytes;
  Need need;
  need.film = film + pixels_of(crop) * channel_bytes;
  if (pilot.samples > 0) need.pilot = film + pixels_of(pilot.rect) * pilot_bytes;
  return need;
}

}  // namespace

double needed_memory(const RenderOptions& options) {
  return need_of(options).most();
}

std::optional<std::string> missing_memory(const RenderOptions& options) {
  const double present =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  const Need need = need_of(options);
  if (!(present > 0) || need.most() <= present) return {};
  const auto sentence = [&](std::string_view what, std::string_view advice) {
    return fmt::format(
        "a picture of {}x{} needs {:.1f} GB of memory{}, this machine has {:.1f}; {}",
        options.width, options.height, need.most() * 1e-9, what, present * 1e-9, advice);
  };
  if (need.film > present) return sentence("", "--crop renders a part");
  return sentence(" for its pilot", "--adaptive off does without");
}

}  // namespace candela::cli
