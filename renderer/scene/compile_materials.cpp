#include "renderer/scene/compile_materials.h"

#include <algorithm>
#include <cmath>

#include "renderer/bsdf/coat_table.h"
#include "renderer/bsdf/coated_metal_table.h"
#include "renderer/bsdf/energy_loss.h"
#include "renderer/material/bsdf_at.h"
#include "renderer/math/reflectance.h"
#include "renderer/scene/image_luminance.h"

namespace candela {
namespace {

using description::ColourInput;
using description::ScalarInput;

// What textures say is clamped where it is looked up (bsdf_at.h), and here where they say the same
// everywhere.
ColourParameter colour(const ColourInput& input, TextureCompiler& texture) {
  const TextureValue value = texture.input(input);
  const Rgb constant(value.constant);
  return {input.texture ? clamp_unit(constant) : constant, value.texture};
}

ScalarParameter scalar(const ScalarInput& input, TextureCompiler& texture) {
  if (input.texture) {
    const TextureValue value = texture.texture(input.texture);
    const int channel = std::max(0, input.channel);
    return {clamp_unit(value.constant[channel]), value.texture, channel};
  }
  if (input.channel == description::alpha_or_mean && input.map) {
    const TextureCompiler::Scalar found = texture.scalar(input.map);
    return {static_cast<float>(input.factor), found.texture, found.channel};
  }
  const TextureHandle map = texture.image(input.map);
  int channel = input.channel;
  if (channel == description::alpha_or_first)
    channel = map && texture.store().info(map).has_alpha ? 3 : 0;
  return {static_cast<float>(input.factor), map, channel};
}

// The lab keeps factors in 8 bits.
double quantised(double v) {
  return std::round(std::clamp(v, 0.0, 1.0) * 255) / 255;
}

double lab_decoded(double v) {
  return std::pow(std::max(v, 0.0), 2.2);
}

bool has_map_or_colour(const ColourParameter& parameter) {
  return parameter.texture.is_valid() || !is_black(parameter.constant);
}

// Alpha is the diffuse map's where there is one, else `d`.
void set_lab_opacity(const description::LabMaterial& lab, const TextureStore& textures,
                     Material& out) {
  out.lab_opacity = true;
  out.opacity = {static_cast<float>(lab.alpha), {}, 3};
  if (!out.diffuse.texture) return;
  out.opacity.constant = 1;
  if (textures.info(out.diffuse.texture).has_alpha) out.opacity.texture = out.diffuse.texture;
}

// k of a metal with n = 1 by its reflectance at normal incidence.
Vec3d extinction_of(const Vec3d& reflectance) {
  const Vec3d largest(largest_metal_reflectance);
  return extinction_of_reflectance(glm::min(reflectance, largest));
}

struct ModelCompiler {
  const CompileOptions& options;
  TextureCompiler& texture;
  CoatTables& coats;
  Material& out;

  void operator()(const description::LabMaterial& lab) const {
    description::LabMaterial m = lab;
    if (options.lab_quantised) {
      for (int c = 0; c < 3; ++c) {
        m.diffuse.factor[c] = quantised(m.diffuse.factor[c]);
        m.specular.factor[c] = quantised(m.specular.factor[c]);
      }
      m.alpha = quantised(m.alpha);
      m.shininess = 256 * quantised(m.shininess / 256);
    }
    for (int c = 0; c < 3; ++c) m.diffuse.factor[c] = lab_decoded(m.diffuse.factor[c]);
    out.model = MaterialModel::Lab;
    out.diffuse = colour(m.diffuse, texture);
    out.specular = colour(m.specular, texture);
    out.roughness.constant = static_cast<float>(width_of_exponent(m.shininess));
    out.shininess = static_cast<float>(m.shininess);
    set_lab_opacity(m, texture.store(), out);
    // ks = 0 asks for no highlight, though Schlick's term would still have one at grazing angles.
    if (!has_map_or_colour(out.specular)) out.model = MaterialModel::Diffuse;
  }

  void operator()(const description::CookTorranceMaterial& m) const {
    out.model = MaterialModel::CookTorrance;
    out.diffuse = colour(m.diffuse, texture);
    out.specular = colour(m.specular, texture);
    out.roughness = scalar(m.roughness, texture);
    out.fresnel = m.fresnel;
    out.geometry = m.geometry;
    out.energy_compensation = m.energy_compensation;
    out.f0 = Rgb(m.f0);
    if (m.ior) {
      out.eta = Rgb(static_cast<float>(*m.ior));
      out.f0 = Rgb(normal_reflectance(Vec3d(*m.ior), Vec3d(0.0)));
    }
    if (m.eta_k) set_conductor((*m.eta_k)[0], (*m.eta_k)[1]);
    if (!has_map_or_colour(out.specular)) out.model = MaterialModel::Diffuse;
  }

