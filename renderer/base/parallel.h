// Threads: the only door to oneTBB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace candela {

// Runs `body(i)` for each i in [0, count), spread over the current arena's threads, in no order.
// Exceptions of a body leave here on the calling thread.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

// Runs `body(begin, end)` over chunks of [0, count): of at least half of `grain` items, or of all
// that there are.
void parallel_for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t, std::size_t)>& body);

// What becomes of denormal numbers: zero (FTZ and DAZ), as Embree asks for, or what IEEE 754 says,
// for comparisons.
enum class Denormals : std::uint8_t { Flushed, Kept };

// Runs `work` in an arena of `threads` threads (0: as many as the process may use), all of which
// treat denormal numbers alike. What `work` starts through parallel_for stays in that arena.
void with_threads(int threads, const std::function<void()>& work,
                  Denormals denormals = Denormals::Flushed);

// Runs `work` of a library that uses oneTBB itself, with floating-point traps
// (floating_point_traps.h) off in all threads. In builds without traps nothing but work().
void without_traps(const std::function<void()>& work);

// Throws std::system_error where the system does not allow so many threads, this one among them.
// with_threads() asks it for its own.
void require_threads(int count);

// The number of processors this process may run on.
[[nodiscard]] int available_threads();

}  // namespace candela
