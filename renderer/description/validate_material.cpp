#include "renderer/description/validate_material.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/description/validate.h"

namespace candela::description {
namespace {

// Says everything about one material.
class Check {
 public:
  Check(const SceneDescription& scene, const Material& material, Diagnostics& diagnostics)
      : scene_(scene), material_(material), diagnostics_(diagnostics) {}

  void number(double x, double low, double high, std::string_view what) const {
    if (x >= low && x <= high) return;
    diagnostics_.error(material_.span, fmt::format("material '{}': {} is {}, expected {} to {}",
                                                   material_.name, what, x, low, high));
  }
  void at_least(double x, double low, std::string_view what) const {
    if (x >= low && std::isfinite(x)) return;
    diagnostics_.error(material_.span, fmt::format("material '{}': {} is {}, expected at least {}",
                                                   material_.name, what, x, low));
  }
  void colour(const Vec3d& c, std::string_view what) const {
    for (int i = 0; i < 3; ++i) number(c[i], 0, 1, what);
  }
  void positive_colour(const Vec3d& c, std::string_view what) const {
    for (int i = 0; i < 3; ++i) at_least(c[i], 0, what);
  }
  void image(ImageHandle handle, std::string_view what) const {
    if (!handle || handle.index < scene_.images.size()) return;
    diagnostics_.error(material_.span, fmt::format("material '{}': the map of {} does not exist",
                                                   material_.name, what));
  }
  void texture(TextureHandle handle, std::string_view what) const {
    if (!handle || handle.index < scene_.textures.size()) return;
    diagnostics_.error(
        material_.span,
        fmt::format("material '{}': the texture of {} does not exist", material_.name, what));
  }
  template <class Input>
  void one_of(const Input& given, std::string_view what) const {
    if (given.map && given.texture)
      diagnostics_.error(material_.span, fmt::format("material '{}': {} has a map and a texture",
                                                     material_.name, what));
  }
  void input(const ColourInput& colour_input, std::string_view what) const {
    colour(colour_input.factor, what);
    image(colour_input.map, what);
    texture(colour_input.texture, what);
    one_of(colour_input, what);
  }
  void input(const ScalarInput& scalar, std::string_view what) const {
    number(scalar.factor, 0, 1, what);
    image(scalar.map, what);
    texture(scalar.texture, what);
    one_of(scalar, what);
    if (scalar.channel < alpha_or_mean || scalar.channel > 3)
      diagnostics_.error(material_.span,
                         fmt::format("material '{}': the map of {} has no channel {}",
                                     material_.name, what, scalar.channel));
  }
  void widths(const ScalarInput& along, const std::optional<ScalarInput>& across,
              std::string_view what) const {
    input(along, what);
    if (across) input(*across, what);
  }
  void coat(const Coat& layer) const {
    number(layer.ior, 1, largest_ior, "the refractive index of the coat");
    widths(layer.roughness, layer.roughness_across, "the roughness of the coat");
    at_least(layer.thickness, 0, "the thickness of the coat");
    number(layer.max_depth, 0, deepest_coat, "the depth of the coat");
  }
  void warn(std::string message) const {
    diagnostics_.warning(material_.span, fmt::format("material '{}': {}", material_.name, message));
  }

