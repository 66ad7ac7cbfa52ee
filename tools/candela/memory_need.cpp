#include "tools/candela/memory_need.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <unistd.h>

#include "integrators/path/context.h"
#include "integrators/pilot.h"
#include "integrators/pixel_cover.h"
#include "renderer/film/sample_density.h"

namespace candela::cli {
namespace {

using namespace description;

bool has_projection(const SceneDescription& scene, const RenderOptions& options) {
  if (options.camera >= scene.cameras.size()) return true;  // the one that compile() adds
  const auto& camera = scene.cameras[options.camera];
  const bool is_flat = camera.kind == description::CameraKind::Perspective ||
                       camera.kind == description::CameraKind::Orthographic;
  return is_flat && camera.lens_radius == 0;
}

bool is_image(const description::Light& light) {
  return std::holds_alternative<CubeEnvironment>(light.kind) ||
         std::holds_alternative<LatLongEnvironment>(light.kind) ||
         std::holds_alternative<EqualAreaEnvironment>(light.kind);
}

// Whether lamps or a constant background are looked for before the first sample
// (integrators/path/find_lamp_pixels.h, integrators/background_pixels.h).
bool covers_pixels(const SceneDescription& scene, const RenderOptions& options) {
  if (options.integrator != IntegratorKind::Path || scene.instances.empty() ||
      !scene.media.empty() || !has_projection(scene, options) || make_filter(options).is_signed())
    return false;
  const bool has_lamps = std::ranges::any_of(
      scene.materials, [](const auto& material) { return material.emission != Vec3d(0.0); });
  return (has_lamps && options.lamp_rays > 0) || options.transparent ||
         std::ranges::none_of(scene.lights, is_image);
}

double pixels_of(const PixelRect& rect) {
  return static_cast<double>(rect.width()) * rect.height();
}

// Bytes, of what is held at one time.
struct Need {
  double film = 0;    // and the image made of it
  double pilot = 0;   // and the film; 0: there is none
  double covers = 0;  // of the whole picture, and the film

  [[nodiscard]] double most() const { return std::max({film, pilot, covers}); }
};

Need need_of(const RenderOptions& options, const SceneDescription& scene) {
  const PixelRect whole{0, 0, options.width, options.height};
  const PixelRect crop = options.crop.value_or(whole);
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
  if (covers_pixels(scene, options))
    need.covers = film + pixels_of(whole) * static_cast<double>(PixelCover::bytes_a_pixel);
  return need;
}

}  // namespace

double needed_memory(const RenderOptions& options, const SceneDescription& scene) {
  return need_of(options, scene).most();
}

std::optional<std::string> missing_memory(const RenderOptions& options,
                                          const SceneDescription& scene) {
  const double present =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  const Need need = need_of(options, scene);
  if (!(present > 0) || need.most() <= present) return {};
  const auto sentence = [&](std::string_view what, std::string_view advice) {
    return fmt::format(
        "a picture of {}x{} needs {:.1f} GB of memory{}, this machine has {:.1f}; {}",
        options.width, options.height, need.most() * 1e-9, what, present * 1e-9, advice);
  };
  if (need.film > present) return sentence("", "--crop renders a part");
  if (need.covers > present)
    return sentence(" for what is seen where, of which a crop needs all",
                    "a smaller one needs less");
  return sentence(" for its pilot", "--adaptive off does without");
}

}  // namespace candela::cli
