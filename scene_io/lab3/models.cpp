#include "scene_io/lab3/models.h"

#include <fmt/format.h>

#include "scene_io/lab3/assets.h"
#include "scene_io/lab3/mesh_files.h"
#include "scene_io/lab3/transforms.h"
#include "scene_io/text/source.h"

namespace candela::lab3 {
namespace {

using description::MaterialHandle;

constexpr std::string_view model_keys[] = {"Mesh",     "Material",  "Translation", "Scale",
                                           "Rotation", "Instances", "Name"};
constexpr std::string_view complex_model_keys[] = {"Mesh", "Name"};

std::string hint_of_complex_model_key(std::string_view key) {
  for (const std::string_view known : model_keys)
    if (is_same_name(known, key))
      return fmt::format(
          "key {} is not read in ComplexModels, whose meshes bring their materials "
          "and stay where they are",
          text::quoted(key));
  return "";
}

// Comparing with all names would take long for many names.
std::string advice_on_material(const Reader& reader, std::string_view name) {
  if (!reader.wants_warnings()) return "";
  std::vector<std::string_view> names;
  for (const description::Material& material : reader.scene.materials)
    names.push_back(material.name);
  return did_you_mean(name, names);
}

MaterialHandle material_of(Reader& reader, const Fields& fields) {
  const auto name = fields.word("Material");
  if (!name) return MaterialHandle(std::size_t{0});
  const auto found = reader.materials_by_name.find(*name);
  if (found != reader.materials_by_name.end()) return found->second;
  if (fields.has("Mesh") && !reader.lacks_material_names)
    reader.warning(fields.find("Material")->value->offset,
                   fmt::format("unknown material {}: the first of the file is used, as in lab3{}",
                               text::quoted(*name), advice_on_material(reader, *name)));
  return MaterialHandle(std::size_t{0});
}

// The places of a model: its own, or one for each of its Instances.
std::vector<Placement> placements_of(Reader& reader, const Fields& fields) {
  const Transform own = read_transform(reader, fields);
  if (!fields.has("Instances")) return {{own, reader.span(fields.offset())}};
  std::vector<Placement> placements;
  for_each_entry(reader, fields, "Instances", [&](const Node& node) {
    const Fields instance(reader, node, "an instance", transform_keys);
    placements.push_back({read_transform(reader, instance) * own, reader.span(node.offset)});
  });
  const Entry& instances = *fields.find("Instances");
  if (is_list(*instances.value) && placements.empty())
    reader.warning(instances.key_offset, "Instances is empty: the model is nowhere");
  return placements;
}

void warn_of_missing_mesh(Reader& reader, const Fields& fields, const Node& node) {
  if (node.is_map() && !fields.has("Mesh"))
    reader.warning(node.offset, "this model has no Mesh and is left out");
}

void read_model(Reader& reader, const Node& node, MeshFiles& files) {
  const Fields fields(reader, node, "a model", model_keys);
  warn_of_missing_mesh(reader, fields, node);
  const Entry* mesh = fields.find("Mesh");
  const MaterialHandle material = material_of(reader, fields);
  std::vector<Placement> placements = placements_of(reader, fields);
  if (!mesh) return;
  const std::string path = required_file(reader, *mesh, "a mesh");
  if (path.empty()) return;
  const MeshFormat format = mesh_format_of(path);
  if (format == MeshFormat::Unknown) {
    reader.error(mesh->value->offset, fmt::format("Mesh: found {}, expected an .obj or .ply file",
                                                  text::quoted(mesh->value->text)));
    return;
  }
  files.request({path, format, false, material, std::move(placements)});
}

void read_complex_model(Reader& reader, const Node& node, MeshFiles& files) {
  const Fields fields(reader, node, "a complex model", complex_model_keys,
                      hint_of_complex_model_key);
  warn_of_missing_mesh(reader, fields, node);
  const Entry* mesh = fields.find("Mesh");
  if (!mesh) return;
  const std::string path = required_file(reader, *mesh, "a mesh");
  if (path.empty()) return;
  if (mesh_format_of(path) != MeshFormat::Obj) {
    reader.error(mesh->value->offset,
                 fmt::format("Mesh: found {}, expected an .obj file, which brings its materials",
                             text::quoted(mesh->value->text)));
    return;
  }
  files.request({path, MeshFormat::Obj, true, {}, {{{}, reader.span(node.offset)}}});
}

// lab3 takes material 0 for a model without one, and has none where the file lists none.
void add_default_material(Reader& reader, const Fields& root) {
  const Entry* models = root.find("Models");
  if (!reader.scene.materials.empty() || !models || models->value->entries.empty()) return;
  if (!reader.lacks_material_names)
    reader.warning(models->key_offset, "there are Models but no Materials: they are grey");
  reader.lacks_material_names = true;
  description::Material grey;
  grey.name = "default";
  grey.model = description::LabMaterial{{Vec3d(0.5), {}}, 1, {Vec3d(0.0), {}}, 0};
  reader.scene.materials.push_back(std::move(grey));
}

}  // namespace

void read_models(Reader& reader, const Fields& root) {
  add_default_material(reader, root);
  MeshFiles files;
  for_each_entry(reader, root, "Models",
                 [&](const Node& node) { read_model(reader, node, files); });
  for_each_entry(reader, root, "ComplexModels",
                 [&](const Node& node) { read_complex_model(reader, node, files); });
  files.load_and_place(reader.options, reader.scene, reader.diagnostics);
}

}  // namespace candela::lab3
