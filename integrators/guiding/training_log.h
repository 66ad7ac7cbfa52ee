// What training paths brought, vertex by vertex: by lane while they are on their way, as records
// when they have ended. Nothing is learned of lobes that have but one direction.
#pragma once

#include <array>
#include <vector>

#include "integrators/guiding/guiding_field.h"
#include "integrators/path_observer.h"
#include "renderer/accel/ray_block.h"
#include "renderer/base/floating_point_traps.h"

namespace candela {

class TrainingLog final : public PathObserver {
 public:
  void leave(std::uint32_t lane, const LeftSurface& left) override {
    if (left.is_delta) return;
    Vertex vertex;
    vertex.record.position = left.ray.origin;
    vertex.record.target = left.ray.direction;
    vertex.record.pdf = left.pdf;
    vertex.record.bsdf_pdf = left.bsdf_pdf;
    vertex.record.throughput = max_component(left.throughput_before);
    vertex.record.receiving_normal = left.receiving_normal;
    vertex.throughput = left.throughput_before;
    open_[lane].push_back(vertex);
  }
  // What comes later came from the direction.
  void radiance_so_far(std::uint32_t lane, const Rgb& radiance) override {
    if (Vertex* vertex = last_unmet(lane)) vertex->radiance = radiance;
  }
  void meet(std::uint32_t lane, float distance) override {
    constexpr float far = 1e3f;  // scenes are about of size 1
    if (Vertex* vertex = last_unmet(lane)) {
      vertex->record.target =
          vertex->record.position + vertex->record.target * std::min(distance, far);
      vertex->has_met = true;
    }
  }
  void end(std::uint32_t lane, const Rgb& radiance) override {
    const FloatingPointTraps traps(Traps::Off);  // of channels that a path has lost
    for (Vertex& vertex : open_[lane]) {
      const Rgb brought = (radiance - vertex.radiance) / vertex.throughput;
      vertex.record.weight = sum_of(brought);
      const bool is_apart = vertex.record.target != vertex.record.position;  // else no direction
      if (vertex.has_met && is_apart && vertex.record.weight > 0) records_.push_back(vertex.record);
    }
    open_[lane].clear();
  }
  [[nodiscard]] std::vector<TrainingRecord>& records() { return records_; }

 private:
  struct Vertex {
    TrainingRecord record;
    Rgb throughput{0};
    Rgb radiance{0};
    bool has_met = false;
  };
  [[nodiscard]] Vertex* last_unmet(std::uint32_t lane) {
    if (open_[lane].empty() || open_[lane].back().has_met) return nullptr;
    return &open_[lane].back();
  }
  // Of the channels that reach the camera.
  [[nodiscard]] static float sum_of(const Rgb& brought) {
    float sum = 0;
    for (int c = 0; c < 3; ++c)
      if (std::isfinite(brought[c])) sum += brought[c];
    return sum;
  }

  std::array<std::vector<Vertex>, block_size> open_;
  std::vector<TrainingRecord> records_;
};

}  // namespace candela
