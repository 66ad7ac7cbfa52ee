#include "renderer/scene/compile_lights.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "renderer/description/validate.h"
#include "renderer/description/validate_light.h"
#include "renderer/light/build_environment.h"
#include "renderer/light/light_power.h"
#include "renderer/light/make_light.h"
#include "renderer/scene/compile_environment.h"
#include "renderer/scene/compile_image_lights.h"
#include "renderer/scene/compile_quad_lights.h"
#include "renderer/scene/normalise.h"

namespace candela {
namespace {

using description::SceneDescription;

Vec3f to_normalised(const Normalisation& n, const Vec3d& p) {
  return Vec3f((p - n.centre) * n.scale);
}

// The delta light of a kind; nothing for surfaces and environments, which are compiled apart.
struct DeltaLightCompiler {
  const SceneDescription& description;
  const Normalisation& n;
  TextureStore& textures;
  ImageMeans& means;
  Diagnostics& diagnostics;

  std::optional<Light> operator()(const description::PointLight& light) const {
    return make_point_light(to_normalised(n, light.position),
                            normalised_intensity(n, light.intensity));
  }
  std::optional<Light> operator()(const description::SpotLight& light) const {
    return make_spot_light(to_normalised(n, light.position), light.axis,
                           normalised_intensity(n, light.intensity), light.inner_angle_radians,
                           light.outer_angle_radians);
  }
  std::optional<Light> operator()(const description::GoniometricLight& light) const {
    const TextureHandle map = image(light.image);
    if (map)
      warn_unless_square(textures, map, description.images[light.image.index].span, diagnostics);
    return goniometric_light(light, to_normalised(n, light.position), n, map, means);
  }
  std::optional<Light> operator()(const description::ProjectionLight& light) const {
    return projection_light(light, to_normalised(n, light.position), n, image(light.image), means);
  }
  std::optional<Light> operator()(const description::DirectionalLight& light) const {
    return make_directional_light(light.to_light, Rgb(light.irradiance));
  }
  template <class Other>
  std::optional<Light> operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  // Beyond its edges there is nothing to look up: whatever the image says, it does not wrap.
  [[nodiscard]] TextureHandle image(description::ImageHandle handle) const {
    if (!handle) return {};
    description::Image image = description.images[handle.index];
    image.wrap = description::Wrap::Clamp;
    return textures.add_light(image, diagnostics);
  }
};

void add_delta_lights(const SceneDescription& description, Scene& scene, DropCounts& dropped,
                      Diagnostics& diagnostics) {
  ImageMeans means(scene.textures);
  const DeltaLightCompiler compile{description, scene.normalisation, scene.textures, means,
                                   diagnostics};
  for (const description::Light& light : description.lights) {
    const auto compiled = std::visit(compile, light.kind);
    if (!compiled) continue;
    if (!is_finite(compiled->emission))
      diagnostics.error(light.span,
                        "the intensity of a light is more than numbers hold in the unit "
                        "of the scene");
    if (description::is_black(light) || is_black(compiled->emission))  // in single precision
      ++dropped[DropReason::BlackLights];
    else
      scene.lights.push_back(*compiled);
  }
}

Light triangle_light(const Geometry& geometry, const Material& material, std::size_t index,
                     std::size_t triangle) {
  const auto& t = geometry.triangles[triangle];
  Light light = make_triangle_light(
      {geometry.positions[t[0]], geometry.positions[t[1]], geometry.positions[t[2]]},
      material.emission, material.emits_both_sides);
  light.geometry = static_cast<std::uint32_t>(index);
  light.triangle = static_cast<std::uint32_t>(triangle);
  if (!material.emission_map) return light;
  light.kind = LightKind::TexturedTriangle;
  light.texture = material.emission_map;
  return light;
}

Light sphere_light(const Geometry& geometry, const Material& material, std::size_t index,
                   std::size_t sphere) {
  Light light =
      make_sphere_light(geometry.spheres[sphere], material.emission, material.emits_both_sides);
  light.geometry = static_cast<std::uint32_t>(index);
  light.triangle = static_cast<std::uint32_t>(sphere);
  light.texture = material.emission_map;
  return light;
}

std::size_t textured_lamp_triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Geometry& geometry : scene.geometries)
    if (scene.materials[geometry.material.index].emission_map) count += geometry.triangles.size();
  return count;
}

void add_surface_lights(Scene& scene) {
  ImageMeans means(scene.textures);
  const std::size_t textured = textured_lamp_triangles(scene);
  for (std::size_t g = 0; g < scene.geometries.size(); ++g) {
    Geometry& geometry = scene.geometries[g];
    const Material& material = scene.materials[geometry.material.index];
    if (!material.is_emissive()) continue;
    geometry.first_light = static_cast<std::uint32_t>(scene.lights.size());
    for (std::size_t i = 0; i < geometry.triangles.size(); ++i)
      scene.lights.push_back(triangle_light(geometry, material, g, i));
    for (std::size_t i = 0; i < geometry.spheres.size(); ++i)
      scene.lights.push_back(sphere_light(geometry, material, g, i));
    if (material.emission_map) set_mean_emission(geometry, textured, means, scene.lights);
  }
}

