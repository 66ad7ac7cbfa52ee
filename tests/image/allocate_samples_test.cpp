#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "renderer/image/decode.h"

namespace candela {
namespace {

ImageHeader grey(int width, int height) {
  ImageHeader header;
  header.width = width;
  header.height = height;
  header.channels = {"Y"};
  header.sample_type = SampleType::U8;
  return header;
}

// Of small images, some that share a region, more than one holds, and some with their own.
TEST(Unit_AllocateSamples, ImagesKeepWhatIsWrittenWhileOthersComeAndGo) {
  struct Picture {
    std::shared_ptr<std::byte[]> samples;
    std::size_t bytes;
    std::byte value;
  };
  std::mt19937 random(1);
  std::vector<Picture> pictures;
  for (int i = 0; i < 200; ++i) {
    const int side = std::array{16, 300, 1000, 2000, 4000}[random() % 5];
    const auto bytes = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    Picture made{allocate_samples(grey(side, side)), bytes, static_cast<std::byte>(i)};
    EXPECT_EQ(made.samples[bytes], std::byte{0}) << "the spare sample";
    std::memset(made.samples.get(), i, bytes);
    pictures.push_back(std::move(made));
    if (pictures.size() > 20)
      pictures.erase(pictures.begin() + static_cast<std::ptrdiff_t>(random() % pictures.size()));
    for (const Picture& picture : pictures)
      for (const std::size_t at : {std::size_t{0}, picture.bytes / 3, picture.bytes - 1})
        ASSERT_EQ(picture.samples[at], picture.value);
  }
}

}  // namespace
}  // namespace candela
