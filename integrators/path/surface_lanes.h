// What paths met, once all of them are put into lanes: points, shading frames and what the
// materials say there.
#pragma once

#include "integrators/path/plain_lanes.h"

namespace candela {

// All on surfaces of one model.
void find_surfaces(PlainModel model, const Scene& scene, PlainLanes& lanes);

}  // namespace candela
