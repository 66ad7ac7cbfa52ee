// Memory in large pages: fewer faults while it is filled, fewer entries of the page tables after.
#pragma once

#include <cstddef>

namespace candela {

// Asks the system to back what lies of [begin, begin + bytes) in whole 2 MB with large pages. A
// hint before first use: what is not granted stays as it is, and nothing grows.
void advise_large_pages(void* begin, std::size_t bytes);

// From now on this process gets small pages alone, whatever is asked for; for comparisons.
void forbid_large_pages();

}  // namespace candela
