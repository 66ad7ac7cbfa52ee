#include "integrators/report/shade.h"

namespace candela {

template TileCounts render_report_tile(const ReportContext<EmbreeAccel>&, const TilePass&, Film&);
template TileCounts render_report_tile(const ReportContext<BvhAccel>&, const TilePass&, Film&);

}  // namespace candela
