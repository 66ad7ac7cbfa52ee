#include "scene_io/pbrt/write/write_materials.h"

#include "scene_io/pbrt/write/write_model.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::DielectricMaterial;
using description::LabMaterial;
using description::Material;
using description::MixMaterial;
using description::ScalarInput;
using description::SceneDescription;

bool varies(const auto& input) {
  return !input.is_constant();
}
// A second width asks for the directions of u and v even where both are constant.
bool varies(const ScalarInput& along, const std::optional<ScalarInput>& across) {
  return varies(along) || across;
}
bool varies(const description::Coat& coat) {
  return varies(coat.roughness, coat.roughness_across);
}

bool is_bumped(const Material& material) {
  return (material.height || material.height_texture) && material.height_scale != 0;
}

struct Textured {
  const SceneDescription& scene;

  bool operator()(const LabMaterial& m) const { return varies(m.diffuse) || varies(m.specular); }
  bool operator()(const description::CookTorranceMaterial& m) const {
    return varies(m.diffuse) || varies(m.specular) || varies(m.roughness);
  }
  bool operator()(const description::DiffuseMaterial& m) const { return varies(m.reflectance); }
  bool operator()(const description::MirrorMaterial& m) const { return varies(m.reflectance); }
  bool operator()(const description::ConductorMaterial& m) const {
    return varies(m.roughness, m.roughness_across) || (m.reflectance && varies(*m.reflectance));
  }
  bool operator()(const DielectricMaterial& m) const {
    return varies(m.roughness, m.roughness_across);
  }
  bool operator()(const description::CoatedDiffuseMaterial& m) const {
    return varies(m.reflectance) || varies(m.coat);
  }
  bool operator()(const description::CoatedConductorMaterial& m) const {
    return varies(m.roughness, m.roughness_across) || varies(m.coat);
  }
  bool operator()(const description::DiffuseTransmissionMaterial& m) const {
    return varies(m.reflectance) || varies(m.transmittance);
  }
  bool operator()(const description::InterfaceMaterial&) const { return false; }
  bool operator()(const MixMaterial& m) const {
    return varies(m.amount) || is_textured(scene, scene.materials[m.first.index]) ||
           is_textured(scene, scene.materials[m.second.index]);
  }
};

}  // namespace

bool has_heights_by_uv(const SceneDescription& scene, const Material& material) {
  if (const auto* mix = std::get_if<MixMaterial>(&material.model))
    return has_heights_by_uv(scene, scene.materials[mix->first.index]) ||
           has_heights_by_uv(scene, scene.materials[mix->second.index]);
  return is_bumped(material) && !material.heights_are_lengths;
}

bool is_textured(const SceneDescription& scene, const Material& material) {
  return std::visit(Textured{scene}, material.model) || varies(material.opacity) ||
         material.height || material.height_texture || material.normal_map || material.emission_map;
}

std::string MaterialWriter::name_of(description::MaterialHandle handle, double height_unit) {
  const auto [at, is_new] = names_.try_emplace({handle.index, height_unit});
  if (is_new) at->second = make(context_.scene.materials[handle.index], height_unit);
  return at->second;
}

std::string MaterialWriter::make(const Material& material, double height_unit) {
  const std::string wish = material.name.empty() ? "unnamed" : material.name;
  const std::string name = context_.unique_name("material", wish);
  if (const auto* mix = std::get_if<MixMaterial>(&material.model)) {
    const Directive out = mixture(name, *mix, height_unit);
    text_ += out.text();
    return name;
  }
  WrittenModel model = write_model(name, material, context_, textures_);
  for (Directive& part : model.parts) {
    add_surface(material, height_unit, part);
    text_ += part.text();
  }
  add_surface(material, height_unit, model.directive);
  text_ += model.directive.text();
  return name;
}

// Its parts come before it, with their own heights and normals.
Directive MaterialWriter::mixture(const std::string& name, const MixMaterial& mix,
                                  double height_unit) {
  Directive out("MakeNamedMaterial", name);
  out.add("string type", "mix");
  out.add("string materials", std::vector<std::string>{name_of(mix.first, height_unit),
                                                       name_of(mix.second, height_unit)});
  return out.add(textures_.scalar("amount", mix.amount));
}

bool MaterialWriter::has_heights(const Material& material) {
  return is_bumped(material) && (material.height_texture || textures_.facts_of(material.height));
}

// pbrt's heights are lengths.
void MaterialWriter::add_surface(const Material& material, double height_unit, Directive& out) {
  if (has_heights(material) && material.heights_are_lengths)
    out.add(textures_.heights("displacement", material, material.height_scale));
  else if (has_heights(material))
    out.add(textures_.heights("displacement", material, material.height_scale * height_unit))
        .add_own(textures_.heights("heights", material, 1))
        .add_own("float heightscale", material.height_scale);
  if (!material.normal_map) return;
  const std::string file = textures_.file_of(material.normal_map);
  if (file.empty()) return;
  if (has_heights(material))
    context_.warn(material.span,
                  fmt::format("material '{}': lost for pbrt: its heights, beside its "
                              "map of normals",
                              material.name));
  out.add("string normalmap", file);
  if (!material.normal_map_is_right_handed) out.add_own("bool normalsalongv", true);
}

// lab3 takes alpha from the diffuse map where there is one.
void MaterialWriter::add_alpha(const Material& material, Directive& shape) {
  const ScalarInput& opacity = material.opacity;
  const auto* lab = std::get_if<LabMaterial>(&material.model);
  if (varies(opacity) || opacity.factor != 1) {
    shape.add(textures_.scalar("alpha", opacity));
  } else if (lab && lab->diffuse.map) {
    if (const auto alpha = textures_.map_alpha("alpha", lab->diffuse.map)) shape.add(*alpha);
  } else if (lab && !varies(lab->diffuse) && lab->alpha != 1) {
    shape.add("float alpha", lab->alpha);
  }
}

}  // namespace candela::pbrt
