#include "scene_io/load.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/default_camera.h"
#include "scene_io/lab3/mesh_files.h"
#include "scene_io/lab3/read_lab3.h"
#include "scene_io/override_materials.h"
#include "scene_io/pbrt/read_pbrt.h"
#include "scene_io/text/file.h"
#include "scene_io/text/source.h"

namespace candela {
namespace {

using description::SceneDescription;

// Whether it ends in one of the extensions, with .gz behind it or not.
bool has_extension(std::string_view path, std::initializer_list<std::string_view> extensions) {
  path = text::without_gzip_extension(path);
  return std::ranges::any_of(
      extensions, [&](std::string_view extension) { return ends_ignoring_case(path, extension); });
}

bool is_lab3(std::string_view path) {
  return has_extension(path, {".yaml", ".yml"});
}
bool is_pbrt(std::string_view path) {
  return has_extension(path, {".pbrt"});
}

std::string describe_extension(const std::string& path) {
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) return "a folder";
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? "a name without an extension"
                           : fmt::format("the extension {}", text::quoted(extension));
}

description::MaterialHandle add_grey(SceneDescription& scene) {
  description::Material grey;
  grey.name = "grey";
  grey.model = description::DiffuseMaterial{};
  scene.materials.push_back(std::move(grey));
  return description::MaterialHandle(scene.materials.size() - 1);
}

// A mesh alone: in white light from everywhere, seen from the front. It is no lab3 scene, so its
// MTL counts in full.
Result<SceneDescription> load_mesh(const std::string& path, lab3::MeshFormat format,
                                   const LoadOptions& options) {
  SceneDescription scene;
  Diagnostics diagnostics;
  scene.path = path;
  LoadOptions full = options;
  full.use_mtl_materials = true;
  const bool is_obj = format == lab3::MeshFormat::Obj;
  const description::MaterialHandle material =
      is_obj ? description::MaterialHandle() : add_grey(scene);
  lab3::MeshFiles files;
  files.request({path, format, is_obj, material, {{}}});
  files.load_and_place(full, scene, diagnostics);
  if (diagnostics.has_errors()) return diagnostics;
  const Vec3d radiance = options.ambient.value_or(Vec3d(1.0));
  scene.lights.push_back({{}, description::ConstantEnvironment{radiance, true}});
  scene.cameras.push_back(default_camera(scene));
  diagnostics.note({}, fmt::format("{} is a mesh alone: it is lit from everywhere and seen from "
                                   "the front",
                                   text::quoted_path(path)));
  return {std::move(scene), std::move(diagnostics)};
}

Result<SceneDescription> load_file(const std::string& path, const LoadOptions& options) {
  if (is_lab3(path)) return lab3::read_lab3(path, options);
  if (is_pbrt(path)) return pbrt::read_pbrt(path);
  const lab3::MeshFormat format = lab3::mesh_format_of(path);
  if (format != lab3::MeshFormat::Unknown) return load_mesh(path, format, options);
  return failure(
      fmt::format("{}: found {}, expected a scene: .yaml, .yml, .pbrt, .obj or .ply "
                  "(each also with .gz)",
                  text::quoted_path(path), describe_extension(path)));
}

// Of a mesh alone the MTL counts anyway, and it is lit as ambient light says.
void warn_of_lab3_options(const std::string& path, const LoadOptions& options,
                          Diagnostics& diagnostics) {
  if (is_lab3(path)) return;
  const auto warn = [&](bool is_given, std::string_view option) {
    if (is_given) diagnostics.warning({}, fmt::format("{} counts for lab3 scenes only", option));
  };
  warn(options.lab3_ground.has_value(), "--lab3-ground");
  if (!is_pbrt(path)) return;
  warn(options.ambient.has_value(), "--ambient");
  warn(options.use_mtl_materials, "--materials mtl");
}

}  // namespace

Result<SceneDescription> load(const std::string& path, const LoadOptions& options) {
  Result<SceneDescription> scene = load_file(path, options);
  if (scene) override_materials(options, *scene, scene.diagnostics);
  if (scene) warn_of_lab3_options(path, options, scene.diagnostics);
  if (scene.diagnostics.has_errors()) return std::move(scene.diagnostics);
  return scene;
}

}  // namespace candela
