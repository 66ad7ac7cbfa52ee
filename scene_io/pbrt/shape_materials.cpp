#include "scene_io/pbrt/shape_materials.h"

#include <fmt/format.h>

#include "renderer/description/validate.h"
#include "scene_io/pbrt/mesh_areas.h"

namespace candela::pbrt {

using description::Material;
using description::MaterialHandle;
using description::Mesh;

MaterialHandle ShapeMaterials::of(ShapeStatement& shape, const Mesh& mesh, std::size_t count) {
  Key key;
  key.base = &materials_.of(shape.material);
  read_alpha(shape, key);
  if (shape.media.is_transition() && !is_absent(key)) {
    warn_of_holes(key, shape.statement.place);
    key.inside = media_.of(shape.media.inside).index;
    key.outside = media_.of(shape.media.outside).index;
  }
  if (shape.area_light != none) {
    const Areas areas = areas_of(mesh, shape.world_from_object);
    read_emission_of(shape, areas.surface / static_cast<double>(count), key);
    warn_of_uneven_power(shape, mesh, count);
  }
  return of(key, shape.statement.place);
}

MaterialHandle ShapeMaterials::of(const Key& key, const Place& place) {
  const auto known = made_.find(key);
  if (known != made_.end()) return known->second;
  return made_[key] = add(key, place);
}

void ShapeMaterials::read_alpha(ShapeStatement& shape, Key& key) {
  Arguments arguments(shape.statement, context_.report);
  if (std::holds_alternative<description::LabMaterial>(key.base->model)) return;
  const auto alpha = textures_.scalar(arguments, "alpha");
  if (!alpha) return;
  key.opacity = arguments.clamped("alpha", alpha->factor, 0, 1);
  key.opacity_map = alpha->map.index;
  key.opacity_texture = alpha->texture.index;
}

bool ShapeMaterials::has_alpha(const Key& key) {
  return key.opacity != 1 || key.opacity_map != Key{}.opacity_map ||
         key.opacity_texture != Key{}.opacity_texture;
}

bool ShapeMaterials::is_absent(const Key& key) {
  return is_interface(*key.base) && key.opacity == 0;
}

void ShapeMaterials::warn_of_holes(const Key& key, const Place& place) {
  if (is_interface(*key.base) && has_alpha(key))
    context_.warn_once("hole in an interface", place,
                       "the alpha of an interface between media is ignored");
  const bool is_lab = std::holds_alternative<description::LabMaterial>(key.base->model);
  if (!is_lab && !is_interface(*key.base) && has_holes(*key.base))
    context_.warn_once("interface mixed in", place,
                       "an interface in a mixture between media lets rays through, but they stay "
                       "in their medium, which pbrt's leave");
}

void ShapeMaterials::read_emission_of(const ShapeStatement& shape, double area, Key& key) {
  const auto [at, is_new] = emissions_.try_emplace(shape.area_light);
  if (is_new) at->second = read_emission(context_, context_.program.area_lights[shape.area_light]);
  Vec3d radiance = at->second.radiance_on(area);
  if (!is_finite(radiance))
    context_.report.error(shape.statement.place, "what this shape emits is not finite");
  else if (const double most = max_component(radiance); most > description::largest_radiance) {
    context_.report.error(context_.program.area_lights[shape.area_light].place,
                          fmt::format("the radiance of this light is {}, expected at most {:g}",
                                      most, description::largest_radiance));
    radiance = Vec3d(0.0);
  }
  if (key.opacity == 0 && radiance != Vec3d(0.0))
    context_.warn_once("invisible lamp", shape.statement.place,
                       "lamps of an \"alpha\" of 0, which pbrt samples though no ray meets "
                       "them, are not supported: it is left out");
  key.emission = {radiance.x, radiance.y, radiance.z};
  key.emits_both_sides = at->second.emits_both_sides;
  key.emission_map = at->second.map.index;
  key.emission_is_maps_mean = at->second.is_maps_mean;
}

void ShapeMaterials::warn_of_uneven_power(const ShapeStatement& shape, const Mesh& mesh,
                                          std::size_t count) {
  if (!emissions_.at(shape.area_light).power || context_.warned.contains("uneven power")) return;
  if (!has_equal_parts(mesh, count, shape.world_from_object))
    context_.warn_once("uneven power", shape.statement.place,
                       "the power of a lamp is that of each of its triangles or patches, which "
                       "differ in area: all shine alike here, with as much power in all");
}

MaterialHandle ShapeMaterials::add(const Key& key, const Place& place) {
  Material material = *key.base;
  if (const MixParts* parts = materials_.parts_of(*key.base))
    material.model = mix_of(*parts, std::get<description::MixMaterial>(material.model), place);
  material.emission = {key.emission[0], key.emission[1], key.emission[2]};
  material.emits_both_sides = key.emits_both_sides;
  material.media.inside.index = key.inside;
  material.media.outside.index = key.outside;
  material.emission_map.index = key.emission_map;
  material.emission_is_maps_mean = key.emission_is_maps_mean;
  set_opacity(key, material, place);
  context_.scene.materials.push_back(std::move(material));
  return MaterialHandle(context_.scene.materials.size() - 1);
}

description::MixMaterial ShapeMaterials::mix_of(const MixParts& parts, description::MixMaterial mix,
                                                const Place& place) {
  Key part;
  part.base = parts.first;
  mix.first = of(part, place);
  part.base = parts.second;
  mix.second = of(part, place);
  return mix;
}

void ShapeMaterials::set_opacity(const Key& key, Material& material, const Place& place) {
  description::ScalarInput alpha;
  alpha.factor = key.opacity;
  alpha.map.index = key.opacity_map;
  alpha.texture.index = key.opacity_texture;
  alpha.channel = alpha.map ? description::alpha_or_mean : 0;
  if (alpha.is_constant() && material.opacity.is_constant())
    material.opacity.factor *= alpha.factor;
  else if (material.opacity.is_constant() && material.opacity.factor == 1)
    material.opacity = alpha;
  else if (!alpha.is_constant() || alpha.factor != 1)
    context_.warn_once("alpha", place,
                       "the alpha of shapes whose mixture has an interface is "
                       "ignored");
}

}  // namespace candela::pbrt
