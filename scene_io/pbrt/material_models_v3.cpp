// The materials of pbrt-v3 under their old names, by the nearest model that candela has.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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

ScalarInput read_width(MaterialReader& reader, double otherwise) {
  ScalarInput input = reader.textures.scalar(reader.arguments, "roughness")
                          .value_or(ScalarInput{otherwise, {}, 0, {}});
  const auto u = reader.textures.scalar(reader.arguments, "uroughness");
  if (u) input = *u;
  reader.arguments.accept({"vroughness"});
  const bool remaps = reader.arguments.flag("remaproughness", true);
  if (input.map || input.texture) return input;
  // Glass and mirrors that are smooth say 0.
  if (input.factor <= 0) return ScalarInput{0.0, {}, 0, {}};
  input.factor = remaps ? width_of(input.factor) : std::min(input.factor, 1.0);
  return input;
}

// A diffuse surface and microfacets on it, their sum as it is in pbrt-v3.
CookTorranceMaterial glossy(MaterialReader& reader, double diffuse, double specular,
                            double roughness) {
  CookTorranceMaterial material;
  material.diffuse = reader.reflectance("Kd", diffuse);
  material.specular = reader.reflectance("Ks", specular);
  material.roughness = read_width(reader, roughness);
  if (material.roughness.factor <= 0 && !material.roughness.map && !material.roughness.texture)
    material.roughness.factor = 1e-3;
  material.geometry = description::GeometryModel::Smith;
  material.fresnel = description::FresnelModel::Exact;
  material.ior = 1.5;
  return material;
}

CookTorranceMaterial uber(MaterialReader& reader) {
  CookTorranceMaterial material = glossy(reader, 0.25, 0.25, 0.1);
  const double ior =
      std::max(reader.scalar(reader.arguments.has("eta") ? "eta" : "index", 1.5), 1.0);
  material.ior = ior;
  for (const std::string_view name : {"Kr", "Kt", "opacity"})
    reader.arguments.ignore(name, "an uber material is diffuse and glossy here");
  return material;
}

// Ashikhmin and Shirley's model: Ks is the reflectance at normal incidence.
CookTorranceMaterial substrate(MaterialReader& reader) {
  CookTorranceMaterial material = glossy(reader, 0.5, 0.5, 0.1);
  const ColourInput& specular = material.specular;
  material.f0 = specular.map || specular.texture ? Vec3d(0.04) : specular.factor;
  material.specular = {Vec3d(1.0), {}, {}};
  if (!material.diffuse.map && !material.diffuse.texture)
    material.diffuse.factor *= Vec3d(1.0) - material.f0;
  material.fresnel = description::FresnelModel::Schlick;
  material.ior.reset();
  return material;
}

description::ConductorMaterial metal(MaterialReader& reader) {
  description::ConductorMaterial metal;
  const auto [eta, k] = read_metal(reader, "");
  metal.eta = eta;
  metal.k = k;
  metal.roughness = read_width(reader, 0.01);
  return metal;
}

description::DielectricMaterial glass(MaterialReader& reader) {
  description::DielectricMaterial glass;
  glass.ior = std::max(reader.scalar(reader.arguments.has("index") ? "index" : "eta", 1.5), 1.0);
  const ColourInput transmitted = reader.reflectance("Kt", 1);
  if (!transmitted.map && !transmitted.texture) glass.transmittance = transmitted.factor;
  reader.arguments.accept({"Kr"});
  glass.roughness = read_width(reader, 0);
  return glass;
}

description::DiffuseTransmissionMaterial translucent(MaterialReader& reader) {
  const ColourInput kd = reader.reflectance("Kd", 0.25);
  const ColourInput reflected = reader.reflectance("reflect", 0.5);
  const ColourInput transmitted = reader.reflectance("transmit", 0.5);
  reader.arguments.accept({"Ks", "roughness", "remaproughness"});
  const auto times = [&](const ColourInput& part) {
    ColourInput product = kd;
    product.factor *= part.factor;
    return product;
  };
  return {times(reflected), times(transmitted)};
}

}  // namespace

bool set_v3_model(MaterialReader& reader, std::string_view type, Material& material) {
  if (type == "matte") {
    reader.arguments.ignore_unless("sigma", 0, "diffuse surfaces are Lambert's");
    material.model = description::DiffuseMaterial{reader.reflectance("Kd", 0.5)};
  } else if (type == "plastic") {
    material.model = glossy(reader, 0.25, 0.25, 0.1);
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
