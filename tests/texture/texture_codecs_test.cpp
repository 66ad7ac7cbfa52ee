// What decodes images comes with the scene, so that no ray waits for it.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "renderer/image/decode.h"
#include "renderer/image/openimageio/module.h"
#include "renderer/texture/texture.h"

namespace candela {
namespace {

bool codecs_are_loaded() {
  void* const module = dlopen(codecs_file, RTLD_LAZY | RTLD_NOLOAD);
  if (module != nullptr) dlclose(module);
  return module != nullptr;
}

// A JPEG's header needs no codecs, its samples do.
TEST(Unit_TextureCodecs, AreLoadedWhenAnImageIsAdded) {
  if (codecs_are_loaded()) GTEST_SKIP() << "an earlier test of this process has loaded them";
  const std::string path = CANDELA_SOURCE_DIR "/tests/fuzz/corpus/jpeg/rgb.jpg";
  ASSERT_TRUE(read_image_header(path, DecodeLimits{}));
  EXPECT_FALSE(codecs_are_loaded());
  Diagnostics diagnostics;
  TextureStore().add({path, Encoding::Srgb, Wrap::Repeat, {}}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  EXPECT_TRUE(codecs_are_loaded());
}

}  // namespace
}  // namespace candela
