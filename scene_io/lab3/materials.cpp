#include "scene_io/lab3/materials.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "scene_io/image_encoding.h"
#include "scene_io/lab3/assets.h"
#include "scene_io/lab3/lab_material.h"
#include "scene_io/lab3/material_keys.h"
#include "scene_io/lab3/typed_material.h"
#include "scene_io/obj/read_mtl.h"
#include "scene_io/text/source.h"

namespace candela::lab3 {
namespace {

using description::Encoding;
using description::Wrap;

// The Type decides which keys are known, so it is looked at before the rest. Nothing for an unknown
// word.
std::optional<MaterialType> peek_type(const Node& node) {
  for (const Entry& entry : node.entries) {
    if (!is_same_name(entry.key, "Type")) continue;
    for (std::size_t i = 0; i < std::size(material_type_words); ++i)
      if (is_same_name(entry.value->text, material_type_words[i]))
        return static_cast<MaterialType>(i + 1);
    return std::nullopt;
  }
  return MaterialType::Lab;
}

// Whether another key than `key` is nearly that word, and unknown: no other key is near it.
bool has_misspelt(const Node& node, std::string_view key) {
  return std::any_of(node.entries.begin(), node.entries.end(),
                     [&](const Entry& entry) { return !nearest_name(entry.key, {key}).empty(); });
}

template <MaterialType type>
std::string hint_for(std::string_view key) {
  return hint_of_material_key(type, key);
}

Fields::Hint hint_of(MaterialType type) {
  switch (type) {
    case MaterialType::Lab:
      return hint_for<MaterialType::Lab>;
    case MaterialType::CookTorrance:
      return hint_for<MaterialType::CookTorrance>;
    case MaterialType::Diffuse:
      return hint_for<MaterialType::Diffuse>;
    case MaterialType::Mirror:
      return hint_for<MaterialType::Mirror>;
    case MaterialType::Conductor:
      return hint_for<MaterialType::Conductor>;
    case MaterialType::Dielectric:
      return hint_for<MaterialType::Dielectric>;
    case MaterialType::ThinDielectric:
      return hint_for<MaterialType::ThinDielectric>;
  }
  return nullptr;
}

// Where nobody knows which Type is meant, the keys of all are known: one message is enough.
Fields fields_of(Reader& reader, const Node& node, const std::optional<MaterialType>& type) {
  const bool is_unclear = !type || (*type == MaterialType::Lab && has_misspelt(node, "Type"));
  if (is_unclear) return {reader, node, "a material", all_material_keys()};
  return {reader, node, "a material", material_keys(*type), hint_of(*type)};
}

void read_emission(Reader& reader, const Fields& fields, description::Material& material) {
  const Entry* map = fields.find("EmissionMap");
  material.emission = fields.colour("Emission", not_negative).value_or(Vec3d(map ? 1.0 : 0.0));
  material.emits_both_sides = fields.flag("TwoSided", false);
  if (map)
    material.emission_map =
        read_image(reader, map, encoding_of_colours(map->value->text), Wrap::Repeat);
  const bool emits = fields.has("Emission") || map;
  if (emits) reader.is_extended = true;
  if (fields.has("TwoSided") && !emits)
    reader.warning(fields.find("TwoSided")->key_offset, "TwoSided has no effect without Emission");
}

void read_opacity(Reader& reader, const Fields& fields, description::Material& material) {
  material.opacity.factor = fields.number("opacity", zero_to_one).value_or(1);
  const Entry* map = fields.find("opacity_map");
  if (!map) return;
  material.opacity.map = read_image_over(reader, fields.find("opacity"), map, Encoding::Linear);
  material.opacity.channel = description::alpha_or_first;
}

// lab3's own materials have their alpha, which is an opacity, too.
void warn_of_lost_alpha(Reader& reader, const Fields& fields,
                        const description::Material& material) {
  const auto* lab = std::get_if<description::LabMaterial>(&material.model);
  const bool has_opacity = !material.opacity.is_constant() || material.opacity.factor != 1;
  if (!lab || lab->diffuse.map || lab->alpha == 1 || !has_opacity) return;
  const Entry* map = fields.find("opacity_map");
  const Entry& opacity = map ? *map : *fields.find("opacity");
  reader.warning(opacity.key_offset,
                 fmt::format("{} replaces this material's alpha of {}", opacity.key, lab->alpha));
}

void read_relief(Reader& reader, const Fields& fields, description::Material& material) {
  const Entry* map = fields.last_of(height_map_names);
  material.height = read_image(reader, map, Encoding::Linear, Wrap::Repeat);
  material.height_scale = fields.number("bump_scale", any_number).value_or(obj::bump_height);
  material.normal_map =
      read_image(reader, fields.find("normal_map"), Encoding::Linear, Wrap::Repeat);
  if (fields.has("bump_scale") && !map)
    reader.warning(fields.find("bump_scale")->key_offset,
                   "bump_scale has no effect without a HeightMap");
}

void remember_name(Reader& reader, const Fields& fields, const std::string& name) {
  const description::MaterialHandle handle(reader.scene.materials.size());
  const bool is_new = reader.materials_by_name.insert_or_assign(name, handle).second;
  if (!is_new)
    reader.warning(
        fields.find("Name")->value->offset,
        fmt::format("material {} is defined twice: the last one counts", text::quoted(name)));
}

std::string read_name(Reader& reader, const Fields& fields, const Node& node) {
  const auto name = fields.word("Name");
  if (name) {
    remember_name(reader, fields, *name);
  } else if (fields.has("Name") || has_misspelt(node, "Name")) {
    reader.lacks_material_names = true;
  } else {
    reader.warning(node.offset, "this material has no Name: no model can use it by name");
  }
  return name.value_or("");
}

void read_look(Reader& reader, const Fields& fields, MaterialType type,
               description::Material& material) {
  static constexpr std::string_view blends[] = {"Opaque", "Transparent"};
  (void)fields.choice("Blend", blends);  // of the rasteriser; alpha alone decides here
  if (type == MaterialType::Lab)
    material.model = read_lab_material(reader, fields);
  else
    material.model = read_typed_material(reader, fields, type);
  read_emission(reader, fields, material);
  read_opacity(reader, fields, material);
  warn_of_lost_alpha(reader, fields, material);
  read_relief(reader, fields, material);
}

void read_material(Reader& reader, const Node& node) {
  const std::optional<MaterialType> type = peek_type(node);
  const Fields fields = fields_of(reader, node, type);
  if (!node.is_map()) {
    reader.lacks_material_names = true;
    return;
  }
  (void)fields.choice("Type", material_type_words);
  if (type != MaterialType::Lab) reader.is_extended = true;
  description::Material material;
  material.span = reader.span(node.offset);
  material.name = read_name(reader, fields, node);
  if (type) read_look(reader, fields, *type, material);
  reader.scene.materials.push_back(std::move(material));
}

}  // namespace

void read_materials(Reader& reader, const Fields& root) {
  const Entry* materials = root.find("Materials");
  reader.lacks_material_names = materials && !is_list(*materials->value);
  for_each_entry(reader, root, "Materials", [&](const Node& node) { read_material(reader, node); });
}

}  // namespace candela::lab3
