#include "integrators/path/kernels.h"

namespace candela {

template TileCounts render_tile<media_lane_features>(const PathContext<EmbreeAccel>&,
                                                     const TilePass&, Film&);

}  // namespace candela
