#include "integrators/path/kernels.h"

namespace candela {

template TileCounts render_tile<media_features>(const PathContext<RecordingAccel<EmbreeAccel>>&,
                                                const TilePass&, Film&);

}  // namespace candela
