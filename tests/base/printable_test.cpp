#include "renderer/base/printable.h"

#include <gtest/gtest.h>

#include "renderer/base/diagnostic.h"

namespace candela {
namespace {

TEST(Unit_Printable, ReplacesWhatTerminalsWouldObeyAndWhatIsNoUtf8) {
  EXPECT_EQ(printable("plain, \xC3\xA9 and \xF0\x9F\x92\xA1"),
            "plain, \xC3\xA9 and \xF0\x9F\x92\xA1");
  EXPECT_EQ(printable("a\x1b]0;x\a\n\x7f"), "a?]0;x???");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J \xC2\xA0"),
            "?2J \xC2\xA0");
  EXPECT_EQ(printable("\xFF\xC3", ' '), "  ");
  EXPECT_EQ(printable(""), "");
}

// Whatever name a scene's file gives to its parts.
TEST(Unit_Printable, DiagnosticsAre) {
  Diagnostics diagnostics;
  diagnostics.warning({std::make_shared<const std::string>("a\x1b.yaml"), 1, 2},
                      "material 'floor\x1b' is used by no model");
  EXPECT_EQ(to_string(diagnostics.list()[0]),
            "a?.yaml:1:2: warning: material 'floor?' is used by no model");
}

}  // namespace
}  // namespace candela
