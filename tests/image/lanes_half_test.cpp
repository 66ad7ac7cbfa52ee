// Four 16-bit floats at once against one at a time.
#include "renderer/image/lanes_half.h"

#include <gtest/gtest.h>

#include "renderer/base/parallel.h"
#include "renderer/image/half.h"

namespace candela {
namespace {

// Each finite value in each lane, beside others.
int differing_lanes() {
  int differing = 0;
  for (std::uint32_t bits = 0; bits < 0x10000u; ++bits) {
    if ((bits & 0x7C00u) == 0x7C00u) continue;  // infinities and what is no number
    for (int lane = 0; lane < 4; ++lane) {
      Half4 halves{0x3C00, 0xBC00, 0x0001, 0x7BFF};
      halves[lane] = static_cast<std::uint16_t>(bits);
      const Float4 found = half_to_float(halves);
      for (int i = 0; i < 4; ++i)
        differing += std::bit_cast<std::uint32_t>(found[i]) !=
                             std::bit_cast<std::uint32_t>(half_to_float(std::uint16_t{halves[i]}))
                         ? 1
                         : 0;
    }
  }
  return differing;
}

TEST(Unit_LanesHalf, AreTheBitsOfSingleOnes) {
  EXPECT_EQ(differing_lanes(), 0);
}

// As workers do, who flush denormals to zero.
TEST(Unit_LanesHalf, AreTheSameOnWorkers) {
  int differing = -1;
  with_threads(1, [&] { differing = differing_lanes(); });
  EXPECT_EQ(differing, 0);
}

}  // namespace
}  // namespace candela
