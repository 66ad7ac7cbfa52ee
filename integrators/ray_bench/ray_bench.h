// `candela bench`: Embree against the reference BVH on the rays of real paths in one scene.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "integrators/ray_bench/record_rays.h"
#include "integrators/ray_bench/spread.h"
#include "renderer/accel/bvh_accel.h"

namespace candela {

struct RayBenchOptions {
  RecordOptions record;
  // Each class of rays is traced again by both back ends in turn until each thread has worked so
  // long for either, at least five times.
  double seconds_each = 0.5;
};

struct BackEndFigures {
  double build_seconds = 0;  // by all threads, by the clock on the wall
  std::size_t bytes = 0;
  // Million rays a second of CPU time by RayClass, the median of the rounds; 0 where there are none
  // of that class. By all threads: as if each had a processor of its own, sharing caches and memory
  // with the others.
  std::array<double, 3> mrays_one_thread{};
  std::array<double, 3> mrays_all_threads{};
};

// How many rays the back ends answer differently. For camera and bounce rays their hits are
// compared (compare_hits.h), for shadow rays whether anything is hit, and where that differs the
// hits.
struct AgreementCounts {
  std::uint64_t rays = 0;
  std::uint64_t same_distance = 0;  // another primitive at the same distance
  std::uint64_t at_edge = 0;        // rounding decides, both are right
  std::uint64_t disagreeing = 0;    // one is wrong
};
AgreementCounts& operator+=(AgreementCounts& sum, const AgreementCounts& part);

struct RayBenchResult {
  std::string embree_version;  // "3.13.5"
  int threads = 0;
  std::uint64_t triangles = 0;                // in the scene's arrays, instances not multiplied
  std::array<std::uint64_t, 3> ray_counts{};  // by RayClass
  BackEndFigures embree;
  BackEndFigures bvh;
  std::array<Spread, 3> embree_over_bvh{};  // rays a second of one thread, by RayClass, of rounds
  AgreementCounts agreement;
};

// On `threads` threads (0: as many as the process may use). Throws std::bad_alloc as the
// accelerators do.
[[nodiscard]] RayBenchResult run_ray_bench(const Scene& scene, const RayBenchOptions& options,
                                           int threads);

// Compares the two back ends over rays on the current arena's threads; is_shadow: by occlusion.
[[nodiscard]] AgreementCounts count_agreement(const Scene& scene, const EmbreeAccel& embree,
                                              const BvhAccel& bvh, const std::vector<Ray>& rays,
                                              bool is_shadow);

}  // namespace candela
