#include "integrators/guiding/fit_targets.h"

#include <algorithm>
#include <vector>

namespace candela {
namespace {

constexpr std::size_t fewest_records = 4;   // of a cluster
constexpr double narrowest_radians = 0.03;  // finer directions are not to be had from so few

using Records = std::span<TrainingRecord>;

struct Sight {
  Vec3d direction;  // unit
  double distance;
};

Sight see(const Vec3d& from, const TrainingRecord& record) {
  const Vec3d away = Vec3d(record.target) - from;
  const double distance = std::sqrt(dot(away, away)) + 1e-9;
  return {away / distance, distance};
}

// Records whose light came from about the same place.
struct Cluster {
  Records records;
  double weight = 0;
  Vec3d target{0};
  double distance = 0;  // of it
  double angle2 = 0;    // mean square of the records' angle from it
  int axis = 0;         // along which the directions differ most
  double middle = 0;    // of them there
};

int largest_axis(const Vec3d& v) {
  if (v.x >= v.y) return v.x >= v.z ? 0 : 2;
  return v.y >= v.z ? 1 : 2;
}

// Means are by weight, that of distances by their inverse: of angles that they make.
Cluster cluster_of(Records records, const Vec3d& from) {
  Cluster cluster{.records = records};
  Vec3d sum(0), squares(0);
  double nearness = 0;
  for (const TrainingRecord& record : records) {
    const Sight seen = see(from, record);
    cluster.weight += record.weight;
    sum += seen.direction * double{record.weight};
    squares += seen.direction * seen.direction * double{record.weight};
    nearness += record.weight / seen.distance;
  }
  const Vec3d mean = sum / cluster.weight;
  const Vec3d variance = squares / cluster.weight - mean * mean;
  cluster.angle2 = std::max(variance.x + variance.y + variance.z, 0.0);
  cluster.axis = largest_axis(variance);
  cluster.middle = mean[cluster.axis];
  cluster.distance = cluster.weight / nearness;
  cluster.target = from + mean * (cluster.distance / (std::sqrt(dot(mean, mean)) + 1e-9));
  return cluster;
}

// The cluster that is worth most to be halved; the end where none can be.
std::vector<Cluster>::iterator widest(std::vector<Cluster>& clusters) {
  auto found = clusters.end();
  double most = 0;
  for (auto cluster = clusters.begin(); cluster != clusters.end(); ++cluster) {
    const double width = cluster->weight * cluster->angle2;
    if (cluster->records.size() < 2 * fewest_records || !(width > most)) continue;
    most = width;
    found = cluster;
  }
  return found;
}

std::vector<Cluster> clusters_of(Records records, const Vec3d& from) {
  std::vector<Cluster> clusters{cluster_of(records, from)};
  while (clusters.size() < mixture_size) {
    const auto wide = widest(clusters);
    if (wide == clusters.end()) break;
    const Cluster whole = *wide;
    const auto upper = std::partition(
        whole.records.begin(), whole.records.end(), [&](const TrainingRecord& record) {
          return see(from, record).direction[whole.axis] < whole.middle;
        });
    const auto count = static_cast<std::size_t>(upper - whole.records.begin());
    if (count == 0 || count == whole.records.size()) {  // by rounding
      wide->angle2 = 0;
      continue;
    }
    *wide = cluster_of(whole.records.first(count), from);
    clusters.push_back(cluster_of(whole.records.subspan(count), from));
  }
  return clusters;
}

Vec3d middle_of(Records records) {
  Vec3d sum(0);
  for (const TrainingRecord& record : records) sum += Vec3d(record.position);
  return sum / static_cast<double>(records.size());
}

}  // namespace

TargetMixture fit_targets(std::span<TrainingRecord> records) {
  const std::vector<Cluster> clusters = clusters_of(records, middle_of(records));
  double total = 0;
  for (const Cluster& cluster : clusters) total += cluster.weight;
  TargetMixture mixture;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Cluster& cluster = clusters[i];
    const double radians = std::max(std::sqrt(cluster.angle2), narrowest_radians);
    const double spread = radians * cluster.distance;
    mixture.x.set(i, cluster.target.x);
    mixture.y.set(i, cluster.target.y);
    mixture.z.set(i, cluster.target.z);
    mixture.inverse_spread2.set(i, 2 / (spread * spread));
    mixture.weight.set(i, cluster.weight / total);
  }
  return mixture;
}

}  // namespace candela
