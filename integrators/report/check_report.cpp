#include "integrators/report/check_report.h"

#include <string_view>

#include <fmt/format.h>

#include "integrators/name_of_delta_light.h"
#include "renderer/description/used_materials.h"
#include "renderer/image/decode.h"
#include "renderer/material/coverage.h"

namespace candela {
namespace {

using namespace description;

// What of a material the report lacks, or "".
struct NameOfUnknownModel {
  std::string_view operator()(const MirrorMaterial&) const {
    return "a mirror, in which the report integrator would miss the lamps";
  }
  std::string_view operator()(const ConductorMaterial&) const { return "a conductor"; }
  std::string_view operator()(const DielectricMaterial&) const {
    return "a dielectric, in and behind which the report integrator would miss the lamps";
  }
  std::string_view operator()(const CoatedDiffuseMaterial&) const { return "coated"; }
  std::string_view operator()(const CoatedConductorMaterial&) const { return "coated"; }
  std::string_view operator()(const DiffuseTransmissionMaterial&) const {
    return "seen from behind";
  }
  std::string_view operator()(const InterfaceMaterial&) const { return "an interface"; }
  std::string_view operator()(const MixMaterial&) const { return "a mixture"; }
  template <class Known>
  std::string_view operator()(const Known&) const {
    return "";
  }
};

bool is_black(const ColourInput& colour) {
  return colour.is_constant() && colour.factor == Vec3d(0.0);
}

struct ReflectsNothing {
  bool operator()(const DiffuseMaterial& m) const { return is_black(m.reflectance); }
  bool operator()(const LabMaterial& m) const {
    return is_black(m.diffuse) && is_black(m.specular);
  }
  bool operator()(const CookTorranceMaterial& m) const {
    return is_black(m.diffuse) && is_black(m.specular);
  }
  template <class Other>
  bool operator()(const Other&) const {
    return true;  // refused anyway
  }
};

// An image that cannot be read is wholly opaque magenta.
bool has_alpha(const Image& image) {
  const Result<ImageHeader> header = read_image_header(image.path, DecodeLimits{});
  return header && header->alpha_channel >= 0;
}

// Of lab3's materials the alpha is the diffuse map's where there is one, else `d`.
bool has_holes(const Material& material, const SceneDescription& scene) {
  if (!material.opacity.is_constant() || material.opacity.factor != 1.0) return true;
  const auto* lab = std::get_if<LabMaterial>(&material.model);
  if (lab == nullptr) return false;
  if (lab->diffuse.map) return has_alpha(scene.images[lab->diffuse.map.index]);
  const auto alpha = static_cast<float>(lab->alpha);
  return coverage_of_range(alpha, alpha, true) != Coverage::Opaque;
}

void check_material(const Material& material, const SceneDescription& scene,
                    Diagnostics& diagnostics) {
  // A file's material may be several here: of shapes that shine or bound media, and of others.
  const auto tell = [&](Severity severity, std::string sentence) {
    diagnostics.add_once(
        {severity, material.span, fmt::format("material '{}' {}", material.name, sentence), {}});
  };
  const std::string_view unknown = std::visit(NameOfUnknownModel{}, material.model);
  if (!unknown.empty())
    tell(Severity::Error,
         fmt::format("is {}; expected diffuse, cook_torrance or a lab3 material", unknown));
  if (material.emission_map)
    tell(Severity::Error, "emits by a texture; the report integrator knows lamps that emit evenly");
  if (material.emission != Vec3d(0.0) && has_holes(material, scene))
    tell(Severity::Error,
         "emits and has holes (opacity); light samples of the report integrator would shine "
         "through them");
  if (material.emission != Vec3d(0.0) && !std::visit(ReflectsNothing{}, material.model))
    tell(Severity::Warning,
         "emits and reflects; in the report integrator emitters reflect nothing");
}

// "" of lights that are no environment, and of black ones.
struct NameOfEnvironment {
  std::string_view operator()(const ConstantEnvironment& light) const {
    if (light.radiance == Vec3d(0.0)) return "";
    return light.is_seen_by_camera ? "a constant environment"
                                   : "ambient light (--ambient 0,0,0 takes it out)";
  }
  std::string_view operator()(const CubeEnvironment&) const { return "a skybox"; }
  std::string_view operator()(const LatLongEnvironment&) const { return "an environment map"; }
  std::string_view operator()(const EqualAreaEnvironment&) const { return "an environment map"; }
  template <class Other>
  std::string_view operator()(const Other&) const {
    return "";
  }
};

// What kind of light is no surface, or "".
std::string_view name_of_unknown_light(const Light& light) {
  const std::string_view delta = name_of_delta_light(light);
  return delta.empty() ? std::visit(NameOfEnvironment{}, light.kind) : delta;
}

void check_instance(const SceneDescription& scene, const Instance& instance,
                    Diagnostics& diagnostics) {
  if (instance.mesh.index >= scene.meshes.size()) return;
  const Mesh& mesh = scene.meshes[instance.mesh.index];
  if (!mesh.sphere || mesh.materials.size() != 1) return;
  const MaterialHandle material =
      instance.material_override ? instance.material_override : mesh.materials[0];
  if (material.index < scene.materials.size() &&
      scene.materials[material.index].emission != Vec3d(0.0))
    diagnostics.error(instance.span,
                      "this sphere emits; the report integrator knows lamps of triangles only");
}

}  // namespace

Diagnostics check_report(const SceneDescription& scene) {
  Diagnostics diagnostics;
  const std::vector<bool> is_used = used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (is_used[i]) check_material(scene.materials[i], scene, diagnostics);
  for (const Instance& instance : scene.instances) check_instance(scene, instance, diagnostics);
  for (const Light& light : scene.lights) {
    const std::string_view unknown = name_of_unknown_light(light);
    if (unknown.empty()) continue;
    diagnostics.error(light.span, fmt::format("the scene has {}; the report integrator knows "
                                              "lamps with an area only (materials with Emission, "
                                              "lights of Type Area)",
                                              unknown));
  }
  return diagnostics;
}

}  // namespace candela
