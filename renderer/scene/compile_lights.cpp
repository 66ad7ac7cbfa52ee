#include "renderer/scene/compile_lights.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include "renderer/description/validate.h"
#include "renderer/description/validate_light.h"
#include "renderer/light/build_environment.h"
#include "renderer/light/light_power.h"
#include "renderer/light/make_light.h"
#include "renderer/scene/compile_environment.h"
#include "renderer/scene/compile_image_lights.h"
#include "renderer/scene/compile_quad_lights.h"

namespace candela {
namespace {

using description::SceneDescription;
using description::TriangleLight;

// Only triangle lights of one kind may be parts of one lamp.
using SurfaceKind = std::tuple<double, double, double, bool>;

SurfaceKind kind_of(const TriangleLight& light) {
  return {light.radiance.x, light.radiance.y, light.radiance.z, light.emits_both_sides};
}

description::Material black_emitter(const TriangleLight& light, const SourceSpan& span) {
  description::Material material;
  material.name = "area light";
  material.span = span;
  material.model = description::DiffuseMaterial{{Vec3d(0.0), {}}};
  material.emission = light.radiance;
  material.emits_both_sides = light.emits_both_sides;
  return material;
}

std::vector<const description::Light*> triangle_lights(const SceneDescription& description) {
  std::vector<const description::Light*> lights;
  for (const description::Light& light : description.lights)
    if (std::holds_alternative<TriangleLight>(light.kind)) lights.push_back(&light);
  return lights;
}

std::size_t root_of(std::vector<std::size_t>& parents, std::size_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

// Triangles of a kind that share corners, over others too, are one lamp: of each light the first
// one of its lamp.
std::vector<std::size_t> lamps_of(const std::vector<const description::Light*>& lights) {
  std::vector<std::size_t> parents(lights.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  std::map<std::tuple<SurfaceKind, double, double, double>, std::size_t> corners;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& triangle = std::get<TriangleLight>(lights[i]->kind);
    for (const Vec3d& p : triangle.vertices) {
      const auto at = corners.try_emplace({kind_of(triangle), p.x, p.y, p.z}, i).first;
      const std::size_t other = root_of(parents, at->second);
      const std::size_t own = root_of(parents, i);
      parents[std::max(own, other)] = std::min(own, other);
    }
  }
  for (std::size_t& parent : parents) parent = root_of(parents, parent);
  return parents;
}

Vec3f to_normalised(const Normalisation& n, const Vec3d& p) {
  return Vec3f((p - n.centre) * n.scale);
}

// Radiant intensity has a squared length in it: irradiance at the same place must stay the same.
// Infinite where floats do not hold it.
Rgb scaled_intensity(const Normalisation& n, const Vec3d& intensity) {
  constexpr double largest = std::numeric_limits<float>::max();
  const Vec3d scaled = intensity * (n.scale * n.scale);
  return max_component(scaled) <= largest ? Rgb(scaled) : Rgb(infinity);
}

// The delta light of a kind; nothing for surfaces and environments, which are compiled apart.
struct DeltaLightCompiler {
  const SceneDescription& description;
  const Normalisation& n;
  TextureStore& textures;
  ImageMeans& means;
  Diagnostics& diagnostics;

  std::optional<Light> operator()(const description::PointLight& light) const {
    return make_point_light(to_normalised(n, light.position), scaled_intensity(n, light.intensity));
  }
  std::optional<Light> operator()(const description::SpotLight& light) const {
    return make_spot_light(to_normalised(n, light.position), light.axis,
                           scaled_intensity(n, light.intensity), light.inner_angle_radians,
                           light.outer_angle_radians);
  }
  std::optional<Light> operator()(const description::GoniometricLight& light) const {
    const TextureHandle map = image(light.image);
    if (map)
      warn_unless_square(textures, map, description.images[light.image.index].span, diagnostics);
    return goniometric_light(light, to_normalised(n, light.position),
                             scaled_intensity(n, Vec3d(1.0)).x, map, means);
  }
  std::optional<Light> operator()(const description::ProjectionLight& light) const {
    return projection_light(light, to_normalised(n, light.position),
                            scaled_intensity(n, Vec3d(1.0)).x, image(light.image), means);
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

bool is_dark(const Scene& scene) {
  if (!is_black(scene.ambient) || (scene.environment && !scene.environment->is_black()))
    return false;
  return std::ranges::all_of(scene.lights, [](const Light& light) {
    return light.kind == LightKind::Environment || light_power(light, nullptr, 1) <= 0;
  });
}

}  // namespace

void add_triangle_light_surfaces(SceneDescription& description) {
  const std::vector<const description::Light*> lights = triangle_lights(description);
  const std::vector<std::size_t> lamps = lamps_of(lights);
  std::map<std::size_t, std::size_t> meshes;  // of the lamps
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& triangle = std::get<TriangleLight>(lights[i]->kind);
    const auto [at, is_new] = meshes.try_emplace(lamps[i], description.meshes.size());
    if (is_new) {
      description::Mesh mesh;
      mesh.name = "area light";
      mesh.materials.emplace_back(description.materials.size());
      description.materials.push_back(black_emitter(triangle, lights[i]->span));
      description.instances.push_back(
          {description::MeshHandle(description.meshes.size()), {}, {}, lights[i]->span});
      description.meshes.push_back(std::move(mesh));
    }
    description::Mesh& mesh = description.meshes[at->second];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), triangle.vertices.begin(), triangle.vertices.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
}

void compile_lights(const SceneDescription& description, const CompileOptions& options,
                    Scene& scene, DropCounts& dropped, Diagnostics& diagnostics) {
  add_delta_lights(description, scene, dropped, diagnostics);
  add_surface_lights(scene);
  const bool by_solid_angle = options.light_sampling == LightSampling::SolidAngle;
  if (options.light_sampling != LightSampling::Triangles) add_quad_lights(scene, by_solid_angle);
  if (by_solid_angle) sample_triangles_by_solid_angle(scene);
  add_environment(description, options, scene, diagnostics);
  scene.ambient = ambient_of(description);
  if (has_light(description) && is_dark(scene))
    diagnostics.warning({}, "all lights are black or left out: the picture will be black");
  scene.light_sampler = build_light_sampler(scene);
  if (options.light_cells) scene.light_sampler.make_cells(scene.lights, scene.bounds);
}

}  // namespace candela
