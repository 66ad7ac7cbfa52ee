// What decodes unusual images comes with the scene, so that no ray waits for it; usual ones do
// without.
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

TEST(Unit_TextureCodecs, AreLoadedWhenAnUnusualImageIsAdded) {
  if (codecs_are_loaded()) GTEST_SKIP() << "an earlier test of this process has loaded them";
  const std::string corpus = CANDELA_SOURCE_DIR "/tests/fuzz/corpus/";
  for (const char* usual : {"png/palette.png", "png/interlaced.png", "jpeg/rgb.jpg",
                            "jpeg/grey.jpg", "exr/zip.exr", "exr/tiled.exr", "pnm/float.pfm"}) {
    ASSERT_TRUE(read_decoded_image(corpus + usual, DecodeLimits{})) << usual;
    EXPECT_FALSE(codecs_are_loaded()) << usual;
  }
  Diagnostics broken;
  TextureStore().add({corpus + "png/none.png", Encoding::Srgb, Wrap::Repeat, {}}, broken);
  EXPECT_FALSE(broken.has_errors());
  EXPECT_FALSE(codecs_are_loaded()) << "for a file that is not there";
  Diagnostics diagnostics;
  TextureStore().add({corpus + "jpeg/cmyk.jpg", Encoding::Srgb, Wrap::Repeat, {}}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  EXPECT_TRUE(codecs_are_loaded());
}

}  // namespace
}  // namespace candela