  void operator()(const description::DiffuseMaterial& m) const {
    out.model = MaterialModel::Diffuse;
    out.diffuse = colour(m.reflectance, texture);
  }

  void operator()(const description::MirrorMaterial& m) const {
    out.model = MaterialModel::Mirror;
    out.diffuse = colour(m.reflectance, texture);
  }

  void operator()(const description::ConductorMaterial& m) const {
    out.model = MaterialModel::Conductor;
    set_widths(m.roughness, m.roughness_across);
    out.energy_compensation = m.energy_compensation;
    set_conductor(m.eta, m.k);
    if (!m.reflectance) return;
    out.specular = colour(*m.reflectance, texture);
    if (out.specular.texture) return;
    const Vec3d reflectance =
        m.reflectance->texture ? Vec3d(out.specular.constant) : m.reflectance->factor;
    set_conductor(Vec3d(1.0), extinction_of(reflectance));
  }

  void operator()(const description::DielectricMaterial& m) const {
    out.model = m.is_thin ? MaterialModel::ThinDielectric : MaterialModel::Dielectric;
    set_widths(m.roughness, m.roughness_across);
    out.eta = Rgb(static_cast<float>(m.ior));
    out.transmittance = Rgb(m.transmittance);
  }

  void operator()(const description::CoatedDiffuseMaterial& m) const {
    out.model = MaterialModel::CoatedDiffuse;
    out.diffuse = colour(m.reflectance, texture);
    set_coat(m.coat);
  }
  void operator()(const description::CoatedConductorMaterial& m) const {
    out.model = MaterialModel::CoatedConductor;
    set_conductor(m.eta / m.coat.ior, m.k / m.coat.ior);
    out.metal_roughness = scalar(m.roughness, texture);
    out.metal_roughness_across =
        m.roughness_across ? scalar(*m.roughness_across, texture) : out.metal_roughness;
    set_coat(m.coat);
    out.follows_tangents |= are_apart(out.metal_roughness, out.metal_roughness_across);
    set_metal_table();
  }
  void operator()(const description::DiffuseTransmissionMaterial& m) const {
    out.model = MaterialModel::DiffuseTransmission;
    out.diffuse = colour(m.reflectance, texture);
    out.specular = colour(m.transmittance, texture);
  }
  void operator()(const description::InterfaceMaterial&) const {
    // So that compile_geometry() leaves its triangles out, if compile_media() does not need them.
    out.opacity.constant = 0;
  }
  void operator()(const description::MixMaterial& m) const {
    out.model = MaterialModel::Mix;
    out.parts = {MaterialHandle(m.first.index), MaterialHandle(m.second.index)};
    out.amount = scalar(m.amount, texture);
  }

