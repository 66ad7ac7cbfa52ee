#include "renderer/scene/compile.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/description/lamp_surfaces.h"
#include "renderer/description/used_materials.h"
#include "renderer/description/validate.h"
#include "renderer/material/plain_model.h"
#include "renderer/scene/compile_camera.h"
#include "renderer/scene/compile_coverage.h"
#include "renderer/scene/compile_geometry.h"
#include "renderer/scene/compile_lights.h"
#include "renderer/scene/compile_materials.h"
#include "renderer/scene/compile_media.h"
#include "renderer/scene/normalise.h"

namespace candela {
namespace {

using description::SceneDescription;

// Of an image that is multiplied by what makes its mean the emission.
void check_emission_of_mean(const description::Material& material, const Material& compiled,
                            Diagnostics& diagnostics) {
  if (!compiled.emission_map || !material.emission_is_maps_mean) return;
  if (const float factor = max_component(compiled.emission);
      double{factor} > description::largest_radiance)
    diagnostics.error(
        material.span,
        fmt::format("material '{}': an emission of {:g} is {:g} times the mean of its image, "
                    "expected at most {:g}",
                    material.name, max_component(material.emission), factor,
                    description::largest_radiance));
}

void compile_materials(const SceneDescription& description, const CompileOptions& options,
                       const std::vector<bool>& used, Scene& scene, DropCounts& dropped,
                       Diagnostics& diagnostics) {
  CoatTables coats;
  const Normalisation& n = scene.normalisation;
  TextureCompiler textures(description, scene.textures, diagnostics,
                           {Mat3d(1 / n.scale), n.centre});
  for (std::size_t i = 0; i < description.materials.size(); ++i) {
    const description::Material& material = description.materials[i];
    scene.material_names.push_back(material.name);
    if (used[i]) {
      scene.materials.push_back(compile_material(material, options, n.scale, textures, coats));
      Material& compiled = scene.materials.back();
      check_emission_of_mean(material, compiled, diagnostics);
      for (const MaterialHandle part : compiled.parts) {
        if (!part) continue;
        compiled.reads_uv |= scene.materials[part.index].reads_uv;
        compiled.reads_tangents |= scene.materials[part.index].reads_tangents;
      }
    } else {
      scene.materials.emplace_back();
      ++dropped[DropReason::UnwornMaterials];
    }
  }
}

// Those that rays meet on some triangle, and their parts, which stand before them.
std::vector<bool> met_materials(const Scene& scene) {
  std::vector<bool> met(scene.materials.size(), false);
  for (const Geometry& geometry : scene.geometries) met[geometry.material.index] = true;
  for (std::size_t i = met.size(); i-- > 0;) {
    const Material& material = scene.materials[i];
    if (!met[i] || material.model != MaterialModel::Mix) continue;
    for (const MaterialHandle part : material.parts) met[part.index] = true;
  }
  return met;
}

std::vector<PlainModel> plain_models_of(const Scene& scene) {
  std::vector<PlainModel> models;
  for (const Geometry& geometry : scene.geometries)
    models.push_back(geometry.spheres.empty() && !bounds_media(scene, geometry.material)
                         ? plain_model_of(scene.materials[geometry.material.index])
                         : PlainModel::None);
  return models;
}

SceneFeatures features_of(const Scene& scene) {
  SceneFeatures features;
  const std::vector<bool> met = met_materials(scene);
  for (std::size_t i = 0; i < met.size(); ++i)
    if (met[i]) add_features(scene.materials[i], features);
  for (const Geometry& geometry : scene.geometries) {
    features.spheres |= !geometry.spheres.empty();
    features.area_lights |= geometry.is_emissive();
  }
  features.media = !scene.media.empty();
  for (const Camera& camera : scene.cameras) features.cameras_in_media |= camera.medium.is_valid();
  for (const Medium& medium : scene.media) features.scattering_media |= medium.scatters();
  for (const MediumBoundary& boundary : scene.medium_boundaries)
    features.clear_boundaries |= boundary.is_clear && boundary.is_transition();
  return features;
}

// The sky and media are seen where no surface is.
bool shows_more_than_surfaces(const Scene& scene) {
  const std::optional<Environment>& sky = scene.environment;
  return scene.features.cameras_in_media || (sky && sky->is_seen_by_camera && !sky->is_black());
}

void warn_of_lost_surfaces(const SceneDescription& description, const Scene& scene,
                           const DropCounts& dropped, Diagnostics& diagnostics) {
  if (!scene.geometries.empty() || !has_surface(description)) return;
  std::vector<std::string> reasons;
  for (const auto& [reason, count] : dropped)
    if (is_of_surfaces(reason)) reasons.push_back(fmt::format("{} {}", count, name_of(reason)));
  diagnostics.warning(
      {}, fmt::format("all surfaces are left out ({}): there is {}", fmt::join(reasons, ", "),
                      shows_more_than_surfaces(scene) ? "the background alone" : "nothing to see"));
}

SceneDescription with_lamp_surfaces(SceneDescription description) {
  description::add_lamp_surfaces(description);
  std::erase_if(description.lights, description::is_triangle_light);
  return description;
}

// Without triangle lights. `diagnostics`: what was said of the description.
Result<Scene> compile_valid(const SceneDescription& description, const CompileOptions& options,
                            Diagnostics diagnostics) {
  Scene scene;
  DropCounts dropped;
  scene.normalisation = normalisation_of(description);
  for (const description::Camera& camera : description.cameras)
    check_distances(camera, scene.normalisation, diagnostics);
  if (diagnostics.has_errors()) return diagnostics;
  const std::vector<bool> used = used_materials(description);
  compile_materials(description, options, used, scene, dropped, diagnostics);
  if (diagnostics.has_errors()) return diagnostics;
  for (const description::Camera& camera : description.cameras)
    scene.cameras.push_back(compile_camera(camera, scene.normalisation, options));
  if (options.keeps_media) compile_media(description, used, scene, dropped);
  compile_geometry(description, options, scene, dropped);
  if (options.opacity_grids) compile_coverage(scene);
  scene.bounds = bounds_of(scene);
  compile_lights(description, options, scene, dropped, diagnostics);
  diagnostics.append(scene.textures.broken_lights());
  if (diagnostics.has_errors()) return diagnostics;
  scene.features = features_of(scene);
  scene.plain_models = plain_models_of(scene);
  for (const auto& [reason, count] : dropped) {
    scene.dropped.push_back({std::string(name_of(reason)), count});
    if (may_be_missed(reason))
      diagnostics.warning({}, fmt::format("{} {} are left out", count, name_of(reason)));
  }
  warn_of_lost_surfaces(description, scene, dropped, diagnostics);
  return {std::move(scene), std::move(diagnostics)};
}

}  // namespace

Result<Scene> compile(const SceneDescription& description, const CompileOptions& options) {
  Diagnostics diagnostics = validate(description);
  if (options.width < 1 || options.height < 1)
    diagnostics.error({}, fmt::format("a picture of {} x {} pixels, expected at least 1 x 1",
                                      options.width, options.height));
  if (diagnostics.has_errors()) return diagnostics;
  if (std::ranges::none_of(description.lights, description::is_triangle_light))
    return compile_valid(description, options, std::move(diagnostics));
  return compile_valid(with_lamp_surfaces(description), options, std::move(diagnostics));
}

}  // namespace candela
