#include "scene_io/lab3/read_lab3.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "renderer/description/lamp_surfaces.h"
#include "renderer/description/used_materials.h"
#include "scene_io/default_camera.h"
#include "scene_io/lab3/camera.h"
#include "scene_io/lab3/environment.h"
#include "scene_io/lab3/fields.h"
#include "scene_io/lab3/ground.h"
#include "scene_io/lab3/lights.h"
#include "scene_io/lab3/materials.h"
#include "scene_io/lab3/models.h"
#include "scene_io/lab3/render_defaults.h"
#include "scene_io/text/file.h"
#include "scene_io/text/plain_text.h"
#include "scene_io/text/source.h"

namespace candela::lab3 {
namespace {

constexpr std::string_view keys[] = {"Reflection", "AmbientIntensity", "Skyboxes", "Cameras",
                                     "Lights",     "Materials",        "Models",   "ComplexModels",
                                     "Render",     "Environment"};

// Loaded by lab3 and read by nothing there; all materials are Blinn-Phong.
void check_reflection(Reader& reader, const Fields& root) {
  static constexpr std::string_view words[] = {"Empirical", "PhysicalMetallic", "PhysicalSpecular"};
  const auto reflection = root.choice("Reflection", words);
  if (reflection && *reflection != 0)
    reader.warning(root.find("Reflection")->value->offset,
                   fmt::format("Reflection: {} is read by nothing in lab3: materials without a "
                               "Type are Empirical (Blinn-Phong)",
                               words[*reflection]));
}

// Of those that something wears; null where there is none.
const description::Material* first_glowing_material(const description::SceneDescription& scene) {
  const std::vector<bool> is_used = description::used_materials(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (is_used[i] && scene.materials[i].emission != Vec3d(0.0)) return &scene.materials[i];
  return nullptr;
}

// In the forks that know both, the light and the glowing model stand for one lamp.
void warn_of_double_lamps(Reader& reader) {
  const description::SceneDescription& scene = reader.scene;
  const auto light = std::ranges::find_if(scene.lights, description::is_triangle_light);
  const description::Material* material = first_glowing_material(scene);
  if (light == scene.lights.end() || !material) return;
  reader.diagnostics.warning(
      light->span, fmt::format("there are Area lights and materials with Emission ({}): both "
                               "shine; where they stand for the same lamp leave one out",
                               text::quoted(material->name)));
}

void read_scene(Reader& reader, const Node& node) {
  const Fields root(reader, node, "a scene", keys);
  if (!node.is_map()) return;
  check_reflection(reader, root);
  read_render_defaults(reader, root);
  read_cameras(reader, root);
  read_lights(reader, root);
  read_materials(reader, root);
  read_skyboxes(reader, root);
  read_environment(reader, root);
  read_ambient(reader, root);
  read_models(reader, root);
  warn_of_double_lamps(reader);
  if (reader.diagnostics.has_errors()) return;
  add_ground(reader);
  if (reader.scene.cameras.empty()) {
    reader.note("no Cameras are given: one that sees all of the scene from the front is used");
    reader.scene.cameras.push_back(default_camera(reader.scene));
  }
}

}  // namespace

Result<description::SceneDescription> read_lab3(const std::string& path,
                                                const LoadOptions& options) {
  Result<std::string> bytes =
      text::read_file(path, {.bytes = max_yaml_bytes, .inflated_bytes = max_yaml_bytes});
  if (!bytes) return bytes.diagnostics;
  text::use_line_feeds(*bytes);
  return parse_lab3(path, *bytes, options);
}

Result<description::SceneDescription> parse_lab3(const std::string& path, std::string_view text,
                                                 const LoadOptions& options) {
  Diagnostics diagnostics;
  description::SceneDescription scene;
  scene.path = path;
  scene.files.push_back(path);
  Reader reader(path, text::without_byte_order_mark(text), options, scene, diagnostics);
  const std::optional<Document> document = parse_yaml(reader.source, diagnostics);
  if (document) read_scene(reader, *document->root);
  if (diagnostics.has_errors()) return diagnostics;
  return {std::move(scene), std::move(diagnostics)};
}

}  // namespace candela::lab3
