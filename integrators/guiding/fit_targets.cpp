#include "integrators/guiding/fit_targets.h"

#include <algorithm>
#include <vector>

namespace candela {
namespace {

constexpr std::size_t fewest_records = 4;   // of a cluster
constexpr double narrowest_radians = 0.03;  // finer directions are not to be had from so few

// A record as seen from the cell's middle.
struct Sight {
  Vec3f direction;  // unit
  float nearness;   // inverse of the distance
  float weight;
};
using Sights = std::span<Sight>;

Sight see(const Vec3f& from, const TrainingRecord& record) {
  const Vec3f away = record.target - from;
  const float nearness = 1 / (std::sqrt(dot(away, away)) + 1e-9f);
  return {away * nearness, nearness, record.weight};
}

// Records whose light came from about the same place.
struct Cluster {
  Sights sights;
  double weight = 0;
  Vec3d target{0};
  double distance = 0;  // of it
  double angle2 = 0;    // mean square of the records' angle from it
  int axis = 0;         // along which the directions differ most
  double middle = 0;    // of them there
};

// Means are by weight, that of distances by their inverse: of angles that they make.
Cluster cluster_of(Sights sights, const Vec3d& from) {
  Cluster cluster{.sights = sights};
  Vec3d sum(0), squares(0);
  double nearness = 0;
  for (const Sight& sight : sights) {
    const Vec3d direction(sight.direction);
    const double weight = sight.weight;
    cluster.weight += weight;
    sum += direction * weight;
    squares += direction * direction * weight;
    nearness += sight.nearness * weight;
  }
  const Vec3d mean = sum / cluster.weight;
  const Vec3d variance = squares / cluster.weight - mean * mean;
  cluster.angle2 = std::max(variance.x + variance.y + variance.z, 0.0);
  cluster.axis = max_axis(variance);
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
    if (cluster->sights.size() < 2 * fewest_records || !(width > most)) continue;
    most = width;
    found = cluster;
  }
  return found;
}

std::vector<Cluster> clusters_of(Sights sights, const Vec3d& from) {
  std::vector<Cluster> clusters{cluster_of(sights, from)};
  while (clusters.size() < mixture_size) {
    const auto wide = widest(clusters);
    if (wide == clusters.end()) break;
    const Cluster whole = *wide;
    const auto upper = std::partition(
        whole.sights.begin(), whole.sights.end(),
        [&](const Sight& sight) { return sight.direction[whole.axis] < whole.middle; });
    const auto count = static_cast<std::size_t>(upper - whole.sights.begin());
    if (count == 0 || count == whole.sights.size()) {  // by rounding
      wide->angle2 = 0;
      continue;
    }
    *wide = cluster_of(whole.sights.first(count), from);
    clusters.push_back(cluster_of(whole.sights.subspan(count), from));
  }
  return clusters;
}

Vec3d middle_of(std::span<const TrainingRecord> records) {
  Vec3d sum(0);
  for (const TrainingRecord& record : records) sum += Vec3d(record.position);
  return sum / static_cast<double>(records.size());
}

}  // namespace

TargetMixture fit_targets(std::span<const TrainingRecord> records) {
  const Vec3d from = middle_of(records);
  std::vector<Sight> sights;
  sights.reserve(records.size());
  for (const TrainingRecord& record : records) sights.push_back(see(Vec3f(from), record));
  const std::vector<Cluster> clusters = clusters_of(sights, from);
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
