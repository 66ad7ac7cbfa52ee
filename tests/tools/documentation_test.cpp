// docs/cli.md and --help name the same options, command by command.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/tools/run_program.h"
#include "tools/candela/parse_arguments.h"

namespace candela::cli_test {
namespace {

using Options = std::set<std::string>;

Options options_in(const std::string& text) {
  static const std::regex option("(^|[\\s,`])(--?[a-z][a-z0-9-]*)");
  Options options;
  for (std::sregex_iterator match(text.begin(), text.end(), option), end; match != end; ++match)
    options.insert((*match)[2]);
  return options;
}

// The first column of the option tables, by the heading above: "candela render" -> options.
std::map<std::string, Options> documented(const std::string& page) {
  std::map<std::string, Options> sections;
  std::string section = "candela";
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) section = line.substr(3);
    if (!line.starts_with("| `-")) continue;
    const Options row = options_in(line.substr(0, line.find("` |") + 1));
    sections[section].insert(row.begin(), row.end());
  }
  return sections;
}

std::string help_of(const std::vector<std::string>& words) {
  return cli::parse_arguments(words).output;
}

// The lines of --help that begin with an option.
Options offered(const std::vector<std::string>& words) {
  Options options;
  std::istringstream lines(help_of(words));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  -")) continue;
    const Options row = options_in(line.substr(0, line.find("  ", 2)));
    options.insert(row.begin(), row.end());
  }
  return options;
}

std::string page() {
  return file_text(std::string(CANDELA_SOURCE_DIR) + "/docs/cli.md");
}

TEST(Unit_Documentation, HelpAndPageNameTheSameOptions) {
  const std::map<std::string, Options> sections = documented(page());
  ASSERT_EQ(sections.size(), 7u);
  for (const auto& [section, options] : sections) {
    std::vector<std::string> arguments{"--help"};
    if (section != "candela") arguments.insert(arguments.begin(), section.substr(8));
    EXPECT_EQ(offered(arguments), options) << section;
  }
}

TEST(Unit_Documentation, EveryCommandOfTheHelpIsOnThePage) {
  const std::string help = help_of({"--help"});
  const std::map<std::string, Options> sections = documented(page());
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ")) continue;
    EXPECT_EQ(sections.count("candela " + line.substr(2, line.find(' ', 2) - 2)), 1u) << line;
    ++count;
  }
  EXPECT_EQ(count, 6);
}

// What the comparison above rests on.
TEST(Unit_Documentation, OptionsAreFoundInRowsAndHelpLines) {
  EXPECT_EQ(options_in("-o,--output FILE ..."), (Options{"-o", "--output"}));
  EXPECT_EQ(options_in("| `-h`, `--help`"), (Options{"-h", "--help"}));
  EXPECT_EQ(documented("## a\n| `--x-y N\\|none` | off | with --z |\n")["a"], Options{"--x-y"});
  EXPECT_EQ(options_in("mid-word and - alone"), Options{});
}

TEST(Unit_Documentation, EveryExitCodeIsOnThePage) {
  for (const char* code : {"0", "1", "2", "3", "4", "5", "6", "130"})
    EXPECT_NE(page().find("\n| " + std::string(code) + " | "), std::string::npos) << code;
}

TEST(Unit_Documentation, TheProgramPrintsHelpAndVersion) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"render", "--help"}, {"compare", "--version"}}) {
    const ProgramResult result = run_candela(words);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.output, help_of(words));
  }
  EXPECT_EQ(help_of({"--version"}), "candela " CANDELA_VERSION "\n");
  EXPECT_EQ(help_of({"info", "--version"}), "candela " CANDELA_VERSION "\n");
}

}  // namespace
}  // namespace candela::cli_test
