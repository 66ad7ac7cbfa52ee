#include "scene_io/lab3/typed_material.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "renderer/math/reflectance.h"
#include "scene_io/image_encoding.h"
#include "scene_io/lab3/assets.h"
#include "scene_io/lab3/metals.h"

namespace candela::lab3 {
namespace {

using description::ColourInput;
using description::Encoding;
using description::FresnelModel;
using description::GeometryModel;
using description::ScalarInput;

// 0 is a mirror, which a cook_torrance cannot be: its highlight would be a delta.
constexpr Range above_zero_to_one{0, 1, true, false, "a number above 0, at most 1"};
constexpr Range below_one{0, 1, false, true, "a number of at least 0, below 1"};
constexpr Range refractive_index{1, 1000, false, false, "a refractive index from 1 to 1000"};
constexpr Range complex_index{0, 1000, false, false, "a number from 0 to 1000"};

ColourInput read_colour_input(Reader& reader, const Fields& fields, Names factors, Names maps,
                              const Vec3d& otherwise) {
  const Entry* factor = fields.last_of(factors);
  const Entry* map = fields.last_of(maps);
  ColourInput input{fields.colour(factor, zero_to_one).value_or(otherwise), {}};
  const Encoding encoding = map ? encoding_of_colours(map->value->text) : Encoding::Linear;
  input.map = read_image_over(reader, factor, map, encoding);
  return input;
}

ScalarInput read_roughness(Reader& reader, const Fields& fields, const Range& range,
                           double otherwise) {
  ScalarInput input{fields.number("roughness", range).value_or(otherwise), {}, 0};
  input.map = read_image_over(reader, fields.find("roughness"), fields.find("roughness_map"),
                              Encoding::Linear);
  return input;
}

std::optional<Metal> read_metal(const Fields& fields) {
  std::vector<std::string_view> names;
  for (const Metal& metal : metals()) names.push_back(metal.name);
  const auto index = fields.choice("metal", names);
  if (!index) return std::nullopt;
  return metals()[*index];
}

// eta and k: both, or a metal that has them.
std::optional<std::array<Vec3d, 2>> read_eta_k(Reader& reader, const Fields& fields) {
  if (fields.has("eta") != fields.has("k")) {
    reader.error(fields.find(fields.has("eta") ? "eta" : "k")->key_offset,
                 "eta and k belong together: the other one is missing");
    return std::nullopt;
  }
  if (const auto metal = read_metal(fields)) return std::array{metal->eta, metal->k};
  const auto eta = fields.colour("eta", complex_index);
  const auto k = fields.colour("k", complex_index);
  if (!eta || !k) return std::nullopt;
  return std::array{*eta, *k};
}

// The material's reflectance is said once, in one of these ways, whose first keys are `sources`.
void check_single_source(Reader& reader, const Fields& fields,
                         std::initializer_list<std::string_view> sources, std::string_view ways) {
  const Entry* first = nullptr;
  for (const std::string_view source : sources) {
    const Entry* entry = fields.find(source);
    if (!entry) continue;
    if (first)
      reader.error(entry->key_offset, fmt::format("both {} and {} are given, expected one of {}",
                                                  first->key, entry->key, ways));
    first = first ? first : entry;
  }
}

void read_fresnel(Reader& reader, const Fields& fields,
                  description::CookTorranceMaterial& material) {
  static constexpr std::string_view fresnels[] = {"schlick", "exact"};
  static constexpr std::string_view geometries[] = {"schlick_ggx", "smith"};
  check_single_source(reader, fields, {"F0", "ior", "eta", "metal"}, "F0, ior, eta and k, metal");
  material.fresnel = static_cast<FresnelModel>(fields.choice("fresnel", fresnels).value_or(0));
  const auto geometry = fields.choice("geometry", geometries);
  material.geometry = static_cast<GeometryModel>(geometry.value_or(0));
  material.energy_compensation = fields.flag("energy_compensation", false);
  const bool is_refused = fields.has("geometry") && !geometry;
  if (material.energy_compensation && !is_refused && material.geometry != GeometryModel::Smith)
    reader.error(
        fields.find("energy_compensation")->key_offset,
        "energy_compensation puts back what geometry: smith loses; expected that geometry");
  material.f0 = fields.colour("F0", zero_to_one).value_or(material.f0);
  material.ior = fields.number("ior", refractive_index);
  if (material.ior) material.f0 = normal_reflectance(Vec3d(*material.ior), Vec3d(0.0));
  material.eta_k = read_eta_k(reader, fields);
  if (material.eta_k) material.f0 = normal_reflectance((*material.eta_k)[0], (*material.eta_k)[1]);
  const bool has_indices =
      fields.has("ior") || fields.has("eta") || fields.has("k") || fields.has("metal");
  if (material.fresnel == FresnelModel::Exact && !has_indices)
    reader.error(fields.find("fresnel")->key_offset,
                 "fresnel: exact needs ior, eta and k, or metal");
}

// Sufficient for an albedo of at most 1 [REPORT section 2.2].
void limit_sum(Reader& reader, const Fields& fields, description::CookTorranceMaterial& material) {
  Vec3d& kd = material.diffuse.factor;
  Vec3d& ks = material.specular.factor;
  if (material.diffuse.map || material.specular.map) return;
  const double most = max_component(kd + ks);
  if (most <= 1 + 1e-9) return;
  reader.warning(fields.offset(), fmt::format("kd + ks reaches {:.4g} in a channel, more than 1: "
                                              "both are scaled down there",
                                              most));
  for (int c = 0; c < 3; ++c) {
    const double sum = std::max(kd[c] + ks[c], 1.0);
    kd[c] /= sum;
    ks[c] /= sum;
  }
}

description::CookTorranceMaterial read_cook_torrance(Reader& reader, const Fields& fields) {
  const std::size_t errors_before = reader.diagnostics.error_count();
  description::CookTorranceMaterial material;
  material.diffuse =
      read_colour_input(reader, fields, kd_names, kd_map_names, material.diffuse.factor);
  material.specular =
      read_colour_input(reader, fields, ks_names, ks_map_names, material.specular.factor);
  const bool has_both = reader.diagnostics.error_count() == errors_before;
  material.roughness = read_roughness(reader, fields, above_zero_to_one, material.roughness.factor);
  read_fresnel(reader, fields, material);
  if (has_both) limit_sum(reader, fields, material);
  return material;
}

description::ConductorMaterial read_conductor(Reader& reader, const Fields& fields) {
  description::ConductorMaterial material;
  const Metal copper = metal_named("copper");
  material.eta = copper.eta;
  material.k = copper.k;
  check_single_source(reader, fields, {"F0", "eta", "metal"}, "F0, eta and k, metal");
  if (const auto eta_k = read_eta_k(reader, fields)) {
    material.eta = (*eta_k)[0];
    material.k = (*eta_k)[1];
  }
  if (const auto f0 = fields.colour("F0", below_one)) {
    material.eta = Vec3d(1.0);
    material.k = extinction_of_reflectance(*f0);
  }
  material.roughness = read_roughness(reader, fields, zero_to_one, 0);
  material.energy_compensation = fields.flag("energy_compensation", false);
  return material;
}

description::DielectricMaterial read_dielectric(Reader& reader, const Fields& fields,
                                                bool is_thin) {
  description::DielectricMaterial material;
  material.ior = fields.number("ior", refractive_index).value_or(material.ior);
  material.transmittance =
      fields.colour("transmittance", zero_to_one).value_or(material.transmittance);
  material.is_thin = is_thin;
  if (!is_thin) material.roughness = read_roughness(reader, fields, zero_to_one, 0);
  return material;
}

}  // namespace

decltype(description::Material::model) read_typed_material(Reader& reader, const Fields& fields,
                                                           MaterialType type) {
  const auto reflectance = [&](const Vec3d& otherwise) {
    return read_colour_input(reader, fields, reflectance_names, reflectance_map_names, otherwise);
  };
  switch (type) {
    case MaterialType::CookTorrance:
      return read_cook_torrance(reader, fields);
    case MaterialType::Diffuse:
      return description::DiffuseMaterial{reflectance(Vec3d(0.5))};
    case MaterialType::Mirror:
      return description::MirrorMaterial{reflectance(Vec3d(1.0))};
    case MaterialType::Conductor:
      return read_conductor(reader, fields);
    case MaterialType::Dielectric:
      return read_dielectric(reader, fields, false);
    case MaterialType::ThinDielectric:
      return read_dielectric(reader, fields, true);
    case MaterialType::Lab:
      break;
  }
  return description::DiffuseMaterial{};
}

}  // namespace candela::lab3
