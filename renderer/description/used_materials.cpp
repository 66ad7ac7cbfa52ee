#include "renderer/description/used_materials.h"

namespace candela::description {

std::vector<bool> used_materials(const SceneDescription& scene) {
  std::vector<bool> is_used(scene.materials.size(), false);
  const auto use = [&](MaterialHandle material) {
    if (material.index < is_used.size()) is_used[material.index] = true;
  };
  for (const Instance& instance : scene.instances) {
    use(instance.material_override);
    if (instance.material_override || instance.mesh.index >= scene.meshes.size()) continue;
    for (const MaterialHandle material : scene.meshes[instance.mesh.index].materials) use(material);
  }
  // Parts stand before what they are parts of.
  for (std::size_t i = scene.materials.size(); i-- > 0;) {
    const auto* mix = std::get_if<MixMaterial>(&scene.materials[i].model);
    if (!is_used[i] || mix == nullptr) continue;
    use(mix->first);
    use(mix->second);
  }
  return is_used;
}

}  // namespace candela::description
