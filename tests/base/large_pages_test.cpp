#include "renderer/base/large_pages.h"

#include <gtest/gtest.h>

#include <cstddef>
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

}  // namespace
}  // namespace candela
