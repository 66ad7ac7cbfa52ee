#include "scene_io/lab3/mesh_files.h"

#include <map>
#include <set>
#include <utility>

#include "renderer/base/letter_case.h"
#include "renderer/base/parallel.h"
#include "scene_io/obj/read_obj.h"
#include "scene_io/ply/read_ply.h"
#include "scene_io/text/file.h"

namespace candela::lab3 {
namespace {

using description::Instance;
using description::MaterialHandle;
using description::MeshHandle;
using description::SceneDescription;

// One file that several requests may share.
struct LoadedFile {
  const MeshRequest* first = nullptr;
  obj::ObjModel model;
  Diagnostics diagnostics;
  std::vector<MeshHandle> meshes;  // in the scene, once placed
};

void read_file(LoadedFile& file, const LoadOptions& options) {
  const MeshRequest& request = *file.first;
  if (request.format == MeshFormat::Ply) {
    file.model.files.push_back(request.path);
    auto mesh = ply::read_ply(request.path, {}, file.diagnostics);
    if (mesh) file.model.meshes.push_back(std::move(*mesh));
    return;
  }
  obj::ObjOptions obj_options;
  obj_options.materials = obj::MtlUse::Ignore;
  if (request.has_own_materials)
    obj_options.materials = options.use_mtl_materials ? obj::MtlUse::Full : obj::MtlUse::Lab;
  file.model = obj::read_obj(request.path, obj_options, file.diagnostics);
}

void place(const LoadedFile& file, const MeshRequest& request, SceneDescription& scene) {
  const bool needs_override =
      !request.has_own_materials && request.material != file.first->material;
  const MaterialHandle material = needs_override ? request.material : MaterialHandle();
  for (const Placement& placement : request.placements)
    for (const MeshHandle mesh : file.meshes)
      scene.instances.push_back({mesh, placement.object_to_world, material, placement.span});
}

}  // namespace

MeshFormat mesh_format_of(std::string_view path) {
  path = text::without_gzip_extension(path);
  if (ends_ignoring_case(path, ".obj")) return MeshFormat::Obj;
  if (ends_ignoring_case(path, ".ply")) return MeshFormat::Ply;
  return MeshFormat::Unknown;
}

void MeshFiles::load_and_place(const LoadOptions& options, SceneDescription& scene,
                               Diagnostics& diagnostics) const {
  std::map<std::pair<std::string, bool>, std::size_t> index_of;
  std::vector<LoadedFile> files;
  std::vector<std::size_t> file_of_request;
  for (const MeshRequest& request : requests_) {
    const auto [at, is_new] =
        index_of.try_emplace({request.path, request.has_own_materials}, files.size());
    if (is_new) files.emplace_back().first = &request;
    file_of_request.push_back(at->second);
  }
  parallel_for(files.size(), [&](std::size_t i) { read_file(files[i], options); });
  ImageIndex images;
  std::set<std::string> told;  // two of them may be one OBJ
  for (LoadedFile& file : files) {
    if (told.insert(file.first->path).second)
      diagnostics.append(file.diagnostics);
    else
      for (const Diagnostic& found : file.diagnostics.list()) diagnostics.add_once(found);
    file.meshes = obj::append_model(std::move(file.model), file.first->material, images, scene);
  }
  for (std::size_t i = 0; i < requests_.size(); ++i)
    place(files[file_of_request[i]], requests_[i], scene);
}

}  // namespace candela::lab3
