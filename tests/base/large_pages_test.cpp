#include "renderer/base/large_pages.h"

#include <gtest/gtest.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cstddef>
#include <cstdlib>
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
