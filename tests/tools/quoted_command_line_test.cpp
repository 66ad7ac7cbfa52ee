#include "tools/candela/quoted_command_line.h"

#include <gtest/gtest.h>

namespace candela::cli {
namespace {

TEST(Unit_QuotedCommandLine, ReadsBackAsTheSameWords) {
  EXPECT_EQ(quoted_command_line({"render", "a b.yaml", "it's", "", "--size", "2x2"}),
            "candela render 'a b.yaml' 'it'\\''s' '' --size 2x2");
}

}  // namespace
}  // namespace candela::cli
