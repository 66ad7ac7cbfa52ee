// Statements of an MTL -> materials: the table in read_mtl.h.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "renderer/math/reflectance.h"
#include "scene_io/obj/mtl_statements.h"
#include "scene_io/obj/read_mtl.h"

namespace candela::obj {
namespace {

using namespace description;

constexpr double default_glass_index = 1.5;
constexpr double dielectric_reflectance = 0.04;  // of index 1.5 at normal incidence
constexpr double smooth_exponent = 100.0;        // Ns from which glass and mirrors are smooth

class ImageTable {
 public:
  explicit ImageTable(std::vector<Image>& images) : images_(images) {}

  ImageHandle add(const std::optional<MtlTexture>& texture, Encoding encoding) {
    if (!texture) return {};
    const Wrap wrap = texture->is_clamped ? Wrap::Clamp : Wrap::Repeat;
    const auto [entry, is_new] =
        known_.emplace(std::tuple(texture->path, encoding, wrap), ImageHandle(images_.size()));
    if (is_new) images_.push_back({texture->path, encoding, wrap, texture->span});
    return entry->second;
  }

 private:
  std::vector<Image>& images_;
  std::map<std::tuple<std::string, Encoding, Wrap>, ImageHandle> known_;
};

Vec3d clamped(const std::optional<Vec3d>& colour) {
  return glm::clamp(colour.value_or(Vec3d{0.0}), 0.0, 1.0);
}
double dissolve(const MtlStatements& s) {
  return std::clamp(s.d.value_or(1.0 - s.tr.value_or(0.0)), 0.0, 1.0);
}
Vec3d linear(const Vec3d& lab) {
  return {std::pow(lab.x, 2.2), std::pow(lab.y, 2.2), std::pow(lab.z, 2.2)};
}
bool is_black(const Vec3d& colour) {
  return max_component(colour) <= 0.0;
}

LabMaterial lab_material(const MtlStatements& s, double max_exponent, ImageTable& images) {
  LabMaterial lab;
  lab.diffuse = {clamped(s.kd), images.add(s.map_kd, Encoding::LabGamma)};
  lab.alpha = s.map_kd ? 1.0 : dissolve(s);
  lab.specular = {clamped(s.ks), images.add(s.map_ks, Encoding::Linear)};
  lab.shininess = std::clamp(s.ns.value_or(1.0), 0.0, max_exponent);
  return lab;
}

bool has_metal_workflow(const MtlStatements& s) {
  return s.pr || s.pm || s.map_pr;
}

bool transmits(const MtlStatements& s) {
  if (s.map_kd || s.map_d) return false;
  const Vec3d filter = s.tf.value_or(Vec3d{1.0});
  const bool lets_through = std::min({filter.x, filter.y, filter.z}) < 1.0 || dissolve(s) < 1.0;
  const bool bends = s.ni.value_or(1.0) > 1.0;
  const int illum = s.illum.value_or(2);
  const bool says_so = illum == 4 || illum == 6 || illum == 7 || illum == 9;
  return says_so ? lets_through || bends : lets_through && bends;
}

bool mirrors(const MtlStatements& s) {
  const int illum = s.illum.value_or(2);
  const bool is_smooth = s.ns.value_or(smooth_exponent) >= smooth_exponent;
  return illum >= 3 && illum <= 9 && is_smooth && !s.map_kd && !s.map_ks &&
         is_black(clamped(s.kd)) && !is_black(clamped(s.ks));
}

DielectricMaterial dielectric(const MtlStatements& s) {
  DielectricMaterial glass;
  const double index = s.ni.value_or(1.0);
  glass.is_thin = index <= 1.0;
  glass.ior = glass.is_thin ? default_glass_index : index;
  glass.transmittance = glm::clamp(s.tf.value_or(Vec3d{1.0}), 0.0, 1.0);
  const bool is_rough = !glass.is_thin && s.ns && *s.ns > 0.0 && *s.ns < smooth_exponent;
  glass.roughness.factor = is_rough ? width_of_exponent(*s.ns) : 0.0;
  return glass;
}

// kd + ks F conserves energy only while kd + ks <= 1; f0 makes up for the smaller ks, so that the
// reflectance at normal incidence is the wanted one.
CookTorranceMaterial metal_workflow(const MtlStatements& s, ImageTable& images) {
  const double wanted_metalness = std::clamp(s.pm.value_or(0.0), 0.0, 1.0);
  const double metalness = s.map_kd ? std::round(wanted_metalness) : wanted_metalness;
  const Vec3d base = linear(clamped(s.kd));
  const ImageHandle map = images.add(s.map_kd, Encoding::LabGamma);
  const bool map_is_metal = map && metalness == 1;
  CookTorranceMaterial m;
  const double diffuse_share = 1.0 - metalness;
  m.diffuse.factor = diffuse_share * base;
  if (!map_is_metal) m.diffuse.map = map;
  const double diffuse_most = m.diffuse.map ? 0.5 : max_component(m.diffuse.factor);
  const double specular = 1.0 - diffuse_most;
  m.specular.factor = Vec3d{specular};
  if (map_is_metal) m.specular.map = map;
  const Vec3d reflectance =
      map_is_metal ? Vec3d{1.0} : dielectric_reflectance * diffuse_share + metalness * base;
  m.f0 = specular > 0.0 ? glm::min(reflectance / specular, Vec3d{1.0}) : Vec3d{0.0};
  const double width = std::clamp(s.pr.value_or(0.5), 0.0, 1.0);
  m.roughness = {width * width, images.add(s.map_pr, Encoding::Linear), 0};
  return m;
}

constexpr int own_alpha = 3;  // 1 where the file has none

int channel_of(const MtlTexture& texture) {
  switch (texture.channel.value_or('\0')) {
    case 'r':
    case 'l':
    case 'z':
      return 0;
    case 'g':
      return 1;
    case 'b':
      return 2;
    case 'm':
      return own_alpha;
    default:
      return alpha_or_first;
  }
}

bool is_same_file(const std::optional<MtlTexture>& a, const std::optional<MtlTexture>& b) {
  return a && b && a->path == b->path;
}

// What d and map_d leave to say once the model has taken its part.
ScalarInput opacity(const MtlStatements& s, const Material& material, ImageTable& images) {
  const auto* const lab = std::get_if<LabMaterial>(&material.model);
  // A LabMaterial's diffuse map brings its own alpha.
  if (s.map_d && !(lab && is_same_file(s.map_d, s.map_kd))) {
    return {1.0, images.add(s.map_d, Encoding::Linear), channel_of(*s.map_d)};
  }
  if (!lab && s.map_kd && dissolve(s) == 1.0)
    return {1.0, images.add(s.map_kd, Encoding::LabGamma), own_alpha};
  const bool is_taken =
      std::holds_alternative<DielectricMaterial>(material.model) || (lab && !s.map_kd);
  return {is_taken ? 1.0 : dissolve(s), {}, 0};
}

void set_model(const MtlStatements& s, Material& material, ImageTable& images) {
  if (has_metal_workflow(s)) {
    material.model = metal_workflow(s, images);
  } else if (transmits(s)) {
    material.model = dielectric(s);
  } else if (mirrors(s)) {
    material.model = MirrorMaterial{{clamped(s.ks), {}}};
  } else {
    material.model = lab_material(s, HUGE_VAL, images);
  }
}

void set_surface(const MtlStatements& s, Material& material, ImageTable& images) {
  material.emission = glm::max(s.ke.value_or(Vec3d(s.map_ke ? 1.0 : 0.0)), 0.0);
  material.emits_both_sides = !is_black(material.emission);
  if (!is_black(material.emission)) material.emission_map = images.add(s.map_ke, Encoding::Srgb);
  material.opacity = opacity(s, material, images);
  material.normal_map = images.add(s.norm, Encoding::Linear);
}

Material full_material(const MtlStatements& s, ImageTable& images) {
  Material material;
  set_model(s, material, images);
  set_surface(s, material, images);
  material.height_scale = bump_height * (s.bump ? s.bump->bump_multiplier : 1.0);
  return material;
}

Material lab_mode_material(const MtlStatements& s, ImageTable& images) {
  Material material;
  material.model = lab_material(s, 256.0, images);
  material.height_scale = bump_height;
  return material;
}

// Texture options are the course's loader's to ignore.
void drop_texture_options(MtlStatements& s) {
  for (std::optional<MtlTexture>* texture : {&s.map_kd, &s.map_ks, &s.bump}) {
    if (*texture) (*texture)->is_clamped = false;
  }
}

}  // namespace

MtlLibrary parse_mtl(const std::string& path, std::string_view text, MtlUse use,
                     Diagnostics& diagnostics) {
  MtlLibrary library;
  if (use == MtlUse::Ignore) return library;
  ImageTable images(library.images);
  const text::Source source = text::make_source(path, text);
  for (MtlStatements& s : parse_mtl_statements(path, source, use, diagnostics)) {
    if (use == MtlUse::Lab) drop_texture_options(s);
    Material material =
        use == MtlUse::Full ? full_material(s, images) : lab_mode_material(s, images);
    material.name = std::move(s.name);
    material.span = std::move(s.span);
    material.height = images.add(s.bump, Encoding::Linear);
    library.materials.push_back(std::move(material));
  }
  return library;
}

}  // namespace candela::obj
