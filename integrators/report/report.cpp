#include "integrators/report/shade.h"

namespace candela {

template TileCounts render_report_tile(const ReportContext<EmbreeAccel>&, const PixelRect&,
                                       std::uint32_t, std::uint32_t, Film&);
template TileCounts render_report_tile(const ReportContext<BvhAccel>&, const PixelRect&,
                                       std::uint32_t, std::uint32_t, Film&);

}  // namespace candela
