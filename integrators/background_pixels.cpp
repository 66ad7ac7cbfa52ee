#include "integrators/background_pixels.h"

#include "integrators/pixel_cover.h"
#include "integrators/trial.h"
#include "renderer/geometry/world_to_object.h"
#include "renderer/scene/object_bounds.h"

namespace candela {
namespace {

// What the camera sees where there is nothing, if that is the same everywhere.
std::optional<Rgb> constant_background(const Scene& scene, const RenderOptions& options) {
  if (!scene.environment || options.transparent) return Rgb(0);
  const Environment& environment = *scene.environment;
  if (!environment.is_seen_by_camera) return Rgb(0);
  if (!environment.is_constant()) return {};
  return environment.scale;
}

// Boxes, of instances and spheres, count as what they consist of.
std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const GeometryHandle handle : scene.world.geometries)
    count += scene.geometries[handle.index].triangles.size() +
             12 * scene.geometries[handle.index].spheres.size();
  return count + 12 * scene.instances.size();
}

// A look at a triangle takes about as long as a few samples' rays. By the whole picture, since
// which pixels share blocks depends on it.
bool is_worth_it(const Scene& scene, const RenderOptions& options) {
  constexpr double fewest_samples = 16;  // a triangle
  return picture_samples(options) >= fewest_samples * static_cast<double>(triangle_count(scene));
}

// An instance's box, widened by what rounding moves.
Bounds3f wide_bounds_of(const Instance& instance, const Bounds3f& object) {
  const Vec3f moved{instance.offset({1, 0, 0}), instance.offset({0, 1, 0}),
                    instance.offset({0, 0, 1})};
  const Bounds3f box = bounds_of(instance, object);
  return {box.lower - moved * 2.0f, box.upper + moved * 2.0f};
}

void add_instances(const Scene& scene, PixelCover& cover) {
  const std::vector<Bounds3f> objects = bounds_of_objects(scene);
  for (const Instance& instance : scene.instances) {
    const Bounds3f& object = objects[instance.object.index];
    if (object.is_empty()) continue;
    cover.add(wide_bounds_of(instance, object));
  }
}

}  // namespace

BackgroundPixels::BackgroundPixels(const Scene& scene, const Filter& filter,
                                   const RenderOptions& options) {
  const Camera& camera = scene.cameras[options.camera];
  if (!options.savings.skips_background || filter.is_signed() || scene.features.media) return;
  if (const std::optional<Rgb> background = constant_background(scene, options)) {
    sample_.emplace();
    sample_->radiance = *background;
    sample_->alpha = 0;
  }
  if (scene.bounds.is_empty()) {
    covered_.emplace();
    return;
  }
  if (!PixelCover::has_projection(camera) || !is_worth_it(scene, options)) return;
  PixelCover cover(camera, scene.bounds, filter, options.width, options.height);
  for (const GeometryHandle handle : scene.world.geometries)
    cover.add(scene.geometries[handle.index]);
  add_instances(scene, cover);
  covered_ = cover.covered();
}

}  // namespace candela
