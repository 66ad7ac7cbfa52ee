#include "integrators/path/kernels.h"

namespace candela {

template TileCounts render_tile<general_features>(const PathContext<RecordingAccel<EmbreeAccel>>&,
                                                  const PixelRect&, std::uint32_t, std::uint32_t,
                                                  Film&);

}  // namespace candela
