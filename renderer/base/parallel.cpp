#include "renderer/base/parallel.h"

#include <latch>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/handover.h"

namespace candela {
namespace {

// FTZ and DAZ on this thread, until the end of the scope. An arena that is made meanwhile hands
// them to its workers: oneTBB notes the floating-point mode of the thread that makes an arena and
// sets it before each of the arena's tasks (so an observer that sets it on a worker's entry does
// nothing).
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() {
    _mm_setcsr(before_);
  }
#else
  FlushDenormals() = default;
  ~FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  [[maybe_unused]] unsigned before_ = 0;
};

// Lets oneTBB have more threads than there are processors. Of all controls it takes the least: so
// there is one for the process, of the most threads that are wanted at the moment.
class MoreThreads {
 public:
  explicit MoreThreads(int count) : count_(static_cast<std::size_t>(count)) {
    const std::lock_guard lock(mutex_);
    wanted_.insert(count_);
    allow();
  }
  ~MoreThreads() {
    const std::lock_guard lock(mutex_);
    wanted_.erase(wanted_.find(count_));
    allow();
  }
  MoreThreads(const MoreThreads&) = delete;
  MoreThreads& operator=(const MoreThreads&) = delete;

 private:
  // The next is there before the last goes, so that none has fewer threads in between.
  static void allow() {
    std::unique_ptr<tbb::global_control> next;
    if (!wanted_.empty())
      next = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                   *wanted_.rbegin());
    control_ = std::move(next);
  }

  static inline std::mutex mutex_;
  static inline std::multiset<std::size_t> wanted_;
  static inline std::unique_ptr<tbb::global_control> control_;
  std::size_t count_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  Handover handover;
  handover.begin();
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    handover.enter();
    body(i);
    handover.leave();
  });
  handover.end();
}

void parallel_for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t, std::size_t)>& body) {
  Handover handover;
  handover.begin();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      handover.enter();
                      body(range.begin(), range.end());
                      handover.leave();
                    });
  handover.end();
}

// Where the system allows no more threads oneTBB's workers end the process: asked before, it is an
// exception.
void require_threads(int count) {
  std::latch may_end(1);
  std::vector<std::jthread> others;
  struct Release {
    std::latch& latch;
    ~Release() { latch.count_down(); }
  } const release{may_end};
  for (int i = 1; i < count; ++i) others.emplace_back([&] { may_end.wait(); });
}

void with_threads(int threads, const std::function<void()>& work, Denormals denormals) {
  const int count = threads > 0 ? threads : available_threads();
  require_threads(count);
  std::optional<MoreThreads> more;
  if (count > available_threads()) more.emplace(count);
  std::optional<FlushDenormals> flush;
  if (denormals == Denormals::Flushed) flush.emplace();
  const FloatingPointTraps traps(Traps::On);  // in the arena's workers likewise
  tbb::task_arena arena(count);
  arena.execute(work);
}

void without_traps(const std::function<void()>& work) {
#if defined(CANDELA_FLOATING_POINT_TRAPS)
  const FloatingPointTraps traps(Traps::Off);
  tbb::task_arena arena(tbb::this_task_arena::max_concurrency());
  arena.execute(work);
#else
  work();
#endif
}

int available_threads() {
  return tbb::info::default_concurrency();
}

}  // namespace candela
