// The walks of one block of a pixel's samples, as they end.
#pragma once

#include <array>

#include "integrators/path_observer.h"
#include "integrators/roulette/walk.h"
#include "renderer/accel/ray_block.h"

namespace candela {

class WalkLog final : public PathObserver {
 public:
  void leave(std::uint32_t lane, const LeftSurface& left) override {
    left_[lane] = {left.roulette_throughput, left.survival};
  }
  void radiance_so_far(std::uint32_t lane, const Rgb& radiance) override {
    constexpr std::size_t most_steps = 256;  // in dense media paths may take thousands
    if (open_[lane].steps.size() == most_steps) return;
    left_[lane].radiance = radiance;
    open_[lane].steps.push_back(left_[lane]);
  }
  void meet(std::uint32_t, float) override {}
  // Of a lost path, which is counted as invalid and black, nothing is known.
  void end(std::uint32_t lane, const Rgb& radiance) override {
    open_[lane].radiance = radiance;
    if (is_finite(radiance)) walks_.push_back(std::move(open_[lane]));
    open_[lane] = {};
  }
  [[nodiscard]] std::vector<Walk>& walks() { return walks_; }

 private:
  std::array<WalkStep, block_size> left_;
  std::array<Walk, block_size> open_;
  std::vector<Walk> walks_;
};

}  // namespace candela
