// SceneDescription -> Scene: named pure steps, each in its own file of this folder.
#pragma once

#include <cstdint>

#include "renderer/base/result.h"
#include "renderer/description/scene_description.h"
#include "renderer/scene/scene.h"

namespace candela {

// How points on lamps are chosen: triangle by triangle, uniform by area; two that are one
// parallelogram as one quad; rectangles, and triangles that are not their halves, by solid angle
// where they are near.
enum class LightSampling : std::uint8_t { Triangles, Area, SolidAngle };

struct CompileOptions {
  int width = 512;  // the cameras' aspect
  int height = 512;
  // Factors of lab materials rounded to n/255, as the lab stores them (whitted, raster).
  bool lab_quantised = false;
  // Which triangles and hits count is decided by opacity, at compile time and by the accelerator.
  // false: all of them count, and the integrator looks at the opacity itself (whitted, raster).
  bool decides_cutouts = true;
  LightSampling light_sampling = LightSampling::Area;
  bool keeps_media = true;  // false: all is as clear as air
  // Whether light samples look for a constant environment, too. Where directions are drawn from
  // BSDFs these find it as well, and a shadow ray less a hit is worth more than the second sample.
  bool samples_constant_sky = true;
  // Whether directions from BSDFs find the sky as well as light samples do (sky_distribution.h).
  bool compensates_sky = false;
  // Whether lights are picked by what they may send to where they are asked for (light_cells.h).
  bool light_cells = false;
  // Whether cut-outs have grids that tell where their opacity is 0 or 1 (coverage_grid.h).
  bool opacity_grids = true;
};

// Validates, then compiles. Errors name the file and line of what cannot be rendered.
[[nodiscard]] Result<Scene> compile(const description::SceneDescription& description,
                                    const CompileOptions& options);

}  // namespace candela
