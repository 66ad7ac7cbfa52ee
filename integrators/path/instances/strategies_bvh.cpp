#include "integrators/path/kernels.h"

namespace candela {

template TileCounts render_tile<strategy_features>(const PathContext<BvhAccel>&, const PixelRect&,
                                                   std::uint32_t, std::uint32_t, Film&);

}  // namespace candela
