#include "scene_io/pbrt/own_materials.h"

#include <limits>

#include <fmt/format.h>

#include "scene_io/pbrt/own_names.h"
#include "scene_io/pbrt/spectrum.h"

namespace candela::pbrt {
namespace {

using description::CookTorranceMaterial;
using description::LabMaterial;
using description::Material;

class OwnModelReader {
 public:
  explicit OwnModelReader(MaterialReader& reader) : reader_(reader) {}

  LabMaterial lab(Material& material) {
    LabMaterial lab;
    lab.diffuse = reader_.reflectance("lab.diffuse", 1);
    lab.specular = reader_.reflectance("lab.specular", 0);
    lab.alpha = number("lab.alpha", 0, 1).value_or(1);
    lab.shininess = number("lab.shininess", 0, largest).value_or(0);
    if (const auto opacity = share("lab.opacity")) material.opacity = *opacity;
    return lab;
  }

  description::MirrorMaterial mirror() { return {reader_.reflectance("mirror.reflectance", 1)}; }

  CookTorranceMaterial cook_torrance() {
    CookTorranceMaterial m;
    m.diffuse = reader_.reflectance("cooktorrance.diffuse", 0.5);
    m.specular = reader_.reflectance("cooktorrance.specular", 0.5);
    if (const auto width = share("cooktorrance.roughness")) m.roughness = *width;
    m.f0 = glm::min(colour("cooktorrance.f0").value_or(m.f0), Vec3d(1.0));
    m.ior = number("cooktorrance.ior", 1, largest);
    const auto eta = colour("cooktorrance.eta");
    const auto k = colour("cooktorrance.k");
    if (eta && k) m.eta_k = {*eta, *k};
    if (reader_.arguments.string("cooktorrance.fresnel") == own::exact)
      m.fresnel = description::FresnelModel::Exact;
    if (reader_.arguments.string("cooktorrance.geometry") == own::smith)
      m.geometry = description::GeometryModel::Smith;
    m.energy_compensation = reader_.arguments.flag("energycompensation", false);
    if (m.fresnel == description::FresnelModel::Exact && !m.ior && !m.eta_k)
      refuse("cooktorrance.fresnel", "needs cooktorrance.ior, or cooktorrance.eta and .k");
    if (m.energy_compensation && m.geometry != description::GeometryModel::Smith)
      refuse("energycompensation", "needs \"string cooktorrance.geometry\" \"smith\"");
    return m;
  }

 private:
  static constexpr double largest = std::numeric_limits<double>::max();

  void refuse(std::string_view name, std::string_view why) {
    reader_.arguments.error(*reader_.arguments.find(name), why);
  }
  std::optional<double> number(std::string_view name, double low, double high) {
    const auto number = reader_.arguments.number(name);
    if (!number || (*number >= low && *number <= high)) return number;
    refuse(name, high == largest ? fmt::format("is {}, expected at least {}", *number, low)
                                 : fmt::format("is {}, expected {} to {}", *number, low, high));
    return std::nullopt;
  }
  // By a number from 0 to 1 or a texture.
  std::optional<description::ScalarInput> share(std::string_view name) {
    const auto scalar = reader_.textures.scalar(reader_.arguments, name);
    if (!scalar || (scalar->factor >= 0 && scalar->factor <= 1)) return scalar;
    refuse(name, fmt::format("is {}, expected 0 to 1", scalar->factor));
    return std::nullopt;
  }
  std::optional<Vec3d> colour(std::string_view name) {
    const Parameter* parameter = reader_.arguments.find(name, {ParameterType::Rgb});
    if (!parameter) return std::nullopt;
    return factor_colour(*parameter, reader_.context.scene, reader_.arguments.report());
  }

  MaterialReader& reader_;
};

}  // namespace

bool set_own_model(MaterialReader& reader, Material& material) {
  Arguments& arguments = reader.arguments;
  const auto model = arguments.string("model");
  if (!model) return false;
  arguments.accept(
      {"reflectance", "eta", "k", "roughness", "remaproughness", "materials", "amount"});
  OwnModelReader own(reader);
  if (*model == own::lab)
    material.model = own.lab(material);
  else if (*model == own::mirror)
    material.model = own.mirror();
  else if (*model == own::cook_torrance)
    material.model = own.cook_torrance();
  else
    arguments.error(
        *arguments.find("model"),
        fmt::format("is {}{}", text::quoted(*model),
                    nearest_or_all(*model, {own::lab, own::mirror, own::cook_torrance})));
  return true;
}

void add_own_parameters(MaterialReader& reader, Material& material) {
  Arguments& arguments = reader.arguments;
  if (auto* metal = std::get_if<description::ConductorMaterial>(&material.model)) {
    metal->energy_compensation = arguments.flag("energycompensation", false);
    if (metal->energy_compensation && metal->roughness_across)
      arguments.error(*arguments.find("energycompensation"),
                      "needs one roughness, found uroughness and vroughness that differ");
  }
  auto* glass = std::get_if<description::DielectricMaterial>(&material.model);
  if (!glass) return;
  if (const Parameter* colour = arguments.find("transmittance", {ParameterType::Rgb}))
    glass->transmittance = factor_colour(*colour, reader.context.scene, arguments.report())
                               .value_or(glass->transmittance);
}

}  // namespace candela::pbrt
