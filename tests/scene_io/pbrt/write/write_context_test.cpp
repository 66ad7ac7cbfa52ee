#include "scene_io/pbrt/write/write_context.h"

#include <gtest/gtest.h>

#include "renderer/base/thread_clock.h"

namespace candela::pbrt {
namespace {

TEST(Unit_WriteContext, StemsAreNamesWithoutTheirExtensions) {
  EXPECT_EQ(stem_of("a/white oak.yaml"), "white_oak");
  EXPECT_EQ(stem_of("a/white_oak.yaml.gz"), "white_oak");
  EXPECT_EQ(stem_of("C:\\meshes\\ball.ply.GZ"), "ball");
  EXPECT_EQ(stem_of("a/ball.1.ply"), "ball_1");
  EXPECT_EQ(stem_of(""), "unnamed");
}

// At once, however many there are: each begins where the last one ended.
TEST(Unit_WriteContext, NamesThatAreTakenAreNumbered) {
  const description::SceneDescription scene;
  const WriteOptions options;
  WrittenScene written;
  Diagnostics diagnostics;
  WriteContext context{scene, options, written, diagnostics};
  EXPECT_EQ(context.unique_name("file", "a-3.png"), "a-3.png");
  EXPECT_EQ(context.unique_name("file", "a.png"), "a.png");
  EXPECT_EQ(context.unique_name("texture", "a.png"), "a.png");
  EXPECT_EQ(context.unique_name("file", "a.png"), "a-2.png");
  EXPECT_EQ(context.unique_name("file", "a.png"), "a-4.png");
  std::set<std::string> names;
  constexpr std::size_t many = 50'000;
  const double start = thread_cpu_seconds();
  for (std::size_t i = 0; i < many; ++i) names.insert(context.unique_name("material", "m"));
  EXPECT_EQ(names.size(), many);
  EXPECT_LT(thread_cpu_seconds() - start, 10);
}

}  // namespace
}  // namespace candela::pbrt
