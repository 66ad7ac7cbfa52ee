#include "scene_io/lab3/yaml_tree.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using lab3::Document;
using lab3::Node;
using test::error_in;
using test::warning_in;

std::optional<Document> parse(const text::Source& source) {
  Diagnostics diagnostics;
  return lab3::parse_yaml(source, diagnostics);
}

std::string repeated(std::string_view what, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += what;
  return text;
}

// Ten times ten times ... : 10^8 values in eight lines.
std::string billion_laughs() {
  std::string text = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
  for (char name = 'b'; name <= 'i'; ++name) {
    const std::string alias = fmt::format("*{}, ", static_cast<char>(name - 1));
    text += fmt::format("{}: &{} [{}*{}]\n", name, name, repeated(alias, 9),
                        static_cast<char>(name - 1));
  }
  return text;
}

TEST(Unit_YamlTree, KnowsThePlaceOfEveryNode) {
  const text::Source source = text::make_source("a.yaml", "first: 1\nsecond:\n  - [x, 'y z']\n");
  const auto document = parse(source);
  ASSERT_TRUE(document);
  const Node& root = *document->root;
  ASSERT_TRUE(root.is_map());
  ASSERT_EQ(root.entries.size(), 2u);
  EXPECT_EQ(root.entries[0].key, "first");
  EXPECT_EQ(root.entries[0].value->text, "1");
  EXPECT_EQ(root.entries[0].value->offset, 7u);
  EXPECT_EQ(root.entries[1].key_offset, 9u);
  const Node& inner = *root.entries[1].value->entries[0].value;
  ASSERT_TRUE(inner.is_sequence());
  EXPECT_EQ(inner.entries[1].value->text, "y z");
  EXPECT_EQ(inner.entries[1].value->offset, 25u);
}

TEST(Unit_YamlTree, KnowsPlacesInFilesWithForeignLineEnds) {
  const text::Source source = text::make_source("a.yaml", "a: 1\r\nb: [2,\r\n  3]\r\n");
  const auto document = parse(source);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->root->entries[1].value->entries[1].value->offset, 16u);
}

TEST(Unit_YamlTree, KeepsBothOfEqualKeys) {
  const text::Source source = text::make_source("a.yaml", "a: 1\na: 2\n");
  const auto document = parse(source);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->root->entries.size(), 2u);
}

TEST(Unit_YamlTree, FollowsAliases) {
  const text::Source source = text::make_source("a.yaml", "a: &x [1, 2]\nb: *x\n");
  const auto document = parse(source);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->root->entries[0].value, document->root->entries[1].value);
  EXPECT_EQ(document->root->expanded_nodes, 1u + 3u + 3u);
  EXPECT_EQ(document->root->height, 3u);
}

TEST(Errors_YamlTree, MalformedTexts) {
  EXPECT_EQ(error_in(""), "1:1: the file is empty, expected a scene");
  EXPECT_EQ(error_in("# nothing\n"), "1:1: the file is empty, expected a scene");
  EXPECT_EQ(error_in("a: [1, 2\nb: }\n"),
            "2:2: malformed YAML: end of sequence flow not found, expected ']' or ','");
  EXPECT_EQ(error_in("a: {b: 1\nc]\n"), "2:2: malformed YAML: illegal flow end");
  EXPECT_EQ(error_in("Cameras: 1\n\tLights: 2\n"),
            "2:1: malformed YAML: illegal tab when looking for indentation; indent with blanks");
  EXPECT_EQ(error_in("Render:\n\tWidth: 3\n"),
            "2:7: malformed YAML: illegal map value behind a tab; indent with blanks");
  EXPECT_EQ(error_in("Render:\n  Width: 3: 4\t\n"),
            "2:11: malformed YAML: illegal map value; what holds ': ' is written in quotes");
  EXPECT_EQ(error_in("Cameras:\n-\tEye: [0, 0, 1]\n"),
            "2:6: malformed YAML: illegal map value behind a tab; indent with blanks");
  EXPECT_EQ(error_in("Materials:\n- Name: @a\n"),
            "2:9: malformed YAML: unknown token; what begins with '@' or '`' is written in quotes");
  EXPECT_EQ(error_in("Lights:\n  - Type: Point\n Position: [1, 2, 3]\n"),
            "3:2: malformed YAML: end of map not found, expected a key as far in as those above");
  EXPECT_EQ(error_in("Lights:\n- Type: Point\n Intensity: 3\n"),
            "3:2: malformed YAML: end of sequence not found, expected '-' or a key as far in as "
            "those above");
  EXPECT_EQ(error_in("Materials:\n  - Name: 'it's'\n"),
            "2:15: malformed YAML: end of map not found: expected the line's end behind a value "
            "(quotes within quotes are written twice)");
  EXPECT_EQ(error_in("Lights: *sun\n"),
            "1:9: malformed YAML: the referenced anchor is not defined");
  EXPECT_EQ(error_in("[a, b]: 1\n"), "1:1: found a value where the name of a key was expected");
  EXPECT_EQ(error_in("- a\n- b\n"), "1:1: found a list of 2 values, expected the keys of a scene");
  EXPECT_EQ(error_in("hello\n"), "1:1: found 'hello', expected the keys of a scene");
}

