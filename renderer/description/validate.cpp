#include "renderer/description/validate.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/description/validate_camera.h"
#include "renderer/description/validate_light.h"
#include "renderer/description/validate_material.h"
#include "renderer/description/validate_medium.h"
#include "renderer/description/validate_mesh.h"
#include "renderer/description/validate_texture.h"

namespace candela::description {
namespace {

void check_instance(const SceneDescription& scene, const Instance& instance,
                    Diagnostics& diagnostics) {
  const Transform& placement = instance.object_to_world;
  const Mat3d& linear = placement.linear;
  if (instance.mesh.index >= scene.meshes.size())
    diagnostics.error(instance.span, "an instance of a mesh that does not exist");
  const MaterialHandle material = instance.material_override;
  if (material && material.index >= scene.materials.size())
    diagnostics.error(instance.span, "an instance has a material that does not exist");
  if (!is_finite(linear[0]) || !is_finite(linear[1]) || !is_finite(linear[2]) ||
      !is_finite(placement.translation))
    diagnostics.error(instance.span,
                      "the transform of an instance has numbers that are not finite");
  else if (is_singular(linear))
    diagnostics.error(instance.span, "the transform of an instance is singular: it flattens it");
  else if (instance.mesh.index < scene.meshes.size() && scene.meshes[instance.mesh.index].sphere &&
           similarity_scale(placement) == 0)
    diagnostics.error(instance.span,
                      "the transform of a sphere stretches or shears it, expected one that turns, "
                      "moves, mirrors and enlarges only");
}

void check_images(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (const Image& image : scene.images)
    if (image.path.empty())
      diagnostics.error(image.span, "an image without a file name");
    else if (image.encoding > Encoding::LabGamma || image.wrap > Wrap::Black)
      diagnostics.error(image.span, "an image of an encoding or a wrap that there is not");
}

void check_defaults(const SceneDescription& scene, Diagnostics& diagnostics) {
  const std::optional<double>& radius = scene.defaults.filter_radius;
  constexpr double widest = RenderDefaults::widest_filter;
  if (radius && !(*radius > 0 && *radius <= widest))
    diagnostics.error({}, fmt::format("the filter's radius is {} pixels, expected above 0 and at "
                                      "most {}",
                                      *radius, widest));
  if (const std::optional<CropWindow>& crop = scene.defaults.crop) {
    const auto is_part = [](double low, double high) {
      return low >= 0 && low < high && high <= 1;
    };
    if (!is_part(crop->left, crop->right) || !is_part(crop->top, crop->bottom))
      diagnostics.error({},
                        fmt::format("the crop window is {} to {} by {} to {}, expected parts of "
                                    "0 to 1",
                                    crop->left, crop->right, crop->top, crop->bottom));
  }
}

void check_ambient(const SceneDescription& scene, Diagnostics& diagnostics) {
  if (!scene.lab_ambient) return;
  for (int c = 0; c < 3; ++c)
    if (!((*scene.lab_ambient)[c] >= 0 && (*scene.lab_ambient)[c] <= largest_radiance))
      return diagnostics.error({}, fmt::format("the ambient light is {}, expected 0 to {:g}",
                                               (*scene.lab_ambient)[c], largest_radiance));
}

SourceSpan whole_file(const SceneDescription& scene) {
  if (scene.path.empty()) return {};
  return {std::make_shared<const std::string>(scene.path), 0, 0};
}

bool is_clear(const Medium& medium) {
  return medium.absorption + medium.scattering == Vec3d(0.0);
}

// Skies and media around cameras are seen where no surface is.
bool has_anything_to_see(const SceneDescription& scene) {
  return has_surface(scene) || std::ranges::any_of(scene.lights, is_seen_sky) ||
         std::ranges::any_of(scene.cameras, [&](const Camera& camera) {
           return camera.medium && !is_clear(scene.media[camera.medium.index]);
         });
}

void warn_of_nothing_to_see(const SceneDescription& scene, Diagnostics& diagnostics) {
  if (!has_anything_to_see(scene))
    diagnostics.warning(whole_file(scene), "the scene has no surface: there is nothing to see");
  if (!has_light(scene))
    diagnostics.warning(whole_file(scene), "the scene has no light: the picture will be black");
}

}  // namespace

bool has_light(const SceneDescription& scene) {
  const auto shines = [](const Light& light) { return !is_black(light); };
  const auto glows = [](const Material& material) { return material.emission != Vec3d(0.0); };
  return std::any_of(scene.lights.begin(), scene.lights.end(), shines) ||
         std::any_of(scene.materials.begin(), scene.materials.end(), glows);
}

bool has_surface(const SceneDescription& scene) {
  const auto is_surface = [](const Light& light) {
    return std::holds_alternative<TriangleLight>(light.kind);
  };
  const auto has_any = [&](const Instance& instance) {
    return instance.mesh.index < scene.meshes.size() &&
           (!scene.meshes[instance.mesh.index].triangles.empty() ||
            scene.meshes[instance.mesh.index].sphere);
  };
  return std::ranges::any_of(scene.instances, has_any) ||
         std::ranges::any_of(scene.lights, is_surface);
}

Diagnostics validate(const SceneDescription& scene) {
  const FloatingPointTraps traps(Traps::Off);  // what is looked at may be no number
  Diagnostics diagnostics;
  check_images(scene, diagnostics);
  check_textures(scene, diagnostics);
  check_media(scene, diagnostics);
  for (const Material& material : scene.materials) check_material(scene, material, diagnostics);
  check_mixtures(scene, diagnostics);
  for (const Mesh& mesh : scene.meshes) check_mesh(scene, mesh, diagnostics);
  for (const Instance& instance : scene.instances) check_instance(scene, instance, diagnostics);
  check_lights(scene, diagnostics);
  check_cameras(scene, diagnostics);
  check_defaults(scene, diagnostics);
  check_ambient(scene, diagnostics);
  if (!diagnostics.has_errors()) warn_of_nothing_to_see(scene, diagnostics);
  return diagnostics;
}

}  // namespace candela::description
