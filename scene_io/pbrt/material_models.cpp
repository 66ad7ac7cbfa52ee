// The materials of pbrt-v4.
#include <algorithm>

#include <fmt/format.h>

#include "renderer/description/validate_material.h"
#include "scene_io/pbrt/materials.h"

namespace candela::pbrt {
namespace {

using description::Coat;
using description::CoatedConductorMaterial;
using description::CoatedDiffuseMaterial;
using description::ColourInput;
using description::ConductorMaterial;
using description::DielectricMaterial;
using description::DiffuseMaterial;
using description::DiffuseTransmissionMaterial;
using description::Material;

constexpr double usual_ior = 1.5;

double read_ior(MaterialReader& reader, std::string_view name, double otherwise = usual_ior,
                double least = 1) {
  const double ior = reader.scalar(name, otherwise);
  if (ior >= least) return ior;
  reader.arguments.warning(*reader.arguments.find(name),
                           fmt::format("is {}, below {}: 1 is used", ior, least));
  return 1;
}

template <class Rough>
void set_widths(MaterialReader& reader, std::string_view prefix, Rough& rough) {
  const Widths widths = read_widths(reader, prefix);
  rough.roughness = widths.along;
  rough.roughness_across = widths.across;
}

DiffuseMaterial diffuse(MaterialReader& reader) {
  reader.arguments.ignore_unless("sigma", 0, "diffuse surfaces are Lambert's");
  return {reader.reflectance("reflectance", 0.5)};
}

ConductorMaterial conductor(MaterialReader& reader) {
  ConductorMaterial metal;
  const Parameter* reflectance = reader.arguments.find("reflectance");
  if (reflectance && reflectance->type == ParameterType::Texture) {
    metal.reflectance = reader.reflectance("reflectance", 0.5);
    reader.arguments.accept({"eta", "k"});
  } else {
    const auto [eta, k] = read_metal(reader, "");
    metal.eta = eta;
    metal.k = k;
  }
  set_widths(reader, "", metal);
  return metal;
}

DielectricMaterial dielectric(MaterialReader& reader) {
  DielectricMaterial glass;
  glass.ior = read_ior(reader, "eta", usual_ior, description::least_ior);
  set_widths(reader, "", glass);
  return glass;
}

DielectricMaterial thin_dielectric(MaterialReader& reader) {
  DielectricMaterial glass;
  glass.ior = read_ior(reader, "eta");
  glass.is_thin = true;
  return glass;
}

// pbrt walks through the layers at random, up to `maxdepth` interfaces. What scatters between them
// is not there here.
Coat read_coat(MaterialReader& reader, std::string_view prefix, double ior = usual_ior) {
  Coat coat;
  set_widths(reader, prefix, coat);
  coat.ior = read_ior(reader, fmt::format("{}eta", prefix), ior);
  coat.thickness = reader.arguments.clamped("thickness", reader.scalar("thickness", 0.01), 0);
  const auto depth = static_cast<double>(reader.arguments.integer("maxdepth").value_or(10));
  coat.max_depth = static_cast<int>(reader.arguments.clamped("maxdepth", depth, 1, 1000));
  reader.arguments.accept({"nsamples", "g", "twosided"});
  const auto albedo = reader.textures.colour(reader.arguments, "albedo");
  if (albedo && (!albedo->is_constant() || albedo->factor != Vec3d(0.0)))
    reader.context.warn_once("albedo", reader.arguments.statement().place,
                             "coats scatter no light: \"albedo\" is ignored");
  return coat;
}

CoatedDiffuseMaterial coated_diffuse(MaterialReader& reader, double ior = usual_ior) {
  return {reader.reflectance("reflectance", 0.5), read_coat(reader, "", ior)};
}

CoatedConductorMaterial coated_conductor(MaterialReader& reader) {
  CoatedConductorMaterial metal;
  const auto [eta, k] = read_metal(reader, "conductor.");
  metal.eta = eta;
  metal.k = k;
  set_widths(reader, "conductor.", metal);
  metal.coat = read_coat(reader, "interface.");
  return metal;
}

// Where both are constant, no more light leaves than arrives; of textures the kernel sees to it.
DiffuseTransmissionMaterial diffuse_transmission(MaterialReader& reader) {
  const double scale = std::max(reader.arguments.number("scale").value_or(1), 0.0);
  ColourInput reflectance = reader.reflectance("reflectance", 0.25);
  ColourInput transmittance = reader.reflectance("transmittance", 0.25);
  const Place& place = reader.arguments.statement().place;
  for (ColourInput* part : {&reflectance, &transmittance}) {
    *part = reader.textures.product(*part, {Vec3d(scale), {}, {}}, place);
    if (part->is_constant()) part->factor = glm::min(part->factor, Vec3d(1.0));
  }
  const Vec3d sum = reflectance.factor + transmittance.factor;
  if (reflectance.is_constant() && transmittance.is_constant() && max_component(sum) > 1) {
    reader.context.warn_once("sheet", place,
                             "a sheet that reflects and lets through more light than it gets: "
                             "both are scaled down");
    reflectance.factor /= glm::max(sum, Vec3d(1.0));
    transmittance.factor /= glm::max(sum, Vec3d(1.0));
  }
  return {reflectance, transmittance};
}

// What stands in for materials that candela has not.
bool set_stand_in(MaterialReader& reader, std::string_view type, Material& material) {
  if (type != "subsurface" && type != "hair" && type != "measured") return false;
  reader.context.warn_once(
      "stand-in for " + std::string(type), reader.arguments.statement().place,
      fmt::format("materials of type {} are not supported: {} is used", text::quoted(type),
                  type == "subsurface" ? "a coated diffuse one" : "a diffuse one"));
  constexpr double ior_of_subsurface = 1.33;
  if (type == "subsurface")
    material.model = coated_diffuse(reader, ior_of_subsurface);
  else
    material.model = DiffuseMaterial{
        reader.reflectance(reader.arguments.has("reflectance") ? "reflectance" : "color", 0.5)};
  for (Parameter& parameter : reader.arguments.statement().parameters) parameter.is_used = true;
  return true;
}

}  // namespace

bool set_model(MaterialReader& reader, std::string_view type, Material& material) {
  if (type == "diffuse")
    material.model = diffuse(reader);
  else if (type == "coateddiffuse")
    material.model = coated_diffuse(reader);
  else if (type == "conductor")
    material.model = conductor(reader);
  else if (type == "coatedconductor")
    material.model = coated_conductor(reader);
  else if (type == "dielectric")
    material.model = dielectric(reader);
  else if (type == "thindielectric")
    material.model = thin_dielectric(reader);
  else if (type == "diffusetransmission")
    material.model = diffuse_transmission(reader);
  else if (type == "interface" || type.empty() || type == "none")
    material.model = description::InterfaceMaterial{};
  else
    return set_stand_in(reader, type, material);
  return true;
}

}  // namespace candela::pbrt
