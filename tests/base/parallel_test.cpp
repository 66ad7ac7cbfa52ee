#include "renderer/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <thread>
#include <vector>

namespace candela {
namespace {

std::vector<std::size_t> squares(std::size_t count) {
  std::vector<std::size_t> values(count);
  parallel_for(count, [&](std::size_t i) { values[i] += i * i; });
  return values;
}

// What workers wrote without locks is seen by the caller afterwards, for any number of threads.
TEST(Agreement_Parallel, EveryIndexRunsOnceForAnyNumberOfThreads) {
  std::vector<std::size_t> expected(10'000);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = i * i;
  for (const int threads : {1, 2, 3, 7}) {
    std::vector<std::size_t> values;
    with_threads(threads, [&] { values = squares(expected.size()); });
    EXPECT_EQ(values, expected) << threads << " threads";
  }
}

TEST(Agreement_Parallel, ChunksCoverTheRangeWithoutOverlap) {
  std::vector<int> visits(1003);
  with_threads(3, [&] {
    parallel_for_chunks(visits.size(), 10, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
  });
  EXPECT_EQ(visits, std::vector<int>(1003, 1));
}

// Each of two pieces waits until the other runs as well.
bool run_at_once() {
  std::atomic<int> running = 0;
  std::atomic<bool> have_met = false;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  parallel_for(2, [&](std::size_t) {
    if (++running == 2) have_met = true;
    while (!have_met && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    --running;
  });
  return have_met;
}

TEST(Unit_Parallel, AnArenaOfOneThreadLeavesOthersTheirs) {
  if (available_threads() < 2) GTEST_SKIP() << "one processor";
  bool is_inner_parallel = false;
  with_threads(1, [&] { with_threads(2, [&] { is_inner_parallel = run_at_once(); }); });
  EXPECT_TRUE(is_inner_parallel);
}

// oneTBB warns where it is asked for more threads than another arena's limit lets it have.
TEST(Unit_Parallel, ArenasOfSeveralSizesAtOnceAreQuiet) {
  const int few = available_threads() + 1;
  testing::internal::CaptureStderr();
  std::latch are_all_there(2);
  std::jthread other([&] {
    with_threads(few, [&] {
      are_all_there.arrive_and_wait();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    });
  });
  with_threads(few + 5, [&] {
    are_all_there.arrive_and_wait();
    EXPECT_EQ(squares(10'000).back(), 9999u * 9999u);
  });
  other.join();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Unit_Parallel, NothingToDoIsFine) {
  std::atomic<int> calls = 0;
  parallel_for(0, [&](std::size_t) { ++calls; });
  parallel_for_chunks(0, 16, [&](std::size_t, std::size_t) { ++calls; });
  EXPECT_EQ(calls, 0);
}

bool keeps_denormals() {
  volatile float smallest = 1.2e-38f;
  return smallest * 0.5f != 0.0f;
}

// Also the first time, when oneTBB makes its threads, and for nested loops; afterwards the caller's
// own mode is back.
TEST(Unit_Parallel, WorkersFlushDenormalsToZero) {
  ASSERT_TRUE(keeps_denormals());
  for (const int threads : {3, 1, 2}) {
    std::atomic<int> kept = 0;
    with_threads(threads, [&] {
      kept += keeps_denormals();
      parallel_for(100, [&](std::size_t) {
        kept += keeps_denormals();
        parallel_for(10, [&](std::size_t) { kept += keeps_denormals(); });
      });
    });
    EXPECT_EQ(kept, 0) << threads << " threads";
    EXPECT_TRUE(keeps_denormals());
  }
}

TEST(Unit_Parallel, WorkersKeepDenormalsWhereAsked) {
  std::atomic<int> kept = 0;
  with_threads(
      3, [&] { parallel_for(100, [&](std::size_t) { kept += keeps_denormals(); }); },
      Denormals::Kept);
  EXPECT_EQ(kept, 100);
}

}  // namespace
}  // namespace candela
