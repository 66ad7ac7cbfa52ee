#include "renderer/image/openimageio/module.h"

#include <OpenImageIO/imageio.h>

#include <string_view>

#include "renderer/image/codecs.h"
#include "renderer/image/openimageio/decode_file.h"
#include "renderer/image/openimageio/encode_file.h"

namespace candela {
namespace {

// One thread a call, since decoding runs on the renderer's own threads and `--threads` counts them;
// and no guessing: a file that its reader refuses is not tried on all others.
void set_up_openimageio() {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);  // -1: OpenEXR's pool stays empty, the caller works
  OIIO::attribute("try_all_readers", 0);
}

constexpr Codecs openimageio = {decode_file_header, decode_file, encode_file};

}  // namespace

extern "C" const Codecs* candela_codecs(const char* key) {
  if (std::string_view(key) != CANDELA_CODECS_KEY) return nullptr;
  set_up_openimageio();
  return &openimageio;
}

}  // namespace candela
