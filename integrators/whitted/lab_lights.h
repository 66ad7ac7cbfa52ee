// The lights of lab3's own shading (docs/cli.md, "Whitted and raster"): points, cones and
// directions only.
#pragma once

#include <vector>

#include "renderer/light/light.h"
#include "renderer/scene/scene.h"

namespace candela {

// Delta lights whose `emission` is what the lab calls Intensity: it lights a surface of albedo kd
// with kd I cos / r^2, without the 1 / pi of kd / pi, so I is the radiant intensity over pi (and
// the irradiance over pi of directional lights).
//
// Each lamp mesh (a geometry that emits) becomes a point light at its centroid that shines alike in
// all directions and has the same intensity far away along the lamp's axis; `geometry` tells its
// mesh, which does not stand in its way. The environment is not among them: see Scene::ambient.
[[nodiscard]] std::vector<Light> lab_lights(const Scene& scene);

}  // namespace candela
