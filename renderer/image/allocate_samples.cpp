#include <cstring>

#include "renderer/base/large_pages.h"
#include "renderer/image/decode.h"

namespace candela {

std::unique_ptr<std::byte[]> allocate_samples(const ImageHeader& header) {
  const std::size_t bytes = header.sample_count() * size_of(header.sample_type);
  auto samples = std::make_unique_for_overwrite<std::byte[]>(bytes + sizeof(float));
  advise_large_pages(samples.get(), bytes);
  std::memset(samples.get() + bytes, 0, sizeof(float));
  return samples;
}

}  // namespace candela
