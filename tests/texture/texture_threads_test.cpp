// First touch from many threads at once: one decoding, and the same answer for all.
#include <gtest/gtest.h>

#include <barrier>
#include <thread>

#include "renderer/image/image_io.h"
#include "renderer/texture/texture.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

// 32x32 and RGBA; every kind whose decoder has state of its own.
std::string put_picture(const TemporaryFolder& folder, int index) {
  const char* const extensions[3] = {"png", "exr", "tif"};
  Image image(32, 32, {"R", "G", "B", "A"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] =
        static_cast<float>((i * 7 + static_cast<std::size_t>(index) * 11) % 256) / 255;
  const std::string path = folder.file(fmt::format("{}.{}", index, extensions[index % 3]));
  EXPECT_FALSE(write_image(path, image, {}).has_errors());
  return path;
}

TEST(Stress_Texture, FirstTouchFromManyThreadsAtOnce) {
  constexpr int threads = 8, files = 12, rounds = 8;
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  for (int i = 0; i < files; ++i) paths.push_back(put_picture(folder, i));
  for (int round = 0; round < rounds; ++round) {
    TextureStore store;
    Diagnostics diagnostics;
    std::vector<TextureHandle> handles;
    for (const std::string& path : paths)
      for (const Encoding encoding : {Encoding::Linear, Encoding::Srgb})
        handles.push_back(store.add({path, encoding, Wrap::Repeat, {}}, diagnostics));
    std::vector<std::vector<float>> sums(threads);
    std::barrier start(threads);
    std::vector<std::thread> workers;
    for (int t = 0; t < threads; ++t)
      workers.emplace_back([&, t] {
        start.arrive_and_wait();
        for (const TextureHandle handle : handles) {
          const Vec2f(&uv)[3] = {{0.1f, 0.1f}, {0.9f, 0.2f}, {0.3f, 0.8f}};
          sums[static_cast<std::size_t>(t)].push_back(store.lookup(handle, {0.37f, 0.61f}).x +
                                                      store.range_in_triangle(handle, uv, 3).low +
                                                      (store.is_decoded(handle) ? 1.0f : 0.0f));
        }
      });
    for (std::thread& worker : workers) worker.join();
    for (const std::vector<float>& sum : sums) EXPECT_EQ(sum, sums[0]);
    EXPECT_EQ(store.decoded_bytes(), std::size_t{files / 3} * 32 * 32 * 4 * (1 + 4 + 4));
  }
}

}  // namespace
}  // namespace candela
