#include "scene_io/text/source.h"

#include <gtest/gtest.h>

#include "scene_io/text/cursor.h"

namespace candela::text {
namespace {

TEST(Unit_Source, LinesAndColumnsCountFromOneAndCharacters) {
  const std::string text = "one\ntwo gr\xC3\xB6sser x\n";
  const Source source = make_source("a", text);
  EXPECT_EQ(span_at(source, 0).line, 1u);
  EXPECT_EQ(span_at(source, 0).column, 1u);
  EXPECT_EQ(span_at(source, 3).column, 4u);
  EXPECT_EQ(span_at(source, 4).line, 2u);
  const SourceSpan x = span_at(source, text.find('x'));
  EXPECT_EQ(x.line, 2u);
  EXPECT_EQ(x.column, 13u);
  EXPECT_EQ(span_at(source, 1000).line, 3u);
  EXPECT_EQ(*x.file, "a");
}

TEST(Unit_Source, TheCaretStandsBelowItsCharacter) {
  const std::string text = "one\ntwo gr\xC3\xB6sser\tx\r\nthree";
  EXPECT_EQ(excerpt_at(make_source("a", text), text.find('x')),
            "two gr\xC3\xB6sser x\n            ^");
  EXPECT_EQ(excerpt_at(make_source("a", ""), 0), "\n^");
  EXPECT_EQ(excerpt_at(make_source("a", text), text.size()), "three\n     ^");
}

TEST(Unit_Source, LongLinesAreCutAroundThePlace) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "\xC3\xB6";  // two bytes each
  for (const std::size_t offset : {0u, 74u, 75u, 998u, 1999u}) {
    const std::string excerpt = excerpt_at(make_source("a", text), offset);
    const std::size_t newline = excerpt.find('\n');
    EXPECT_LE(newline, 104u);
    EXPECT_NE(static_cast<unsigned char>(excerpt[0]) & 0xC0, 0x80) << "begins within a character";
  }
}

TEST(Unit_Source, QuotedWordsAreShortAndClean) {
  EXPECT_EQ(text::quoted("word"), "'word'");
  EXPECT_EQ(text::quoted("a\x1b[b\n"), "'a?[b?'");
  EXPECT_EQ(text::quoted(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(Unit_Source, BytesThatAreNoUtf8AreNotPrinted) {
  const std::string whole = "\xC3\xB6\xE2\x82\xAC\xF0\x9F\x98\x80";
  EXPECT_EQ(text::quoted(whole), "'" + whole + "'");
  EXPECT_EQ(text::quoted("a\xFF\xFEz"), "'a??z'");
  EXPECT_EQ(text::quoted("\xC3z\x80"), "'?z?'");
  EXPECT_EQ(text::quoted_path("a\xE2\x82"), "'a?\?'");
  const std::string text = "\x80\xFFx";
  EXPECT_EQ(excerpt_at(make_source("a", text), 2), "  x\n  ^");
}

TEST(Unit_Cursor, WordsLinesAndContinuations) {
  Cursor cursor("  a\tb\\\n c \r\n d\\x # e\\\n# f\\\ng");
  Cursor line(cursor.next_logical_line());
  EXPECT_EQ(line.next_word(), "a");
  EXPECT_EQ(line.next_word(), "b");
  EXPECT_EQ(line.next_word(), "c");
  EXPECT_EQ(line.next_word(), "");
  EXPECT_TRUE(line.at_end());
  line = Cursor(cursor.next_logical_line());
  EXPECT_EQ(line.next_word(), "d\\x");
  EXPECT_EQ(line.rest(), " # e\\");  // a comment, which is not continued
  EXPECT_EQ(cursor.next_logical_line(), "# f\\");
  EXPECT_EQ(cursor.next_logical_line(), "g");
  EXPECT_TRUE(cursor.at_end());
  EXPECT_EQ(cursor.next_logical_line(), "");
}

TEST(Unit_Cursor, CommentsAreNotContinued) {
  Cursor cursor(" # in c:\\temp\\\nnext");
  EXPECT_EQ(cursor.next_logical_line(), " # in c:\\temp\\");
  EXPECT_EQ(cursor.next_logical_line(), "next");
  cursor = Cursor("f 1 2 \\\n3 # in c:\\temp\\\nnext");
  EXPECT_EQ(cursor.next_logical_line(), "f 1 2 \\\n3 # in c:\\temp\\");
  EXPECT_EQ(cursor.next_logical_line(), "next");
  cursor = Cursor("usemtl Material#25\\\nnext");  // no comment
  EXPECT_EQ(cursor.next_logical_line(), "usemtl Material#25\\\nnext");
}

TEST(Unit_Cursor, SpacesReachAcrossLines) {
  Cursor cursor(" \n\r\n\t a");
  cursor.skip_blanks();
  EXPECT_EQ(cursor.peek(), '\n');
  cursor.skip_spaces();
  EXPECT_EQ(cursor.next_word(), "a");
  EXPECT_EQ(cursor.peek(), '\0');
}

}  // namespace
}  // namespace candela::text
