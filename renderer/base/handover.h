// What happens before what, for ThreadSanitizer, where work goes through a library's threads.
//
// ThreadSanitizer sees nothing of how oneTBB's and Embree's libraries, which are not instrumented,
// hand work over; this tells it. Elsewhere it is nothing. Sources that are not instrumented
// themselves are named in cmake/CompilerOptions.cmake.
#pragma once

#if defined(__SANITIZE_THREAD__) && !defined(CANDELA_THREAD_SANITIZER)
#define CANDELA_THREAD_SANITIZER
#endif
#if defined(CANDELA_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace candela {

// What was done before `begin` is seen by bodies between `enter` and `leave`, and what they did
// after `end`.
class Handover {
 public:
  void begin() { release(&begun_); }
  void enter() { acquire(&begun_); }
  void leave() { release(&done_); }
  void end() { acquire(&done_); }

 private:
#if defined(CANDELA_THREAD_SANITIZER)
  static void acquire(char* place) {
    __tsan_acquire(place);
  }
  static void release(char* place) {
    __tsan_release(place);
  }
#else
  static void acquire(char*) {}
  static void release(char*) {}
#endif
  char begun_ = 0;
  char done_ = 0;
};

}  // namespace candela
