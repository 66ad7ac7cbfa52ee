#include "integrators/worn_materials.h"

namespace candela {

using namespace description;

std::vector<bool> worn_materials(const SceneDescription& scene) {
  std::vector<bool> worn(scene.materials.size());
  const auto wear = [&](MaterialHandle material) {
    if (material && material.index < worn.size()) worn[material.index] = true;
  };
  for (const Instance& instance : scene.instances) {
    wear(instance.material_override);
    if (instance.material_override || !instance.mesh) continue;
    for (const MaterialHandle material : scene.meshes[instance.mesh.index].materials)
      wear(material);
  }
  return worn;
}

}  // namespace candela