TEST(Errors_YamlTree, EmptyEntriesOfListsStandAtTheirDashes) {
  const auto empty = [](std::string_view place) {
    return fmt::format("{}: found nothing, expected the keys of a material", place);
  };
  EXPECT_EQ(error_in("Materials:\n  - Name: a\n  -\n  - Name: b\n"), empty("3:3"));
  EXPECT_EQ(error_in("Materials:\n  - Name: a\n  - # - none\n# - more - \n\nLights: []\n"),
            empty("3:3"));
  EXPECT_EQ(error_in("Materials:\n-\n"), empty("2:1"));
  EXPECT_EQ(error_in("Materials:\r\n  -\r\n\r\n"), empty("2:3"));
  EXPECT_EQ(error_in("Materials:\n  - ~\n"), empty("2:3"));
  EXPECT_EQ(error_in("Cameras:\n  - Eye:\n    - - 1\n      -\n      - 3\n"),
            "3:7: Eye: found a list of 3 values, expected a number");
}

TEST(Errors_YamlTree, UnclosedQuotes) {
  EXPECT_EQ(error_in("Models:\n  - Mesh: \"tri.obj\n    Material: a\n"),
            "2:11: this quote is not closed, expected the same mark behind its text");
  EXPECT_EQ(error_in("Models:\n  - Mesh: 'it''s\n"),
            "2:11: this quote is not closed, expected the same mark behind its text");
  EXPECT_EQ(error_in("Environment: {Map: \"sky.hdr}\n\n"),
            "1:20: this quote is not closed, expected the same mark behind its text");
  EXPECT_EQ(error_in("Cameras: [{Eye: 'far}]\n"),
            "1:17: this quote is not closed, expected the same mark behind its text");
  EXPECT_EQ(error_in("'Lights: 5\n"),
            "1:1: this quote is not closed, expected the same mark behind its text");
  for (const char* before : {"!!str ", "&a ", "!!str  &a "})
    EXPECT_NE(error_in(std::string("A: 1\nB: ") + before + "\"a\nC: []\n").find("is not closed"),
              std::string::npos)
        << before;
  EXPECT_EQ(error_in("Lights: \"a \\\" b\"\n"), "1:9: Lights: found 'a \" b', expected a list");
  EXPECT_EQ(error_in("Lights: 'a '' b'"), "1:9: Lights: found 'a ' b', expected a list");
  EXPECT_EQ(error_in("Lights: \"a\n  b\"\n"), "1:9: Lights: found 'a b', expected a list");
}

TEST(Errors_YamlTree, BinaryFiles) {
  EXPECT_EQ(error_in(std::string_view("Cameras:\0", 9)),
            "1:9: found the byte 0x00, expected a text file");
  EXPECT_EQ(error_in("a: 1\n\x7f"), "2:1: found the byte 0x7f, expected a text file");
}

TEST(Errors_YamlTree, NestingWithoutEnd) {
  EXPECT_EQ(error_in("Lights: " + repeated("[", 60000)),
            "1:25: values are nested more than 32 levels deep");
  EXPECT_EQ(error_in(repeated("- ", 30000)), "1:65: values are nested more than 32 levels deep");
  EXPECT_EQ(error_in("Lights: &a [*a]\n"),
            "1:13: found an alias of the node that it stands in, which has no end");
  std::string chain = "a: &a0 [1]\n";
  for (int i = 1; i < 40; ++i) chain += fmt::format("a{}: &a{} [*a{}]\n", i, i, i - 1);
  EXPECT_EQ(error_in(chain),
            "31:6: values are nested more than 32 levels deep, once aliases are followed");
}

TEST(Errors_YamlTree, AliasBombs) {
  EXPECT_EQ(error_in(billion_laughs()),
            "6:44: the file stands for more than 1048576 values, once its aliases are followed");
}

TEST(Errors_YamlTree, FilesWithoutEnd) {
  EXPECT_EQ(error_in("a: " + repeated("x", 70000)), "1:1: this line has more than 65536 bytes");
  EXPECT_EQ(error_in(repeated("#\n", 9000000)),
            "1:1: the file has 18000000 bytes, more than the 16777216 that are read");
}

// Four seconds of yaml-cpp: the most that a file within the limits can take.
TEST(Errors_YamlTree, MoreValuesThanAreRead) {
  if (!std::getenv("CANDELA_HEAVY")) GTEST_SKIP() << "only with CANDELA_HEAVY=1";
  const std::string line = "- [" + repeated("1,", 10000) + "1]\n";
  EXPECT_EQ(error_in(repeated(line, 110)), "105:16736: the file has more than 1048576 values");
}

TEST(Unit_YamlTree, ReadsTheFirstDocumentOnly) {
  EXPECT_EQ(warning_in("AmbientIntensity: [0, 0, 0]\n---\nLights: 5\n"),
            "2:1: a second document begins here: only the first is read");
}

TEST(Unit_YamlTree, TakesAByteOrderMark) {
  EXPECT_EQ(error_in("\xef\xbb\xbfLights: 5\n"), "1:9: Lights: found '5', expected a list");
}

TEST(Unit_YamlTree, CountsColumnsInCharacters) {
  EXPECT_EQ(error_in("Lights: {\"\xc3\xa9\xc3\xa9\": 1}\nCameras: 5\n"),
            "2 of them: 2:10: Cameras: "
            "found '5', expected a list | 1:9: Lights: found a map of keys, expected a list");
  EXPECT_EQ(error_in("Materials: [{Name: \"\xc3\xa9\xc3\xa9\", Diffuse: 5}]\n"),
            "1:35: Diffuse: found '5', expected a list of 3 or 4 numbers, such as [5, 5, 5]");
}

}  // namespace
}  // namespace candela
