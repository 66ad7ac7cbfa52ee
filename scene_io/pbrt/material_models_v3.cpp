// The materials of pbrt-v3 under their old names, by the nearest model that candela has.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/reflectance.h"
#include "scene_io/pbrt/materials.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::CookTorranceMaterial;
using description::Material;
using description::ScalarInput;

// pbrt-v3's RoughnessToAlpha: a polynomial of the logarithm.
double width_of(double roughness) {
  const double x = std::log(std::clamp(roughness, 1e-3, 1.0));
  return std::min(1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711))), 1.0);
}

// Of textures 1.5 times the root, which is within a tenth of the polynomial.
ScalarInput width_of(MaterialReader& reader, const ScalarInput& roughness, bool remaps) {
  if (!roughness.is_constant()) {
    if (!remaps) return roughness;
    const Place& place = reader.arguments.statement().place;
    return reader.textures.scaled(reader.textures.square_root(roughness, place), 1.5, place);
  }
  if (roughness.factor <= 0) return {0.0, {}, 0, {}};  // glass and mirrors that are smooth say it
  return {remaps ? width_of(roughness.factor) : std::min(roughness.factor, 1.0), {}, 0, {}};
}

Widths read_widths_v3(MaterialReader& reader, double otherwise) {
  const ScalarInput both = reader.textures.scalar(reader.arguments, "roughness")
                               .value_or(ScalarInput{otherwise, {}, 0, {}});
  const ScalarInput u = reader.textures.scalar(reader.arguments, "uroughness").value_or(both);
  const ScalarInput v = reader.textures.scalar(reader.arguments, "vroughness").value_or(both);
  const bool remaps = reader.arguments.flag("remaproughness", true);
  Widths widths{width_of(reader, u, remaps), {}};
  if (v != u) widths.across = width_of(reader, v, remaps);
  return widths;
}

template <class Rough>
void set_widths(MaterialReader& reader, double otherwise, Rough& rough) {
  const Widths widths = read_widths_v3(reader, otherwise);
  rough.roughness = widths.along;
  rough.roughness_across = widths.across;
}

// Textures of Kd are taken for no brighter than this: brighter texels are scaled down with ks.
constexpr double bright_texel = 0.8;

// kd + ks is at most 1 here: where the file asks for more, ks is what kd leaves, and F0 makes up
// for it straight on, as far as it can. `largest_diffuse`: of kd, where that is a texture.
void fit_specular(CookTorranceMaterial& material, const Vec3d& largest_diffuse) {
  if (!material.specular.is_constant()) return;
  const bool is_even = material.diffuse.is_constant();
  const Vec3d left = Vec3d(1.0) - (is_even ? material.diffuse.factor : largest_diffuse);
  Vec3d& ks = material.specular.factor;
  if (glm::all(glm::lessThanEqual(ks, left))) return;
  if (material.fresnel == description::FresnelModel::Exact) {
    material.f0 = normal_reflectance(Vec3d(*material.ior), Vec3d(0.0));
    material.fresnel = description::FresnelModel::Schlick;
    material.ior.reset();
  }
  for (int c = 0; c < 3; ++c) {
    if (ks[c] <= left[c]) continue;
    material.f0[c] = left[c] > 0 ? std::min(material.f0[c] * ks[c] / left[c], 1.0) : 0;
    ks[c] = left[c];
  }
}

// A diffuse surface and microfacets on it, their sum as it is in pbrt-v3.
CookTorranceMaterial glossy(MaterialReader& reader, double diffuse, double specular) {
  CookTorranceMaterial material;
  material.diffuse = reader.reflectance("Kd", diffuse);
  material.specular = reader.reflectance("Ks", specular);
  const Widths widths = read_widths_v3(reader, 0.1);
  material.roughness = widths.along;
  if (widths.across)
    reader.arguments.ignore("vroughness", "highlights are as wide along v as along u here");
  if (material.roughness.is_constant() && material.roughness.factor <= 0)
    material.roughness.factor = 1e-3;
  material.geometry = description::GeometryModel::Smith;
  material.fresnel = description::FresnelModel::Exact;
  material.ior = 1.5;
  return material;
}

CookTorranceMaterial plastic(MaterialReader& reader) {
  CookTorranceMaterial material = glossy(reader, 0.25, 0.25);
  fit_specular(material, Vec3d(bright_texel));
  return material;
}

