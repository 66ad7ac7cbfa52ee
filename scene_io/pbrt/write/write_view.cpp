#include "scene_io/pbrt/write/write_view.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "renderer/math/constants.h"
#include "scene_io/pbrt/write/directive.h"

namespace candela::pbrt {
namespace {

using description::Camera;
using description::CameraKind;
using description::RenderDefaults;
using description::ScreenWindow;

// Bounces that leave nothing of a path's weight; pbrt cannot be told to have no limit.
constexpr int practically_none = 1000;

double aspect_of(const RenderDefaults& defaults) {
  return static_cast<double>(defaults.width.value_or(1280)) / defaults.height.value_or(720);
}

// LookAt leads to a left-handed space (x right, y up, z ahead), whose picture is mirrored. pbrt's
// latitudes and longitudes have -x in their middle (scene_io/pbrt/camera.cpp).
std::string camera_transform(const Camera& camera) {
  const Vec3d &eye = camera.eye, &target = camera.target, &up = camera.up;
  const std::string look_at = fmt::format("LookAt {} {} {}  {} {} {}  {} {} {}\n", eye.x, eye.y,
                                          eye.z, target.x, target.y, target.z, up.x, up.y, up.z);
  if (camera.kind == CameraKind::LatLong) {
    const double side = camera.is_mirrored ? -1 : 1;
    const Transform turn{Mat3d(0, 0, side, 0, 1, 0, -1, 0, 0), Vec3d(0.0)};
    return "ConcatTransform " + matrix_text(turn) + "\n" + look_at;
  }
  return camera.is_mirrored ? look_at : "Scale -1 1 1\n" + look_at;
}

void add_window(const ScreenWindow& w, Directive& camera) {
  camera.add("float screenwindow", std::vector<double>{w.left, w.right, w.bottom, w.top});
}

// Of the picture's shorter side, for the picture's size as it stands in the file.
void add_angle(const Camera& camera, double aspect, Directive& directive) {
  const bool is_of_height = !camera.fov_is_of_shorter_side && !camera.screen_window;
  double fov = camera.fovy_degrees;
  if (is_of_height && aspect < 1) {
    const double degree = pi_double / 180;
    fov = 2 * std::atan(std::tan(fov * degree / 2) * aspect) / degree;
  }
  directive.add("float fov", fov);
  if (is_of_height) directive.add_own("float fovy", camera.fovy_degrees);
  if (camera.screen_window) add_window(*camera.screen_window, directive);
}

// Without one it is 1 of the shorter side to pbrt, whatever the picture's aspect.
void add_orthographic_window(const Camera& camera, double aspect, Directive& directive) {
  if (!camera.screen_window && camera.fov_is_of_shorter_side) return;
  add_window(camera.screen_window.value_or(ScreenWindow{-aspect, aspect, -1, 1}), directive);
}

void add_lens(const Camera& camera, Directive& directive) {
  if (!(camera.lens_radius > 0)) return;
  const double focus =
      camera.focus_distance > 0 ? camera.focus_distance : length(camera.target - camera.eye);
  directive.add("float lensradius", camera.lens_radius).add("float focaldistance", focus);
}

std::string camera_text(const Camera& camera, double aspect) {
  const auto directive = [&] {
    switch (camera.kind) {
      case CameraKind::Perspective: {
        Directive perspective("Camera", "perspective");
        add_angle(camera, aspect, perspective);
        add_lens(camera, perspective);
        return perspective;
      }
      case CameraKind::Orthographic: {
        Directive orthographic("Camera", "orthographic");
        add_orthographic_window(camera, aspect, orthographic);
        add_lens(camera, orthographic);
        return orthographic;
      }
      case CameraKind::LatLong:
        return Directive("Camera", "spherical").add("string mapping", "equirectangular");
      case CameraKind::EqualArea:
        return Directive("Camera", "spherical").add("string mapping", "equalarea");
    }
    return Directive("Camera", "perspective");
  }();
  return camera_transform(camera) + directive.text();
}

std::string film_text(const WriteContext& context) {
  const RenderDefaults& defaults = context.scene.defaults;
  Directive film("Film", "rgb");
  if (defaults.width) film.add("integer xresolution", *defaults.width);
  if (defaults.height) film.add("integer yresolution", *defaults.height);
  film.add("string filename", context.options.picture);
  if (const auto& crop = defaults.crop)
    film.add("float cropwindow",
             std::vector<double>{crop->left, crop->right, crop->top, crop->bottom});
  if (defaults.white_balance_kelvins)
    film.add("float whitebalance", *defaults.white_balance_kelvins);
  if (defaults.exposure && *defaults.exposure != 0)
    film.add_own("float exposure", *defaults.exposure);
  return film.text();
}

// pbrt has no Blackman-Harris filter. A gaussian of the same variance comes near it:
// [Harris78, section V.H]'s four terms have that of .2770 of their radius.
std::string filter_text(const RenderDefaults& defaults) {
  if (!defaults.filter) return "";
  constexpr double blackman_harris_deviation = 0.2770;
  const bool is_known = *defaults.filter != "blackman_harris";
  Directive filter("PixelFilter", is_known ? *defaults.filter : "gaussian");
  const double radius = defaults.filter_radius.value_or(1.5);
  if (defaults.filter_radius || !is_known)
    filter.add("float xradius", radius).add("float yradius", radius);
  if (!is_known)
    filter.add("float sigma", radius * blackman_harris_deviation)
        .add_own("string filter", *defaults.filter);
  return filter.text();
}

std::string sampler_text(WriteContext& context) {
  const RenderDefaults& defaults = context.scene.defaults;
  Directive sampler("Sampler", "zsobol");
  if (defaults.samples_per_pixel) sampler.add("integer pixelsamples", *defaults.samples_per_pixel);
  const std::uint64_t seed = defaults.seed.value_or(0);
  if (seed <= static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    return sampler.add("integer seed", static_cast<int>(seed)).text();
  context.warn(
      {}, fmt::format("lost for pbrt: the seed {}, which is more than its integers hold", seed));
  return sampler.add_own("string seed", std::to_string(seed)).text();
}

std::string integrator_text(const WriteContext& context, bool has_media) {
  const RenderDefaults& defaults = context.scene.defaults;
  Directive integrator("Integrator", has_media ? "volpath" : "path");
  integrator.add("integer maxdepth", defaults.max_depth.value_or(practically_none));
  if (!defaults.max_depth) integrator.add_own("bool unlimited", true);
  if (defaults.integrator && *defaults.integrator != "path")
    integrator.add_own("string integrator", *defaults.integrator);
  if (context.scene.lab_ambient) integrator.add_own("rgb ambient", *context.scene.lab_ambient);
  return integrator.text();
}

}  // namespace

std::string write_view(WriteContext& context, bool has_media) {
  const RenderDefaults& defaults = context.scene.defaults;
  std::string text = film_text(context) + filter_text(defaults) + sampler_text(context) +
                     integrator_text(context, has_media) + "\n";
  const auto& cameras = context.scene.cameras;
  if (context.options.camera >= cameras.size()) return text;
  if (cameras.size() > 1)
    context.warn({}, fmt::format("pbrt has one camera: of {} only camera {} is written",
                                 cameras.size(), context.options.camera));
  return text + camera_text(cameras[context.options.camera], aspect_of(defaults));
}

}  // namespace candela::pbrt