  void operator()(const LabMaterial& lab) const {
    input(lab.diffuse, "the diffuse colour");
    input(lab.specular, "the specular colour");
    number(lab.alpha, 0, 1, "alpha");
    at_least(lab.shininess, 0, "the shininess");
  }
  void operator()(const CookTorranceMaterial& rough) const {
    input(rough.diffuse, "kd");
    input(rough.specular, "ks");
    input(rough.roughness, "the roughness");
    colour(rough.f0, "F0");
    if (rough.ior) number(*rough.ior, 1, largest_ior, "the refractive index");
    if (rough.eta_k) positive_colour((*rough.eta_k)[0], "eta");
    if (rough.eta_k) positive_colour((*rough.eta_k)[1], "k");
    if (rough.fresnel == FresnelModel::Exact && !rough.ior && !rough.eta_k)
      diagnostics_.error(material_.span,
                         fmt::format("material '{}': the exact Fresnel term needs a refractive "
                                     "index",
                                     material_.name));
    if (rough.energy_compensation && rough.geometry != GeometryModel::Smith)
      diagnostics_.error(
          material_.span,
          fmt::format("material '{}': energy compensation needs Smith's geometry", material_.name));
    const bool is_constant = rough.diffuse.is_constant() && rough.specular.is_constant();
    const double most = max_component(rough.diffuse.factor + rough.specular.factor);
    if (is_constant && most > 1 + 1e-9)  // sums of decimal fractions miss 1 by some 1e-16
      warn(fmt::format(
          "kd + ks reaches {:.4g} in a channel, more than 1: both are scaled down there", most));
  }
  void operator()(const DiffuseMaterial& diffuse) const {
    input(diffuse.reflectance, "the reflectance");
  }
  void operator()(const MirrorMaterial& mirror) const {
    input(mirror.reflectance, "the reflectance");
  }
  void operator()(const ConductorMaterial& conductor) const {
    positive_colour(conductor.eta, "eta");
    positive_colour(conductor.k, "k");
    if (conductor.reflectance) input(*conductor.reflectance, "the reflectance");
    if (conductor.reflectance && conductor.energy_compensation)
      diagnostics_.error(material_.span,
                         fmt::format("material '{}': energy compensation needs eta and k, not a "
                                     "reflectance",
                                     material_.name));
    if (conductor.roughness_across && conductor.energy_compensation)
      diagnostics_.error(material_.span,
                         fmt::format("material '{}': energy compensation needs one roughness, not "
                                     "another across",
                                     material_.name));
    widths(conductor.roughness, conductor.roughness_across, "the roughness");
  }
  void operator()(const DielectricMaterial& glass) const {
    number(glass.ior, glass.is_thin ? 1 : least_ior, largest_ior, "the refractive index");
    widths(glass.roughness, glass.roughness_across, "the roughness");
    colour(glass.transmittance, "the transmittance");
  }
  void operator()(const CoatedDiffuseMaterial& coated) const {
    input(coated.reflectance, "the reflectance");
    coat(coated.coat);
  }
  void operator()(const CoatedConductorMaterial& coated) const {
    positive_colour(coated.eta, "eta");
    positive_colour(coated.k, "k");
    widths(coated.roughness, coated.roughness_across, "the roughness");
    coat(coated.coat);
  }
  void operator()(const DiffuseTransmissionMaterial& leaf) const {
    input(leaf.reflectance, "the reflectance");
    input(leaf.transmittance, "the transmittance");
    const double most = max_component(leaf.reflectance.factor + leaf.transmittance.factor);
    const bool is_constant = leaf.reflectance.is_constant() && leaf.transmittance.is_constant();
    if (is_constant && most > 1 + 1e-9)
      warn(
          fmt::format("reflectance + transmittance reaches {:.4g} in a channel, more than 1; both "
                      "are made smaller",
                      most));
  }
  void operator()(const InterfaceMaterial&) const {
    if (material_.emission != Vec3d(0.0)) warn("an interface does not shine: nothing is there");
  }
  void operator()(const MixMaterial& mix) const {
    part(mix.first);
    part(mix.second);
    input(mix.amount, "the amount");
  }

 private:
  // One of a mixture. Those of a mixture stand before it, so that none is made of itself.
  void part(MaterialHandle handle) const {
    const auto index = static_cast<std::size_t>(&material_ - scene_.materials.data());
    if (handle.index >= index)
      diagnostics_.error(material_.span,
                         fmt::format("material '{}': a material that it mixes does not stand "
                                     "before it",
                                     material_.name));
    else if (std::holds_alternative<InterfaceMaterial>(scene_.materials[handle.index].model))
      diagnostics_.error(
          material_.span,
          fmt::format("material '{}' mixes an interface, expected an opacity", material_.name));
  }

  const SceneDescription& scene_;
  const Material& material_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_material(const SceneDescription& scene, const Material& material,
                    Diagnostics& diagnostics) {
  const Check check(scene, material, diagnostics);
  std::visit(check, material.model);
  check.positive_colour(material.emission, "the emission");
  if (max_component(material.emission) > largest_radiance && is_finite(material.emission))
    diagnostics.error(
        material.span,
        fmt::format("material '{}': the emission is {}, expected at most {:g}", material.name,
                    max_component(material.emission), largest_radiance));
  check.image(material.emission_map, "the emission");
  check.input(material.opacity, "the opacity");
  check.image(material.height, "heights");
  check.texture(material.height_texture, "heights");
  if (material.height && material.height_texture)
    diagnostics.error(material.span, fmt::format("material '{}': heights have a map and a texture",
                                                 material.name));
  check.image(material.normal_map, "normals");
  if (!std::isfinite(material.height_scale))
    diagnostics.error(material.span, fmt::format("material '{}': the scale of its heights is not "
                                                 "finite",
                                                 material.name));
}

// Parts stand before their mixtures, or check_material() refuses them.
void check_mixtures(const SceneDescription& scene, Diagnostics& diagnostics) {
  std::vector<int> depths(scene.materials.size(), 0);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const auto* const mix = std::get_if<MixMaterial>(&scene.materials[i].model);
    if (!mix) continue;
    for (const MaterialHandle part : {mix->first, mix->second})
      if (part.index < i) depths[i] = std::max(depths[i], depths[part.index] + 1);
    if (depths[i] <= deepest_mixture) continue;
    diagnostics.error(scene.materials[i].span,
                      fmt::format("material '{}': mixtures of mixtures more than {} deep",
                                  scene.materials[i].name, deepest_mixture));
    depths[i] = 0;  // told once
  }
}

}  // namespace candela::description