void add_environment(const SceneDescription& description, const CompileOptions& options,
                     Scene& scene, Diagnostics& diagnostics) {
  scene.environment = compile_environments(description, scene.textures, diagnostics);
  if (!scene.environment || scene.environment->is_black()) return;
  if (scene.environment->is_constant() && !options.samples_constant_sky) return;
  if (!scene.environment->is_constant() && options.compensates_sky)
    scene.environment->distribution = compensated(scene.environment->distribution);
  scene.environment_light = static_cast<std::uint32_t>(scene.lights.size());
  scene.lights.push_back(make_environment_light());
}

// lab3's ambient term, else what constant environments shed where nothing is in their way.
Rgb ambient_of(const SceneDescription& description) {
  if (description.lab_ambient) return Rgb(*description.lab_ambient);
  return Rgb(sum_of_constants(description));
}

bool is_infinitely_far(const Light& light) {
  return light.kind == LightKind::Environment || light.kind == LightKind::Directional;
}

// The power of a light at infinity grows with the square of the scene's size, whatever of it
// reaches what is seen: a far outlier or a wide ground would leave nothing for the lamps. Together
// such lights are picked at most every other time.
void limit_far_powers(const std::vector<Light>& lights, std::vector<double>& powers) {
  double near = 0;
  double far = 0;
  for (std::size_t i = 0; i < lights.size(); ++i)
    (is_infinitely_far(lights[i]) ? far : near) += powers[i];
  if (!(near > 0) || far <= near) return;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (is_infinitely_far(lights[i])) powers[i] *= near / far;
}

// A sample of a lamp does not know whether the lamp is there: those with holes are left to the
// directions that surfaces scatter in, which meet them as often as they are.
bool has_holes(const Scene& scene, const Light& light) {
  return light.geometry != Light::none && scene.geometries[light.geometry].has_cutouts;
}

// Emissive triangles too small to have a power stay in the table, since others count on their
// order; nothing ever picks them.
LightSampler build_light_sampler(const Scene& scene) {
  const double radius = scene.bounds.is_empty() ? 1.0 : 0.5 * length(Vec3d(scene.bounds.extent()));
  std::vector<double> powers;
  powers.reserve(scene.lights.size());
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    const Environment* environment = scene.environment ? &*scene.environment : nullptr;
    const bool is_part_of_quad = light.quad != Light::none && light.quad != i;
    powers.push_back(
        is_part_of_quad || has_holes(scene, light) ? 0 : light_power(light, environment, radius));
  }
  limit_far_powers(scene.lights, powers);
  return {scene.lights, powers};
}

// What is looked up in images is to be held by floats as well.
void check_images(const Scene& scene, Diagnostics& diagnostics) {
  std::set<std::pair<std::size_t, float>> seen;
  const auto check = [&](TextureHandle image, const Rgb& scale, double most) {
    const float factor = max_component(scale);
    if (image && seen.emplace(image.index, factor).second)
      scene.textures.check_brightness(image, double{factor}, most, diagnostics);
  };
  for (const Light& light : scene.lights)
    check(light.texture, light.emission,
          light.is_delta() ? double{std::numeric_limits<float>::max()}
                           : description::largest_radiance);
}

bool is_dark(const Scene& scene) {
  if (!is_black(scene.ambient) || (scene.environment && !scene.environment->is_black()))
    return false;
  return std::ranges::all_of(scene.lights, [](const Light& light) {
    return light.kind == LightKind::Environment || light_power(light, nullptr, 1) <= 0;
  });
}

}  // namespace

void compile_lights(const SceneDescription& description, const CompileOptions& options,
                    Scene& scene, DropCounts& dropped, Diagnostics& diagnostics) {
  add_delta_lights(description, scene, dropped, diagnostics);
  add_surface_lights(scene);
  const bool by_solid_angle = options.light_sampling == LightSampling::SolidAngle;
  if (options.light_sampling != LightSampling::Triangles) add_quad_lights(scene, by_solid_angle);
  if (by_solid_angle) sample_triangles_by_solid_angle(scene);
  add_environment(description, options, scene, diagnostics);
  check_images(scene, diagnostics);
  scene.ambient = ambient_of(description);
  if (has_light(description) && is_dark(scene))
    diagnostics.warning({}, "all lights are black or left out: the picture will be black");
  scene.light_sampler = build_light_sampler(scene);
  if (options.light_cells) scene.light_sampler.make_cells(scene.lights, scene.bounds);
}

}  // namespace candela
