// Small files of every kind, written by OpenImageIO.
#pragma once

#include <OpenImageIO/imageio.h>

#include <map>
#include <string>

#include "tests/image/crafted_files.h"

namespace candela {

// What a writer of OpenImageIO is asked for; attributes by its names.
struct Encoding {
  std::string format, compression;
  OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
  int channels = 3;
  int tile = 0;
  std::map<std::string, std::string> attributes = {};
  int left = 0, top = 0;  // of the part that is there in the full picture
};

// 24 x 20 pixels.
[[nodiscard]] crafted::Bytes encoded(const Encoding& encoding);

// By names with the extensions that they should have.
[[nodiscard]] std::map<std::string, crafted::Bytes> sample_files();

}  // namespace candela