 private:
  void set_widths(const ScalarInput& along, const std::optional<ScalarInput>& across) const {
    out.roughness = scalar(along, texture);
    if (!across) return;
    out.roughness_across = scalar(*across, texture);
    out.is_anisotropic = out.follows_tangents = are_apart(out.roughness, out.roughness_across);
  }
  static bool are_apart(const ScalarParameter& a, const ScalarParameter& b) {
    return a.texture != b.texture || a.channel != b.channel ||
           (!a.texture && a.constant != b.constant);
  }
  // Of mean widths; where textures vary them there is none, and the lobe's albedo is not that of
  // followed light (docs/pbrt.md).
  void set_metal_table() const {
    const ScalarParameter* const widths[] = {&out.roughness, &out.roughness_across,
                                             &out.metal_roughness, &out.metal_roughness_across};
    for (const ScalarParameter* const width : widths)
      if (width->texture) return;
    Bsdf bsdf = bsdf_at(out, texture.store(), {}, true);
    if (bsdf.is_smooth) return;
    const auto mean = [](float a, float b) { return std::sqrt(a * b); };
    const CoatedMetalLayers layers{
        mean(bsdf.alpha, bsdf.alpha_across),
        mean(out.metal_roughness.constant, out.metal_roughness_across.constant)};
    bsdf.alpha = bsdf.alpha_across = layers.coat_alpha;
    bsdf.metal_widths = Vec2f(mean(bsdf.metal_widths.x, bsdf.metal_widths.y));
    out.metal = coats.metal(bsdf, layers);
  }
  void set_coat(const description::Coat& coat) const {
    // What neither reflects nor bends light does not blur it.
    if (coat.ior != 1) set_widths(coat.roughness, coat.roughness_across);
    out.coat_bounces = (coat.max_depth + 1) / 2;
    const bool varies =
        out.roughness.texture || (out.is_anisotropic && out.roughness_across.texture);
    const float across =
        out.is_anisotropic ? out.roughness_across.constant : out.roughness.constant;
    const float alpha = varies ? -1 : std::sqrt(out.roughness.constant * across);
    out.coat = coats.table(static_cast<float>(coat.ior), static_cast<float>(coat.thickness), alpha);
  }
  void set_conductor(const Vec3d& eta, const Vec3d& k) const {
    constexpr double largest = 1e6;  // there nothing is left to reflect, and squares are numbers
    const Vec3d n = glm::min(eta, Vec3d(largest));
    const Vec3d extinction = glm::min(k, Vec3d(largest));
    out.fresnel_is_conductor = true;
    out.eta = Rgb(n);
    out.k = Rgb(extinction);
    out.f0 = Rgb(normal_reflectance(n, extinction));
  }
};

// The same by a map; times the map's mean where the emission is to be that.
void set_emission(const description::Material& material, TextureCompiler& texture, Material& out) {
  out.emission = Rgb(material.emission);
  out.emits_both_sides = material.emits_both_sides;
  if (is_black(out.emission)) return;
  out.emission_map = texture.light_image(material.emission_map);
  if (!out.emission_map || !material.emission_is_maps_mean) return;
  const double mean = mean_luminance(texture.store(), out.emission_map);
  out.emission = mean > 0 ? Rgb(material.emission / mean) : Rgb(0);
}

bool has_texture(const Material& m) {
  return m.diffuse.texture || m.specular.texture || m.roughness.texture ||
         m.roughness_across.texture || m.metal_roughness.texture ||
         m.metal_roughness_across.texture || m.follows_tangents || m.height || m.normal_map ||
         m.amount.texture || m.emission_map;
}

}  // namespace

std::shared_ptr<const CoatTable> CoatTables::table(float eta, float thickness, float alpha) {
  std::shared_ptr<const CoatTable>& table = tables_[{eta, thickness, alpha}];
  if (!table) table = std::make_shared<const CoatTable>(eta, thickness, alpha);
  return table;
}

std::shared_ptr<const CoatedMetalTable> CoatTables::metal(const Bsdf& bsdf,
                                                          const CoatedMetalLayers& layers) {
  const Rgb& n = bsdf.eta;
  const Rgb& k = bsdf.k;
  const MetalKey key{
      bsdf.coat,
      bsdf.metal_bounces,
      {n.x, n.y, n.z, k.x, k.y, k.z, layers.coat_alpha, layers.metal_alpha, bsdf.metal_widths.x}};
  std::shared_ptr<const CoatedMetalTable>& table = metals_[key];
  if (!table) table = std::make_shared<const CoatedMetalTable>(bsdf, layers);
  return table;
}

Material compile_material(const description::Material& material, const CompileOptions& options,
                          double unit, TextureCompiler& texture, CoatTables& coats) {
  Material out;
  std::visit(ModelCompiler{options, texture, coats, out}, material.model);
  if (std::holds_alternative<description::InterfaceMaterial>(material.model)) return out;
  if (out.energy_compensation) static_cast<void>(energy_loss_table());  // now, not while rendering
  set_emission(material, texture, out);
  if (!material.opacity.is_constant() || material.opacity.factor != 1) {
    out.opacity = scalar(material.opacity, texture);
    out.lab_opacity = false;
  }
  out.height = material.height_texture ? texture.texture(material.height_texture).texture
                                       : texture.image(material.height);
  out.heights_are_lengths = material.heights_are_lengths;
  out.height_scale =
      static_cast<float>(material.height_scale * (material.heights_are_lengths ? unit : 1));
  out.normal_map = texture.image(material.normal_map);
  out.normal_map_is_right_handed = material.normal_map_is_right_handed;
  out.reads_uv = has_texture(out);
  out.reads_tangents = out.follows_tangents || out.height || out.normal_map;
  return out;
}

void add_features(const Material& material, SceneFeatures& features) {
  features.bsdf_models |= bsdf_models(material);
  features.bump |= material.height.is_valid() || material.normal_map.is_valid();
  features.mixes |= material.model == MaterialModel::Mix;
}

}  // namespace candela
