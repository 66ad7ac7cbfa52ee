// Memory in large pages: fewer faults while it is filled, fewer entries of the page tables after.
#pragma once

#include <cstddef>

namespace candela {

// Asks the system to back what lies of [begin, begin + bytes) in whole 2 MB with large pages. A
// hint before first use: what is not granted stays as it is, and nothing grows.
void advise_large_pages(void* begin, std::size_t bytes);

// Address space that is taken piece by piece and freed as a whole. What is small shares large pages
// with its neighbours, which on its own it would not fill; pages that nothing touches take no
// memory.
class PageRegion {
 public:
  explicit PageRegion(std::size_t bytes);  // throws std::bad_alloc
  ~PageRegion();
  PageRegion(const PageRegion&) = delete;
  PageRegion& operator=(const PageRegion&) = delete;

  // From a cache line's beginning on; null where too little is left.
  [[nodiscard]] std::byte* take(std::size_t bytes);

 private:
  std::byte* mapped_;
  std::size_t mapped_bytes_;
  std::byte* free_;  // from here on nothing is taken
  std::byte* end_;
};

// From now on this process gets small pages alone, whatever is asked for; for comparisons.
void forbid_large_pages();

}  // namespace candela
