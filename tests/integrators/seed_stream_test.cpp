// Random numbers beside a picture's own.
#include "integrators/seed_stream.h"

#include <gtest/gtest.h>

#include <set>

namespace candela {
namespace {

TEST(Unit_SeedStream, NoStreamIsOneOfAnotherPicture) {
  std::set<std::uint64_t> seeds;
  constexpr std::uint64_t pictures = 1000;
  for (std::uint64_t seed = 0; seed < pictures; ++seed)
    for (const SeedStream stream :
         {SeedStream::LampPixels, SeedStream::GuideTraining, SeedStream::GuideTrial,
          SeedStream::Roulette, SeedStream::CloserLook, SeedStream::Reuse})
      seeds.insert(seed_of(stream, seed));
  EXPECT_EQ(seeds.size(), 6 * pictures);
}

}  // namespace
}  // namespace candela
