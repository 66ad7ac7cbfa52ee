#include "scene_io/lab3/camera.h"

#include "scene_io/lab3/direction.h"

namespace candela::lab3 {
namespace {

constexpr std::string_view keys[] = {"Eye",   "Target", "Up",         "Fovy",
                                     "ZNear", "ZFar",   "LensRadius", "FocusDistance"};
constexpr Range below_straight{0, 180, true, true, "an angle in degrees above 0 and below 180"};

void check_axes(Reader& reader, const Fields& fields, const description::Camera& camera) {
  const auto place = [&](std::string_view key) {
    const Entry* entry = fields.find(key);
    return entry ? entry->value->offset : fields.offset();
  };
  const Vec3d look = camera.target - camera.eye;
  if (look == Vec3d(0.0)) {
    reader.error(place("Eye"), "Eye and Target are the same point: the camera looks nowhere");
    return;
  }
  if (camera.up == Vec3d(0.0)) {
    reader.error(place("Up"), "Up: found [0, 0, 0], expected a direction");
    return;
  }
  if (are_parallel(look, camera.up))
    reader.error(place("Up"),
                 "Up is parallel to the line of sight (Target - Eye): which way is up?");
}

void read_camera(Reader& reader, const Node& node) {
  const Fields fields(reader, node, "a camera", keys);
  const std::size_t errors_before = reader.diagnostics.error_count();
  description::Camera camera;
  camera.span = reader.span(node.offset);
  camera.eye = fields.vector("Eye", any_number).value_or(camera.eye);
  camera.target = fields.vector("Target", any_number).value_or(camera.target);
  camera.up = fields.vector("Up", any_number).value_or(camera.up);
  camera.fovy_degrees = fields.number("Fovy", below_straight).value_or(camera.fovy_degrees);
  camera.lens_radius = fields.number("LensRadius", not_negative).value_or(0);
  camera.focus_distance = fields.number("FocusDistance", positive).value_or(0);
  (void)fields.number("ZNear", any_number);  // the rasteriser's; looked at, but not used
  const double z_far = fields.number("ZFar", any_number).value_or(100);
  if (reader.scene.cameras.empty()) reader.z_far = z_far;
  if (reader.diagnostics.error_count() == errors_before) check_axes(reader, fields, camera);
  reader.scene.cameras.push_back(camera);
}

}  // namespace

void read_cameras(Reader& reader, const Fields& root) {
  for_each_entry(reader, root, "Cameras", [&](const Node& node) { read_camera(reader, node); });
}

}  // namespace candela::lab3
