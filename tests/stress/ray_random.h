// Random numbers of one ray, by its index: the same for any number of threads.
#pragma once

#include <cstdint>

#include "renderer/math/vec.h"
#include "renderer/sampling/hash.h"

namespace candela::test {

class RayRandom {
 public:
  explicit RayRandom(std::uint64_t ray) : key_(mix_bits(ray ^ 0x2545f4914f6cdd1dull)) {}

  std::uint32_t bits() { return static_cast<std::uint32_t>(hash_counter(key_, count_++) >> 32); }
  float uniform() { return unit_float(bits()); }
  // [-1, 1]^3
  Vec3f in_cube() {
    const float x = 2 * uniform() - 1;
    const float y = 2 * uniform() - 1;
    const float z = 2 * uniform() - 1;
    return {x, y, z};
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d d(in_cube());
      const double length2 = dot(d, d);
      if (length2 > 0.01 && length2 <= 1) return d / std::sqrt(length2);
    }
  }

 private:
  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace candela::test
