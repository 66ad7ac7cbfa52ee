// Floating-point traps, in builds that ask for them (CANDELA_FLOATING_POINT_TRAPS, by the preset
// `sanitize`): invalid operations and divisions by zero end the program where they happen, and not
// where the NaN or infinity that they make is seen. In other builds nothing is left of this.
#pragma once

#if defined(CANDELA_FLOATING_POINT_TRAPS)
#include <xmmintrin.h>
#endif

namespace candela {

enum class Traps : bool { Off, On };

// For this thread, until the end of the scope (without_traps() in parallel.h: for what a library
// does in threads, too). On: our own code (with_threads() in parallel.h sees to it). Off: calls of
// libraries, which may raise the flags in good order, and what of ours means to divide by zero or
// to look at a NaN.
class FloatingPointTraps {
 public:
#if defined(CANDELA_FLOATING_POINT_TRAPS)
  explicit FloatingPointTraps(Traps traps) : masks_before_(_mm_getcsr() & masks) {
    set(traps == Traps::On ? 0 : masks);
  }
  ~FloatingPointTraps() {
    set(masks_before_);
  }
#else
  explicit FloatingPointTraps(Traps /*traps*/) {}
  ~FloatingPointTraps() = default;
#endif
  FloatingPointTraps(const FloatingPointTraps&) = delete;
  FloatingPointTraps& operator=(const FloatingPointTraps&) = delete;

 private:
#if defined(CANDELA_FLOATING_POINT_TRAPS)
  static constexpr unsigned masks = _MM_MASK_INVALID | _MM_MASK_DIV_ZERO;  // masked: no trap
  static void set(unsigned masked) {
    _mm_setcsr((_mm_getcsr() & ~masks) | masked);
  }

  unsigned masks_before_;
#endif
};

}  // namespace candela
