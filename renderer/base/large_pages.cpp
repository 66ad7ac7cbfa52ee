#include "renderer/base/large_pages.h"

#include <sys/mman.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cstdint>
#include <new>

namespace candela {
namespace {

constexpr std::uintptr_t page = std::uintptr_t{2} << 20;

std::uintptr_t next_multiple(std::uintptr_t address, std::uintptr_t unit) {
  return (address + unit - 1) / unit * unit;
}

}  // namespace

void advise_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = next_multiple(address, page);
  const std::uintptr_t end = (address + bytes) / page * page;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

// So many more that a whole number of large pages lies within.
PageRegion::PageRegion(std::size_t bytes) : mapped_bytes_(bytes + page) {
  void* mapped = mmap(nullptr, mapped_bytes_, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  mapped_ = static_cast<std::byte*>(mapped);
  const auto address = reinterpret_cast<std::uintptr_t>(mapped_);
  free_ = mapped_ + (next_multiple(address, page) - address);
  end_ = free_ + bytes;
  advise_large_pages(free_, bytes);
}

PageRegion::~PageRegion() {
  munmap(mapped_, mapped_bytes_);
}

std::byte* PageRegion::take(std::size_t bytes) {
  constexpr std::uintptr_t line = 64;
  const auto left = static_cast<std::size_t>(end_ - free_);
  if (bytes > left) return nullptr;
  std::byte* const taken = free_;
  free_ += std::min(left, next_multiple(bytes, line));
  return taken;
}

void forbid_large_pages() {
#ifdef PR_SET_THP_DISABLE
  prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
#endif
}

}  // namespace candela
