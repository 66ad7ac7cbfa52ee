#include "renderer/scene/compile_coverage.h"

#include <map>
#include <tuple>

namespace candela {

// Materials that differ in other things share one grid.
void compile_coverage(Scene& scene) {
  using Source = std::tuple<TextureHandle, int, bool>;
  std::map<Source, Handle<CoverageGrid>> grids;
  for (const Geometry& geometry : scene.geometries) {
    Material& material = scene.materials[geometry.material.index];
    const ScalarParameter& opacity = material.opacity;
    if (!geometry.has_cutouts || !opacity.texture) continue;
    const Source source{opacity.texture, opacity.channel, material.lab_opacity};
    const auto [at, is_new] = grids.try_emplace(source, scene.coverage_grids.size());
    if (is_new)
      scene.coverage_grids.emplace_back(scene.textures, opacity.texture, opacity.channel,
                                        material.lab_opacity);
    material.coverage_grid = at->second;
  }
}

}  // namespace candela
