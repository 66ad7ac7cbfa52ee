// Types of samples in OpenImageIO's words.
#pragma once

#include <OpenImageIO/typedesc.h>

#include "renderer/image/decode.h"

namespace candela {

// Those that are not kept as they are become floats.
[[nodiscard]] inline SampleType sample_type_of(OIIO::TypeDesc type) {
  if (type == OIIO::TypeDesc::UINT8) return SampleType::U8;
  if (type == OIIO::TypeDesc::UINT16) return SampleType::U16;
  if (type == OIIO::TypeDesc::HALF) return SampleType::Half;
  return SampleType::Float;
}

[[nodiscard]] inline OIIO::TypeDesc type_desc_of(SampleType type) {
  switch (type) {
    case SampleType::U8:
      return OIIO::TypeDesc::UINT8;
    case SampleType::U16:
      return OIIO::TypeDesc::UINT16;
    case SampleType::Half:
      return OIIO::TypeDesc::HALF;
    case SampleType::Float:
      return OIIO::TypeDesc::FLOAT;
  }
  return OIIO::TypeDesc::FLOAT;
}

}  // namespace candela
