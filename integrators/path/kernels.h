// The closed list of path kernels: one body (render_tile.h), one line an instance. Every instance
// is compiled in a file of its own under instances/.
#pragma once

#include <string_view>

#include "integrators/path/recording_accel.h"
#include "integrators/path/render_tile.h"
#include "renderer/accel/any_accel.h"

namespace candela {

template <class A>
using TileKernel = TileCounts (*)(const PathContext<A>&, const TilePass&, Film&);

extern template TileCounts render_tile<general_features>(const PathContext<EmbreeAccel>&,
                                                         const TilePass&, Film&);
extern template TileCounts render_tile<lane_features>(const PathContext<EmbreeAccel>&,
                                                      const TilePass&, Film&);
extern template TileCounts render_tile<media_lane_features>(const PathContext<EmbreeAccel>&,
                                                            const TilePass&, Film&);
extern template TileCounts render_tile<general_features>(const PathContext<BvhAccel>&,
                                                         const TilePass&, Film&);
extern template TileCounts render_tile<general_features>(
    const PathContext<RecordingAccel<EmbreeAccel>>&, const TilePass&, Film&);
extern template TileCounts render_tile<general_features>(
    const PathContext<RecordingAccel<BvhAccel>>&, const TilePass&, Film&);

extern template TileCounts render_tile<media_features>(const PathContext<EmbreeAccel>&,
                                                       const TilePass&, Film&);
extern template TileCounts render_tile<media_features>(const PathContext<BvhAccel>&,
                                                       const TilePass&, Film&);
extern template TileCounts render_tile<media_features>(
    const PathContext<RecordingAccel<EmbreeAccel>>&, const TilePass&, Film&);
extern template TileCounts render_tile<media_features>(const PathContext<RecordingAccel<BvhAccel>>&,
                                                       const TilePass&, Film&);

extern template TileCounts render_tile<strategy_features>(const PathContext<EmbreeAccel>&,
                                                          const TilePass&, Film&);
extern template TileCounts render_tile<strategy_features>(const PathContext<BvhAccel>&,
                                                          const TilePass&, Film&);

extern template TileCounts render_tile<guided_features>(const PathContext<EmbreeAccel>&,
                                                        const TilePass&, Film&);
extern template TileCounts render_tile<guided_features>(const PathContext<BvhAccel>&,
                                                        const TilePass&, Film&);

template <class A>
struct PathKernel {
  std::string_view name;
  TileKernel<A> render;
};

// For comparisons of estimators.
template <class A>
[[nodiscard]] PathKernel<A> strategy_kernel() {
  return {"strategies", &render_tile<strategy_features, A>};
}

// All that the scene needs, and perhaps more.
template <class A>
[[nodiscard]] PathKernel<A> general_kernel(const SceneFeatures& features) {
  if (features.media || features.spheres)
    return {features.media ? "media" : "spheres", &render_tile<media_features, A>};
  return {"general", &render_tile<general_features, A>};
}

// With lanes where the scene and the options allow. The reference BVH and the recorder have only
// those of general_kernel().
template <class A>
[[nodiscard]] PathKernel<A> select_path_kernel(const SceneFeatures& features,
                                               bool /*use_general*/) {
  return general_kernel<A>(features);
}
template <>
[[nodiscard]] inline PathKernel<EmbreeAccel> select_path_kernel(const SceneFeatures& features,
                                                                bool use_general) {
  // Of what is seen from within a medium much is within it: lanes would be for few paths there.
  if (use_general || features.cameras_in_media) return general_kernel<EmbreeAccel>(features);
  if (lane_features.covers(features)) return {"lanes", &render_tile<lane_features, EmbreeAccel>};
  return {"media_lanes", &render_tile<media_lane_features, EmbreeAccel>};
}

}  // namespace candela
