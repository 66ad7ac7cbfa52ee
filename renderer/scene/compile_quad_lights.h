// Emitting triangles that are one parallelogram -> one light that is picked in their place.
#pragma once

#include "renderer/scene/scene.h"

namespace candela {

// `by_solid_angle`: rectangles are sampled so where they are near, and what is skew stays two
// triangles. Readers cut polygons with four corners into two triangles that follow each other: only
// such pairs are looked at. Triangles with textures stay as they are. Appends to the light table.
void add_quad_lights(Scene& scene, bool by_solid_angle);

// Those that are left: by solid angle where they are near.
void sample_triangles_by_solid_angle(Scene& scene);

}  // namespace candela
