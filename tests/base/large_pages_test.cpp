#include "renderer/base/large_pages.h"

#include <gtest/gtest.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

namespace candela {
namespace {

// A hint: what was written before stays, wherever the memory begins and ends.
TEST(Unit_LargePages, LeaveWhatIsWritten) {
  std::vector<unsigned char> memory(std::size_t{9} << 20);
  for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<unsigned char>(i % 251);
  const std::size_t page = std::size_t{2} << 20;
  for (const std::size_t begin : {std::size_t{0}, std::size_t{1}, page - 1, page + 4097})
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, page, 3 * page + 5})
      advise_large_pages(memory.data() + begin, bytes);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < memory.size(); ++i)
    changed += static_cast<std::size_t>(memory[i] != i % 251);
  EXPECT_EQ(changed, 0u);
}

TEST(Unit_PageRegion, GivesPiecesThatDoNotOverlap) {
  constexpr std::size_t bytes = std::size_t{5} << 20;
  PageRegion region(bytes);
  std::vector<std::byte*> pieces;
  constexpr std::size_t piece = 100'001;
  for (std::byte* taken = region.take(piece); taken; taken = region.take(piece)) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(taken) % 64, 0u);
    std::memset(taken, static_cast<int>(pieces.size()), piece);
    pieces.push_back(taken);
  }
  EXPECT_EQ(pieces.size(), bytes / 100'032) << "with what cache lines round up";
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const std::size_t at : {std::size_t{0}, piece / 2, piece - 1})
      EXPECT_EQ(pieces[i][at], static_cast<std::byte>(i));
}

TEST(Unit_PageRegion, CanBeTakenToItsEnd) {
  PageRegion region(1000);
  EXPECT_EQ(region.take(1001), nullptr);
  std::byte* const all = region.take(1000);
  ASSERT_NE(all, nullptr);
  std::memset(all, 1, 1000);
  EXPECT_EQ(region.take(1), nullptr);
  EXPECT_THROW(PageRegion(std::size_t{1} << 60), std::bad_alloc);
}

#ifdef PR_GET_THP_DISABLE
// In a process of its own, since it is for good; without its end of the program, since a fork has
// none of the threads that it waits for.
TEST(Unit_LargePages, CanBeForbidden) {
  const auto forbidden = [] {
    forbid_large_pages();
    std::_Exit(prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0));
  };
  ASSERT_EQ(prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0), 0);
  EXPECT_EXIT(forbidden(), testing::ExitedWithCode(1), "");
}
#endif

}  // namespace
}  // namespace candela
