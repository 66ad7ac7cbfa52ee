#include "integrators/ray_bench/ray_bench.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include "integrators/ray_bench/compare_hits.h"
#include "renderer/base/parallel.h"
#include "renderer/base/thread_clock.h"

namespace candela {
namespace {

constexpr std::size_t rays_per_task = 4096;

double wall_seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Returns how many rays hit something, so that no call can be left out as unused.
template <Accelerator A>
std::uint64_t trace(const A& accelerator, const std::vector<Ray>& rays, bool is_shadow,
                    std::size_t begin, std::size_t end) {
  std::uint64_t hits = 0;
  for (std::size_t i = begin; i < end; ++i)
    hits += is_shadow ? accelerator.occluded(rays[i]) : accelerator.intersect(rays[i]).is_hit();
  return hits;
}

double cpu_seconds_of(const auto& work) {
  const double start = thread_cpu_seconds();
  work();
  return thread_cpu_seconds() - start;
}

// Of all threads together, by round.
struct CpuSeconds {
  std::vector<double> embree, bvh;
};

// A B A B, so that what disturbs one back end disturbs the other; until each thread has worked
// `seconds_each` for either.
CpuSeconds rounds_in_turn(int threads, double seconds_each, const auto& embree, const auto& bvh) {
  CpuSeconds rounds;
  double total = 0;
  for (int round = 0; round < 5 || total < 2 * seconds_each * threads; ++round) {
    rounds.embree.push_back(embree());
    rounds.bvh.push_back(bvh());
    total += rounds.embree.back() + rounds.bvh.back();
  }
  return rounds;
}

// Million rays a second if each thread had a processor of its own all the time.
double median_mrays(std::size_t rays, int threads, const std::vector<double>& cpu_seconds) {
  return static_cast<double>(rays) * threads / spread_of(cpu_seconds).median * 1e-6;
}

Spread embree_over_bvh(const CpuSeconds& rounds) {
  std::vector<double> ratios(rounds.embree.size());
  std::ranges::transform(rounds.bvh, rounds.embree, ratios.begin(), std::divides<>());
  return spread_of(std::move(ratios));
}

double cpu_seconds_of_all_threads(std::size_t rays, const auto& cpu_seconds) {
  std::atomic<double> sum = 0;
  parallel_for_chunks(rays, rays_per_task,
                      [&](std::size_t begin, std::size_t end) { sum += cpu_seconds(begin, end); });
  return sum.load();
}

void measure(const EmbreeAccel& embree, const BvhAccel& bvh, const RecordedRays& rays,
             double seconds_each, RayBenchResult& result) {
  std::atomic<std::uint64_t> hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::size_t count = rays[i].size();
    if (count == 0) continue;
    const bool is_shadow = static_cast<RayClass>(i) == RayClass::Shadow;
    const auto tracing = [&](const auto& accelerator) {
      return [&, is_shadow](std::size_t begin, std::size_t end) {
        return cpu_seconds_of([&] { hits += trace(accelerator, rays[i], is_shadow, begin, end); });
      };
    };
    const auto by_embree = tracing(embree);
    const auto by_bvh = tracing(bvh);
    const CpuSeconds alone = rounds_in_turn(
        1, seconds_each, [&] { return by_embree(0, count); }, [&] { return by_bvh(0, count); });
    const CpuSeconds together = rounds_in_turn(
        result.threads, seconds_each, [&] { return cpu_seconds_of_all_threads(count, by_embree); },
        [&] { return cpu_seconds_of_all_threads(count, by_bvh); });
    result.embree.mrays_one_thread[i] = median_mrays(count, 1, alone.embree);
    result.bvh.mrays_one_thread[i] = median_mrays(count, 1, alone.bvh);
    result.embree.mrays_all_threads[i] = median_mrays(count, result.threads, together.embree);
    result.bvh.mrays_all_threads[i] = median_mrays(count, result.threads, together.bvh);
    result.embree_over_bvh[i] = embree_over_bvh(alone);
  }
}

void count(Agreement agreement, AgreementCounts& counts) {
  switch (agreement) {
    case Agreement::Same:
      return;
    case Agreement::SameDistance:
      ++counts.same_distance;
      return;
    case Agreement::AtTheEdge:
      ++counts.at_edge;
      return;
    case Agreement::Differs:
      ++counts.disagreeing;
      return;
  }
}

Agreement compare_occlusion(const Scene& scene, const EmbreeAccel& embree, const BvhAccel& bvh,
                            const Ray& ray) {
  if (embree.occluded(ray) == bvh.occluded(ray)) return Agreement::Same;
  const Agreement hits = compare_hits(scene, ray, embree.intersect(ray), bvh.intersect(ray));
  // Where the nearest hits agree all the same, one back end's two answers contradict each other.
  return hits == Agreement::AtTheEdge ? hits : Agreement::Differs;
}

}  // namespace

AgreementCounts& operator+=(AgreementCounts& sum, const AgreementCounts& part) {
  sum.rays += part.rays;
  sum.same_distance += part.same_distance;
  sum.at_edge += part.at_edge;
  sum.disagreeing += part.disagreeing;
  return sum;
}

AgreementCounts count_agreement(const Scene& scene, const EmbreeAccel& embree, const BvhAccel& bvh,
                                const std::vector<Ray>& rays, bool is_shadow) {
  AgreementCounts sum;
  std::mutex mutex;
  parallel_for_chunks(rays.size(), rays_per_task, [&](std::size_t begin, std::size_t end) {
    AgreementCounts part{.rays = end - begin};
    for (std::size_t i = begin; i < end; ++i) {
      const Ray& ray = rays[i];
      count(is_shadow ? compare_occlusion(scene, embree, bvh, ray)
                      : compare_hits(scene, ray, embree.intersect(ray), bvh.intersect(ray)),
            part);
    }
    const std::lock_guard lock(mutex);
    sum += part;
  });
  return sum;
}

namespace {

RayBenchResult run_in_arena(const Scene& scene, const RayBenchOptions& options, int threads) {
  RayBenchResult result;
  result.threads = threads;
  result.embree_version = embree_version();
  for (const Geometry& geometry : scene.geometries) result.triangles += geometry.triangles.size();

  std::optional<EmbreeAccel> embree;
  std::optional<BvhAccel> bvh;
  result.embree.build_seconds = wall_seconds_of([&] { embree.emplace(scene); });
  result.bvh.build_seconds = wall_seconds_of([&] { bvh.emplace(scene); });
  result.embree.bytes = embree->memory_bytes();
  result.bvh.bytes = bvh->memory_bytes();

  const RecordedRays rays = record_rays(scene, *embree, options.record);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    result.ray_counts[i] = rays[i].size();
    const bool is_shadow = static_cast<RayClass>(i) == RayClass::Shadow;
    result.agreement += count_agreement(scene, *embree, *bvh, rays[i], is_shadow);
  }
  measure(*embree, *bvh, rays, options.seconds_each, result);
  return result;
}

}  // namespace

RayBenchResult run_ray_bench(const Scene& scene, const RayBenchOptions& options, int threads) {
  RayBenchResult result;
  const int count = threads > 0 ? threads : available_threads();
  with_threads(count, [&] { result = run_in_arena(scene, options, count); });
  return result;
}

}  // namespace candela