CookTorranceMaterial uber(MaterialReader& reader) {
  CookTorranceMaterial material = glossy(reader, 0.25, 0.25);
  const double ior =
      std::max(reader.scalar(reader.arguments.has("eta") ? "eta" : "index", 1.5), 1.0);
  material.ior = ior;
  for (const std::string_view name : {"Kr", "Kt", "opacity"})
    reader.arguments.ignore(name, "an uber material is diffuse and glossy here");
  fit_specular(material, Vec3d(bright_texel));
  return material;
}

void warn_of_texture(MaterialReader& reader, std::string_view name, std::string_view otherwise) {
  reader.arguments.warning(*reader.arguments.find(name),
                           fmt::format("must be a colour here, no texture: {} is used", otherwise));
}

// Ashikhmin and Shirley's model: Ks is the reflectance straight on, and what it leaves is Kd's.
CookTorranceMaterial substrate(MaterialReader& reader) {
  CookTorranceMaterial material = glossy(reader, 0.5, 0.5);
  material.f0 = material.specular.factor;
  if (!material.specular.is_constant()) {
    warn_of_texture(reader, "Ks", "0.04");
    material.f0 = Vec3d(0.04);
  }
  const ColourInput left{Vec3d(1.0) - material.f0, {}, {}};
  material.diffuse =
      reader.textures.product(material.diffuse, left, reader.arguments.statement().place);
  material.specular = {Vec3d(1.0), {}, {}};
  material.fresnel = description::FresnelModel::Schlick;
  material.ior.reset();
  fit_specular(material, bright_texel * left.factor);
  return material;
}

description::ConductorMaterial metal(MaterialReader& reader) {
  description::ConductorMaterial metal;
  const auto [eta, k] = read_metal(reader, "");
  metal.eta = eta;
  metal.k = k;
  set_widths(reader, 0.01, metal);
  return metal;
}

description::DielectricMaterial glass(MaterialReader& reader) {
  description::DielectricMaterial glass;
  glass.ior = std::max(reader.scalar(reader.arguments.has("index") ? "index" : "eta", 1.5), 1.0);
  const ColourInput transmitted = reader.reflectance("Kt", 1);
  if (transmitted.is_constant())
    glass.transmittance = transmitted.factor;
  else
    warn_of_texture(reader, "Kt", "1");
  const ColourInput reflected = reader.reflectance("Kr", 1);
  if (!reflected.is_constant() || reflected.factor != Vec3d(1.0))
    reader.arguments.ignore("Kr", "glass reflects as Fresnel's equations say");
  set_widths(reader, 0, glass);
  return glass;
}

description::DiffuseTransmissionMaterial translucent(MaterialReader& reader) {
  const ColourInput kd = reader.reflectance("Kd", 0.25);
  const ColourInput reflected = reader.reflectance("reflect", 0.5);
  const ColourInput transmitted = reader.reflectance("transmit", 0.5);
  reader.arguments.accept({"roughness", "remaproughness"});
  const ColourInput specular = reader.reflectance("Ks", 0.25);
  if (!specular.is_constant() || specular.factor != Vec3d(0.0))
    reader.arguments.ignore("Ks", "translucent materials are diffuse here");
  const Place& place = reader.arguments.statement().place;
  return {reader.textures.product(kd, reflected, place),
          reader.textures.product(kd, transmitted, place)};
}

}  // namespace

bool set_v3_model(MaterialReader& reader, std::string_view type, Material& material) {
  if (type == "matte") {
    reader.arguments.ignore_unless("sigma", 0, "diffuse surfaces are Lambert's");
    material.model = description::DiffuseMaterial{reader.reflectance("Kd", 0.5)};
  } else if (type == "plastic") {
    material.model = plastic(reader);
  } else if (type == "uber") {
    material.model = uber(reader);
  } else if (type == "substrate") {
    material.model = substrate(reader);
  } else if (type == "metal") {
    material.model = metal(reader);
  } else if (type == "glass") {
    material.model = glass(reader);
  } else if (type == "mirror") {
    material.model = description::MirrorMaterial{reader.reflectance("Kr", 0.9)};
  } else if (type == "translucent") {
    material.model = translucent(reader);
  } else {
    return false;
  }
  reader.context.warn_once(
      "v3 " + std::string(type), reader.arguments.statement().place,
      fmt::format("{} is a material of pbrt-v3: the nearest model is used", text::quoted(type)));
  return true;
}

}  // namespace candela::pbrt
