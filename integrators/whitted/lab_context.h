// What every sample of whitted and raster reads.
#pragma once

#include <vector>

#include "integrators/render_options.h"
#include "renderer/camera/camera.h"
#include "renderer/light/light.h"
#include "renderer/scene/scene.h"

namespace candela {

// What tells whitted and raster apart beside their walks, and what the user may choose.
struct LabRules {
  int max_depth = default_whitted_depth;
  SpecularModel specular = SpecularModel::Blinn;
  bool shadows = true;
  bool bump = false;         // the lab's rasteriser reads height maps, its ray tracer does not
  bool lab_normals = false;  // RenderOptions::lab_normals
};

template <class A>
struct LabContext {
  const Scene& scene;
  const A& accelerator;
  const Camera& camera;
  const RenderOptions& options;
  LabRules rules;
  std::vector<Light> lights;  // lab_lights
  bool has_holes = true;      // some surface may let shadow rays through
};

}  // namespace candela
