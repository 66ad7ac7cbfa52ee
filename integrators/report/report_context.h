// What every path of the report's integrator reads, and its tile function (shade.h), which is
// compiled once an accelerator in report.cpp.
#pragma once

#include "integrators/path/context.h"
#include "integrators/report/emitter_table.h"

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

// Samples [first_sample, end_sample) of each pixel of the tile, in order.
template <class A>
TileCounts render_report_tile(const ReportContext<A>& context, const PixelRect& tile,
                              std::uint32_t first_sample, std::uint32_t end_sample, Film& film);

extern template TileCounts render_report_tile(const ReportContext<EmbreeAccel>&, const PixelRect&,
                                              std::uint32_t, std::uint32_t, Film&);
extern template TileCounts render_report_tile(const ReportContext<BvhAccel>&, const PixelRect&,
                                              std::uint32_t, std::uint32_t, Film&);

}  // namespace candela
