#include <iterator>

#include "scene_io/obj/map_images.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {
namespace {

using namespace description;

void append_materials(ObjModel& model, ImageIndex& index, SceneDescription& scene) {
  std::vector<ImageHandle> images;  // where each of the model's stands in the scene
  for (Image& image : model.images) images.push_back(index.add(std::move(image), scene));
  for (Material& material : model.materials) {
    for_each_image(material, [&](ImageHandle& image) {
      if (image) image = images[image.index];
    });
    scene.materials.push_back(std::move(material));
  }
}

}  // namespace

std::vector<MeshHandle> append_model(ObjModel&& model, MaterialHandle material, ImageIndex& images,
                                     SceneDescription& scene) {
  const std::size_t first_material = scene.materials.size();
  append_materials(model, images, scene);
  std::vector<MeshHandle> handles;
  for (Mesh& mesh : model.meshes) {
    for (MaterialHandle& own : mesh.materials) own = MaterialHandle(own.index + first_material);
    if (mesh.materials.empty()) mesh.materials = {material};
    handles.emplace_back(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
  }
  std::move(model.files.begin(), model.files.end(), std::back_inserter(scene.files));
  return handles;
}

std::vector<MeshHandle> append_obj(const std::string& path, const ObjOptions& options,
                                   SceneDescription& scene, Diagnostics& diagnostics) {
  ImageIndex images;
  return append_model(read_obj(path, options, diagnostics), options.material, images, scene);
}

}  // namespace candela::obj
