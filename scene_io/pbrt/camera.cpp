#include "scene_io/pbrt/camera.h"

#include <cmath>

#include <fmt/format.h>

#include "scene_io/pbrt/transforms.h"

namespace candela::pbrt {
namespace {

using description::Camera;
using description::CameraKind;
using description::ScreenWindow;

// Camera space is left-handed: x is right, y up, z the line of sight.
void set_frame(const Transform& world_from_camera, const Vec3d& look, const Vec3d& up,
               bool is_mirrored, Camera& camera) {
  camera.eye = world_from_camera.translation;
  const Vec3d along = world_from_camera.vector(look);
  camera.target = camera.eye + along;
  // Rounding must not lose the direction where the eye is far out.
  const double far = max_component(glm::abs(camera.eye));
  const double near = max_component(glm::abs(along));
  if (near < far) camera.target = camera.eye + along * (far / near);
  camera.up = world_from_camera.vector(up);
  camera.is_mirrored = is_mirrored;
}

std::optional<ScreenWindow> screen_window(Arguments& arguments) {
  const Parameter* parameter = arguments.find("screenwindow", {ParameterType::Float});
  const auto aspect = arguments.positive("frameaspectratio");
  if (!parameter && aspect && std::isfinite(*aspect)) {
    const double x = std::max(*aspect, 1.0);
    const double y = std::max(1 / *aspect, 1.0);
    return ScreenWindow{-x, x, -y, y};
  }
  if (!parameter || !arguments.has_count(*parameter, 4)) return std::nullopt;
  const auto& n = parameter->numbers;
  if (n[0] < n[1] && n[2] < n[3]) return ScreenWindow{n[0], n[1], n[2], n[3]};
  arguments.error(*parameter, fmt::format("is {}, expected left < right and bottom < top",
                                          describe_numbers(*parameter)));
  return std::nullopt;
}

void set_lens(Arguments& arguments, double scale, Camera& camera) {
  const double radius = arguments.number("lensradius").value_or(0);
  camera.lens_radius = arguments.clamped("lensradius", radius, 0) * scale;
  constexpr double far = 1e6;
  const auto focus = camera.lens_radius > 0 ? arguments.positive("focaldistance")
                                            : arguments.number("focaldistance");  // of no effect
  camera.focus_distance = (focus && *focus > 0 ? *focus : far) * scale;
}

// The angle of view is of the shorter side.
void read_perspective(Arguments& arguments, Camera& camera) {
  double fov = arguments.number("fov").value_or(90);
  if (const auto half = arguments.number("halffov")) fov = 2 * *half;  // pbrt-v3
  if (!(fov > 0 && fov < 180)) {
    arguments.report().error(arguments.statement().place,
                             fmt::format("the angle of view is {} degrees, expected above 0 and "
                                         "below 180",
                                         fov));
    fov = 90;
  }
  camera.fovy_degrees = fov;
  camera.fov_is_of_shorter_side = true;
  camera.screen_window = screen_window(arguments);
  // candela's own: of the height, whatever the picture's size will be.
  const auto fovy = arguments.number("fovy");
  if (!fovy || !(*fovy > 0 && *fovy < 180)) return;
  camera.fovy_degrees = *fovy;
  camera.fov_is_of_shorter_side = false;
}

// A window in the camera's own unit. Without one it follows the aspect of what is rendered; where
// the unit is not the world's, that of the file's picture.
void read_orthographic(Arguments& arguments, double scale, const Context& context, Camera& camera) {
  camera.kind = CameraKind::Orthographic;
  camera.fov_is_of_shorter_side = true;
  const std::optional<ScreenWindow> given = screen_window(arguments);
  constexpr double rounding = 1e-5;  // of matrices with six digits
  if (!given && std::abs(scale - 1) < rounding) return;
  const double width = *context.scene.defaults.width;  // read_film() sets both
  const double height = *context.scene.defaults.height;
  const double x = std::max(width / height, 1.0);
  const double y = std::max(height / width, 1.0);
  const ScreenWindow window = given.value_or(ScreenWindow{-x, x, -y, y});
  camera.screen_window = ScreenWindow{window.left * scale, window.right * scale,
                                      window.bottom * scale, window.top * scale};
}

// pbrt's latitudes and longitudes have -x in their middle, and z to the left of it.
void read_spherical(Arguments& arguments, const Transform& world_from_camera, bool is_mirrored,
                    Camera& camera) {
  const bool is_v3 = arguments.statement().type == "environment";
  const std::string mapping =
      arguments.string("mapping").value_or(is_v3 ? "equirectangular" : "equalarea");
  if (mapping == "equirectangular") {
    camera.kind = CameraKind::LatLong;
    set_frame(world_from_camera, {-1, 0, 0}, {0, 1, 0}, !is_mirrored, camera);
    return;
  }
  if (mapping != "equalarea")
    arguments.error(*arguments.find("mapping"),
                    fmt::format("is {}{}", text::quoted(mapping),
                                nearest_or_all(mapping, {"equalarea", "equirectangular"})));
  camera.kind = CameraKind::EqualArea;
}

}  // namespace

void read_camera(Context& context) {
  Statement otherwise{"Camera", "perspective", {}, {}};
  Statement& statement = context.program.camera ? *context.program.camera : otherwise;
  Arguments arguments(statement, context.report);
  const Transform world_from_camera = inverse(context.program.camera_from_world);
  const double determinant = world_from_camera.determinant();
  const double scale = std::cbrt(std::abs(determinant));  // of the camera's unit in the world
  if (similarity_scale(world_from_camera, seen_stretch) == 0)
    context.report.warning(statement.place,
                           "the camera's transform stretches or shears, which is left out");
  Camera camera;
  camera.span = statement.place.span();
  set_frame(world_from_camera, {0, 0, 1}, {0, 1, 0}, determinant > 0, camera);
  arguments.accept({"shutteropen", "shutterclose"});
  if (statement.type == "orthographic") {
    set_lens(arguments, scale, camera);
    read_orthographic(arguments, scale, context, camera);
  } else if (statement.type == "spherical" || statement.type == "environment") {
    read_spherical(arguments, world_from_camera, determinant > 0, camera);
    // pbrt reads them and does nothing with them.
    arguments.accept({"screenwindow", "frameaspectratio", "lensradius", "focaldistance"});
  } else {
    if (statement.type == "realistic")
      context.warn_once("realistic", statement.place,
                        "cameras of type 'realistic' are not supported: 'perspective' is used");
    else if (statement.type != "perspective")
      context.report.error(
          statement.place,
          fmt::format("{} is no camera{}", text::quoted(statement.type),
                      nearest_or_all(statement.type,
                                     {"perspective", "orthographic", "spherical", "realistic"})));
    set_lens(arguments, scale, camera);
    read_perspective(arguments, camera);
    if (statement.type == "realistic")
      arguments.accept(
          {"lensfile", "aperturediameter", "aperture", "focusdistance", "simpleweighting"});
  }
  arguments.warn_of_unknown();
  context.scene.cameras.push_back(camera);
}

}  // namespace candela::pbrt
