#include <iterator>
#include <map>
#include <tuple>

#include "scene_io/obj/map_images.h"
#include "scene_io/obj/read_obj.h"

namespace candela::obj {
namespace {

using namespace description;

using ImageKey = std::tuple<std::string, Encoding, Wrap>;

ImageKey key_of(const Image& image) {
  return {image.path, image.encoding, image.wrap};
}

// Where each of the model's images stands in the scene.
std::vector<ImageHandle> append_images(std::vector<Image>&& images, SceneDescription& scene) {
  std::vector<ImageHandle> handles;
  if (images.empty()) return handles;
  std::map<ImageKey, ImageHandle> known;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    known.emplace(key_of(scene.images[i]), ImageHandle(i));
  }
  for (Image& image : images) {
    const auto [entry, is_new] = known.emplace(key_of(image), ImageHandle(scene.images.size()));
    if (is_new) scene.images.push_back(std::move(image));
    handles.push_back(entry->second);
  }
  return handles;
}

void append_materials(ObjModel& model, SceneDescription& scene) {
  const std::vector<ImageHandle> images = append_images(std::move(model.images), scene);
  for (Material& material : model.materials) {
    for_each_image(material, [&](ImageHandle& image) {
      if (image) image = images[image.index];
    });
    scene.materials.push_back(std::move(material));
  }
}

}  // namespace

std::vector<MeshHandle> append_model(ObjModel&& model, MaterialHandle material,
                                     SceneDescription& scene) {
  const std::size_t first_material = scene.materials.size();
  append_materials(model, scene);
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
  return append_model(read_obj(path, options, diagnostics), options.material, scene);
}

}  // namespace candela::obj
