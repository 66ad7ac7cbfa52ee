#include <cstring>
#include <mutex>

#include "renderer/base/large_pages.h"
#include "renderer/image/decode.h"

namespace candela {
namespace {

// Under the address sanitizer each image has memory of its own, so that it sees the ends.
#if defined(CANDELA_ADDRESS_SANITIZER)
constexpr bool shares_regions = false;
#else
constexpr bool shares_regions = true;
#endif

constexpr std::size_t small = std::size_t{64} << 10;  // those stay in the processor's caches
constexpr std::size_t region_bytes = std::size_t{32} << 20;
constexpr std::size_t large = region_bytes / 4;

std::shared_ptr<std::byte[]> in_own_region(std::size_t bytes) {
  const auto region = std::make_shared<PageRegion>(bytes);
  return {region, region->take(bytes)};
}

// The region goes with the last of its images.
std::shared_ptr<std::byte[]> in_shared_region(std::size_t bytes) {
  static std::mutex mutex;
  static std::weak_ptr<PageRegion> latest;
  const std::lock_guard lock(mutex);
  if (const auto region = latest.lock())
    if (std::byte* const place = region->take(bytes)) return {region, place};
  const auto region = std::make_shared<PageRegion>(region_bytes);
  latest = region;
  return {region, region->take(bytes)};
}

std::shared_ptr<std::byte[]> memory_of(std::size_t bytes) {
  if (!shares_regions || bytes < small) return std::make_shared_for_overwrite<std::byte[]>(bytes);
  return bytes > large ? in_own_region(bytes) : in_shared_region(bytes);
}

}  // namespace

std::shared_ptr<std::byte[]> allocate_samples(const ImageHeader& header) {
  const std::size_t bytes = header.sample_count() * size_of(header.sample_type);
  auto samples = memory_of(bytes + sizeof(float));
  std::memset(samples.get() + bytes, 0, sizeof(float));
  return samples;
}

}  // namespace candela
