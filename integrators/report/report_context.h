// What every path of the report's integrator reads, and its tile function (shade.h), which is
// compiled once an accelerator in report.cpp.
#pragma once

#include "integrators/path/context.h"
#include "integrators/report/emitter_table.h"
#include "integrators/tile_pass.h"
#include "renderer/accel/any_accel.h"

namespace candela {

template <class A>
struct ReportContext {
  PathContext<A> base;
  EmitterTable emitters;
  float p_rr;  // P_RR, in (0, 1]
};

template <class A>
[[nodiscard]] ReportContext<A> make_report_context(const Scene& scene, const A& accelerator,
                                                   const Filter& filter,
                                                   const RenderOptions& options) {
  return {make_path_context(scene, accelerator, filter, options), EmitterTable(scene),
          options.report_p_rr};
}

// The samples of a pass, in order.
template <class A>
TileCounts render_report_tile(const ReportContext<A>& context, const TilePass& pass, Film& film);

extern template TileCounts render_report_tile(const ReportContext<EmbreeAccel>&, const TilePass&,
                                              Film&);
extern template TileCounts render_report_tile(const ReportContext<BvhAccel>&, const TilePass&,
                                              Film&);

}  // namespace candela
