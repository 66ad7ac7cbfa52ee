// What training paths brought, vertex by vertex: by lane while they are on their way, as records
// when they have ended.
#pragma once

#include <array>
#include <vector>

#include "integrators/guiding/guiding_field.h"
#include "renderer/accel/ray_block.h"
#include "renderer/math/colour.h"

namespace candela {

class TrainingLog {
 public:
  // The path in a lane leaves a surface along `ray`. `throughput`: as it came there.
  void leave(std::uint32_t lane, const Ray& ray, const Vec3f& receiving_normal, float pdf,
             float bsdf_pdf, const Rgb& throughput) {
    Vertex vertex;
    vertex.record.position = ray.origin;
    vertex.record.target = ray.direction;
    vertex.record.pdf = pdf;
    vertex.record.bsdf_pdf = bsdf_pdf;
    vertex.record.throughput = max_component(throughput);
    vertex.record.receiving_normal = receiving_normal;
    vertex.throughput = throughput;
    open_[lane].push_back(vertex);
  }
  // Its radiance so far: what comes later came from the direction.
  void had(std::uint32_t lane, const Rgb& radiance) {
    if (Vertex* vertex = last_unmet(lane)) vertex->radiance = radiance;
  }
  // Where the ray ended; infinite where it left the scene.
  void meet(std::uint32_t lane, float distance) {
    constexpr float far = 1e3f;  // scenes are about of size 1
    if (Vertex* vertex = last_unmet(lane)) {
      vertex->record.target =
          vertex->record.position + vertex->record.target * std::min(distance, far);
      vertex->has_met = true;
    }
  }
  // The path has ended with so much radiance in all.
  void end(std::uint32_t lane, const Rgb& radiance) {
    for (Vertex& vertex : open_[lane]) {
      const Rgb brought = (radiance - vertex.radiance) / vertex.throughput;
      vertex.record.weight = sum_of(brought);
      if (vertex.has_met && vertex.record.weight > 0) records_.push_back(vertex.record);
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
