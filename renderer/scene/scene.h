// The compiled Scene: immutable, shared by all threads without locks; tables and handles, no
// strings in what kernels read, no pointer graphs.
//
// Space: the file's coordinates, moved to the scene's own centre and scaled by a power of two to
// unit size ("normalised space"). Radiance is as in the file; what has a length in its unit was
// scaled along.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/camera/camera.h"
#include "renderer/geometry/geometry.h"
#include "renderer/light/environment.h"
#include "renderer/light/light.h"
#include "renderer/light/light_sampler.h"
#include "renderer/material/coverage_grid.h"
#include "renderer/material/material.h"
#include "renderer/math/bounds.h"
#include "renderer/medium/medium.h"
#include "renderer/texture/texture.h"

namespace candela {

// normalised = (file - centre) * scale, with scale a power of two.
struct Normalisation {
  Vec3d centre{0.0};
  double scale = 1.0;

  [[nodiscard]] Vec3d to_file(const Vec3f& p) const { return Vec3d(p) / scale + centre; }
};

// What kernels ask of a scene as a whole.
struct SceneFeatures {
  bool bump = false;   // height or normal maps
  bool mixes = false;  // of materials
  bool area_lights = false;
  bool spheres = false;
  bool media = false;
  bool cameras_in_media = false;
  bool scattering_media = false;
  bool clear_boundaries = false;  // surfaces that only bound media
  std::uint32_t bsdf_models = 0;  // ModelSet

  friend bool operator==(const SceneFeatures&, const SceneFeatures&) = default;
};

// What compiling left out and why, for `candela info`.
struct Dropped {
  std::string what;
  std::uint64_t count = 0;
};

struct Scene {
  std::vector<Geometry> geometries;
  // Of the geometries; None: of spheres and of what bounds media, too.
  std::vector<PlainModel> plain_models;
  std::vector<Object> objects;
  Object world;  // what is not instanced
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<CoverageGrid> coverage_grids;
  std::vector<Medium> media;
  std::vector<MediumBoundary> medium_boundaries;  // by material; empty where there are no media
  std::vector<Light> lights;
  LightSampler light_sampler;
  std::optional<Environment> environment;  // at most one
  // Its index in `lights`; none: light samples do not look for it.
  std::uint32_t environment_light = Light::none;
  Rgb ambient{0};  // whitted's and raster's unshadowed light from everywhere: radiance
  TextureStore textures;
  std::vector<Camera> cameras;

  Normalisation normalisation;
  Bounds3f bounds;  // of everything that rays can hit
  SceneFeatures features;
  std::vector<Dropped> dropped;
  std::vector<std::string> material_names;  // by material, for reports
};

// What a hit's surface is placed by; null: it lies in the world itself.
[[nodiscard]] inline const Instance* instance_of(const Scene& scene, const Hit& hit) {
  return hit.is_instanced() ? &scene.instances[hit.instance] : nullptr;
}

// Whether a surface parts two media, or is nothing but the boundary of one.
[[nodiscard]] inline bool bounds_media(const Scene& scene, MaterialHandle material) {
  if (scene.medium_boundaries.empty()) return false;
  const MediumBoundary& boundary = scene.medium_boundaries[material.index];
  return boundary.is_clear || boundary.is_transition();
}

}  // namespace candela
