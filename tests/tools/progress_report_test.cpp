#include "tools/candela/progress_report.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/tools/run_program.h"

namespace candela::cli {
namespace {

using namespace std::chrono_literals;

TEST(Unit_ProgressReport, OneHundredPercentIsNotForIt) {
  EXPECT_EQ(percent_text({0, 1000, 1}), "0.0 %");
  EXPECT_EQ(percent_text({423, 1000, 1}), "42.3 %");
  EXPECT_EQ(percent_text({1000, 1000, 1}), "99.9 %");
  EXPECT_EQ(percent_text({0, 0, 1}), "0.0 %");
}

TEST(Unit_ProgressReport, DurationsReadAsClocks) {
  EXPECT_EQ(duration_text(0), "0:00");
  EXPECT_EQ(duration_text(65), "1:05");
  EXPECT_EQ(duration_text(7384), "2:03:04");
  EXPECT_EQ(duration_text(-1), "0:00");
}

TEST(Unit_ProgressReport, ALineTellsElapsedLeftAndRate) {
  EXPECT_EQ(progress_line({25'000'000, 100'000'000, 10}),
            "25.0 %, 0:10 elapsed, 0:30 left, 2.50 Msamples/s");
  EXPECT_EQ(progress_line({25'000'000, 100'000'000, 10, StatedError{.0211, .0194, .0226}}),
            "25.0 %, 0:10 elapsed, 0:30 left, 2.50 Msamples/s, error 2.1 % (1.9 to 2.3)");
  EXPECT_EQ(progress_line({25'000'000, 100'000'000, 10, StatedError{.996, .994, 1.2}}),
            "25.0 %, 0:10 elapsed, 0:30 left, 2.50 Msamples/s, error 100 % (99 to 120)");
  EXPECT_EQ(progress_line({25'000'000, 100'000'000, 10, std::nullopt, true}),
            "25.0 %, 0:10 elapsed, 0:30 left, 2.50 Msamples/s, no light met yet");
  EXPECT_EQ(progress_line({0, 100, 0}), "0.0 %, 0:00 elapsed, ? left, 0.00 Msamples/s");
}

TEST(Unit_ProgressReport, TheBarFitsTheTerminal) {
  const ProgressState half{50, 100, 10};
  for (std::size_t columns = 1; columns < 200; ++columns)
    EXPECT_LT(progress_bar(half, columns).size(), columns) << columns;
  const std::string bar = progress_bar(half, 200);
  EXPECT_EQ(std::count(bar.begin(), bar.end(), '#'), 20);
}

TEST(Unit_ProgressReport, ReportsNowAndThenAndStops) {
  const std::string path = cli_test::fresh_folder("progress") + "/lines";
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  Console console(false, file);
  {
    ProgressReport report(console, 5ms);
    report.expect(100);
    report.advance(50);
    const auto is_told = [&] {
      return cli_test::file_text(path).find("50.0 %") != std::string::npos;
    };
    for (int i = 0; i < 60'000 && !is_told(); ++i) std::this_thread::sleep_for(1ms);
    EXPECT_TRUE(is_told());
  }
  const std::string text = cli_test::file_text(path);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(cli_test::file_text(path), text);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(text.back(), '\n');
  ::close(file);
}

TEST(Unit_ProgressReport, IsSilentWhenQuiet) {
  const std::string path = cli_test::fresh_folder("progress_quiet") + "/lines";
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  Console console(true, file);
  ProgressReport report(console, 1ms);
  report.advance(50);
  std::this_thread::sleep_for(20ms);
  report.stop();
  console.note("nothing");
  EXPECT_EQ(cli_test::file_text(path), "");
  console.warning("something");
  EXPECT_EQ(cli_test::file_text(path), "warning: something\n");
  ::close(file);
}

}  // namespace
}  // namespace candela::cli
