// Every sentence that the OBJ and MTL readers may say.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include "scene_io/obj/read_mtl.h"
#include "scene_io/obj/read_obj.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::obj {
namespace {

struct Case {
  std::string text;
  std::string expected;  // of the first diagnostic, excerpt included
};

std::string first_said(const Diagnostics& diagnostics) {
  return diagnostics.list().empty() ? "" : to_string(diagnostics.list()[0]);
}

std::string three_and(std::string_view more) {
  return fmt::format("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", more);
}

TEST(Errors_Obj, NameThePlaceAndWhatWasExpected) {
  const std::vector<Case> cases{
      {three_and("f 1 2 9\n"),
       "a.obj:4:7: error: index 9 is out of range: the file has 3 positions ('v')\nf 1 2 9\n      "
       "^"},
      {three_and("f 1/2 2/1 3/1\n"),
       "a.obj:4:5: error: index 2 is out of range: the file has 0 texture coordinates ('vt')\n"
       "f 1/2 2/1 3/1\n    ^"},
      {three_and("vn 0 0 1\nf 1//1 2//2 3//1\n"),
       "a.obj:5:11: error: index 2 is out of range: the file has 1 normal ('vn')\n"
       "f 1//1 2//2 3//1\n          ^"},
      {three_and("f 1 2 -99\n"),
       "a.obj:4:7: error: index -99 reaches before the first position: 3 'v' stand above this "
       "line\n"
       "f 1 2 -99\n      ^"},
      {three_and("f 0 1 2\n"),
       "a.obj:4:3: error: index 0 of a position: expected 1 for the first, or -1 for the last\n"
       "f 0 1 2\n  ^"},
      {three_and("f 1 2 4294967297\n"),
       "a.obj:4:7: error: index 4294967297 is out of range: the file has 3 positions ('v')\n"
       "f 1 2 4294967297\n      ^"},
      {three_and("f 1 2 999999999999999999999999999999\n"),
       "a.obj:4:7: error: index 999999999999999999999999... is out of range: the file has 3 "
       "positions ('v')\nf 1 2 999999999999999999999999999999\n      ^"},
      {three_and("f 1 2 3.5\n"),
       "a.obj:4:8: error: '3.5' is not the index of a position; expected v, v/vt, v//vn or "
       "v/vt/vn\nf 1 2 3.5\n       ^"},
      {three_and("f 1 two 3\n"),
       "a.obj:4:5: error: 'two' is not the index of a position; expected v, v/vt, v//vn or "
       "v/vt/vn\nf 1 two 3\n    ^"},
      {three_and("f 1 2\n"), "a.obj:4:1: error: a face of 2 corners; expected 3 or more\nf 1 2\n^"},
      {three_and("f\n"), "a.obj:4:1: error: a face of 0 corners; expected 3 or more\nf\n^"},
      {"v 1 2\n", "a.obj:1:6: error: 'v' has 2 numbers; expected 3\nv 1 2\n     ^"},
      {"vn 1\n", "a.obj:1:5: error: 'vn' has 1 number; expected 3\nvn 1\n    ^"},
      {"vt\n", "a.obj:1:3: error: 'vt' has 0 numbers; expected 1 or more\nvt\n  ^"},
      {"v 1 2 x3\n",
       "a.obj:1:7: error: 'x3' is not a number; expected 3 numbers after 'v'\nv 1 2 x3\n      ^"},
      {"v 1 nan 3\n",
       "a.obj:1:5: error: 'nan' is not a finite number; expected 3 numbers after 'v'\n"
       "v 1 nan 3\n    ^"},
      {"v 1 -inf 3\n",
       "a.obj:1:5: error: '-inf' is not a finite number; expected 3 numbers after 'v'\n"
       "v 1 -inf 3\n    ^"},
      {"v 1 1e999 3\n",
       "a.obj:1:5: error: '1e999' is too large a number; expected 3 numbers after 'v'\n"
       "v 1 1e999 3\n    ^"},
      {"v 1,5 2 3\n",
       "a.obj:1:3: error: '1,5' is not a number; expected 3 numbers after 'v'\nv 1,5 2 3\n  ^"},
      {"\xFF\xFEv\0", "a.obj:1:1: error: is in UTF-16; expected ASCII or UTF-8"},
      {three_and(""), "a.obj: error: holds no faces ('f')"},
      {"", "a.obj: error: holds no faces ('f')"},
      {three_and("f 1 2 3\nusemlt x\n"),
       "a.obj:5:1: warning: unknown statement 'usemlt' is left out, did you mean 'usemtl'?\n"
       "usemlt x\n^"},
      {three_and("l 1 2\nf 1 2 3\n"),
       "a.obj:4:1: warning: lines ('l') are left out: only faces are rendered\nl 1 2\n^"},
      {three_and("p 1\nf 1 2 3\n"),
       "a.obj:4:1: warning: points ('p') are left out: only faces are rendered\np 1\n^"},
      {three_and("f 1 2 3\ncstype bezier\ncurv 0 1 1 2 3\nend\n"),
       "a.obj:5:1: warning: 'cstype' is left out: curves, surfaces and display settings are not "
       "supported\ncstype bezier\n^"},
  };
  for (const Case& c : cases) {
    Diagnostics diagnostics;
    ObjOptions options;
    options.materials = MtlUse::Ignore;
    const ObjModel model = parse_obj("a.obj", c.text, options, diagnostics);
    EXPECT_EQ(first_said(diagnostics), c.expected);
    EXPECT_EQ(diagnostics.list().size(), 1u) << c.text;
  }
}

TEST(Errors_Obj, AnExcerptOfALongLineIsCutAndAStrangeOneCleaned) {
  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = MtlUse::Ignore;
  const std::string text = "v 1 " + std::string(300, ' ') + "\x1b[31mbad\t3\n";
  const ObjModel model = parse_obj("a.obj", text, options, diagnostics);
  const std::string& excerpt = diagnostics.list().at(0).excerpt;
  EXPECT_EQ(diagnostics.list()[0].span.column, 305u);
  EXPECT_LE(excerpt.find('\n'), 100u);
  EXPECT_EQ(excerpt.find('\x1b'), std::string::npos);
  const std::size_t caret = excerpt.find('^') - excerpt.find('\n') - 1;
  EXPECT_EQ(excerpt.substr(caret + 1, 7), "[31mbad");
}

TEST(Errors_Obj, ABrokenFileGivesTwentyErrorsAndEndsSoon) {
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += "f a b c\n";
  Diagnostics diagnostics;
  const ObjModel model = parse_obj("a.obj", text, {}, diagnostics);
  EXPECT_EQ(diagnostics.list().size(), Diagnostics::limit);
  EXPECT_EQ(diagnostics.error_count(), Diagnostics::most_counted);
}

TEST(Errors_Obj, ThoseThatAreNotToldAreCounted) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "f a b c\n";
  Diagnostics diagnostics;
  const ObjModel model = parse_obj("a.obj", text, {}, diagnostics);
  EXPECT_EQ(diagnostics.list().size(), Diagnostics::limit);
  EXPECT_EQ(diagnostics.error_count(), 50u);
}

TEST(Errors_Mtl, ThoseThatAreNotToldAreCounted) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "newmtl a\nKd x\n";
  Diagnostics diagnostics;
  const MtlLibrary library = parse_mtl("a.mtl", text, MtlUse::Full, diagnostics);
  EXPECT_EQ(diagnostics.error_count(), 50u);
  EXPECT_EQ(diagnostics.warning_count(), 49u) << "defined again";
}

TEST(Errors_Obj, FilesThatAreNoneGetASentence) {
  const TemporaryFolder folder;
  const auto said = [](const std::string& path) {
    Diagnostics diagnostics;
    const ObjModel model = read_obj(path, {}, diagnostics);
    return first_said(diagnostics);
  };
  const auto expect_said = [&](const std::string& path, std::string_view message) {
    EXPECT_EQ(said(path), fmt::format("{}: error: {}", path, message));
  };
  expect_said(folder.file("absent.obj"), "cannot be opened: No such file or directory");
  expect_said(folder.path(), "is a folder; expected a regular file");
  expect_said("/dev/zero", "is a device; expected a regular file");
  ASSERT_EQ(::mkfifo(folder.file("fifo.obj").c_str(), 0600), 0);
  expect_said(folder.file("fifo.obj"), "is a FIFO; expected a regular file");
}

TEST(Errors_Obj, AMissingMtlIsAWarning) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const ObjModel model = parse_obj(
      folder.file("a.obj"), "mtllib b.mtl\n" + three_and("usemtl x\nf 1 2 3\n"), {}, diagnostics);
  EXPECT_TRUE(model.meshes.empty());
  ASSERT_EQ(diagnostics.list().size(), 2u);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list()[0].span.line, 1u);
  EXPECT_EQ(diagnostics.list()[0].span.column, 8u);
  EXPECT_TRUE(diagnostics.list()[0].message.ends_with(
      "cannot be opened: No such file or directory; faces that use its materials have none"))
      << diagnostics.list()[0].message;
  EXPECT_TRUE(diagnostics.list()[1].message.starts_with("1 face without a material is dropped"));
}

std::vector<std::string> said_of(const TemporaryFolder& folder, const std::string& text,
                                 MtlUse use) {
  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = use;
  (void)parse_obj(folder.file("a.obj"), text, options, diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& found : diagnostics.list()) messages.push_back(found.message);
  return messages;
}

TEST(Errors_Obj, MaterialsWithoutAnyMtl) {
  const TemporaryFolder folder;
  folder.put("empty.mtl", std::string("# nothing\n"));
  const std::string unknown =
      "material 'red' is not in the MTL, which has no materials; expected 'mtllib' with one before";
  for (const std::string library : {"", "mtllib empty.mtl\n"}) {
    const std::string text = library + three_and("usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 2\n");
    EXPECT_EQ(said_of(folder, text, MtlUse::Full), std::vector{unknown});
    EXPECT_EQ(said_of(folder, text, MtlUse::Lab),
              (std::vector<std::string>{
                  unknown,
                  "2 faces without a material are dropped, from here on; expected 'mtllib' with an "
                  "MTL that has materials before"}));
  }
}

TEST(Errors_Obj, AMaterialOfTwoMtls) {
  const TemporaryFolder folder;
  folder.put("a.mtl", std::string("newmtl red\nKd 1 0 0\n"));
  folder.put("b.mtl", std::string("newmtl red\nKd 0 1 0\n"));
  const std::string text = "mtllib a.mtl b.mtl\n" + three_and("usemtl red\nf 1 2 3\n");
  EXPECT_EQ(said_of(folder, text, MtlUse::Full),
            std::vector{"material 'red' is defined in " + folder.file("a.mtl") +
                        " as well; the first definition counts"});
}

TEST(Errors_Obj, OfAMissingMtlWithBlanksTheWholeNameIsTold) {
  const TemporaryFolder folder;
  const auto said = said_of(folder, "mtllib my lib.mtl\n" + three_and("f 1 2 3\n"), MtlUse::Full);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with("MTL file '" + folder.file("my lib.mtl") + "' cannot be opened"))
      << said[0];
}

// What else is wrong with a broken file follows from that.
TEST(Errors_Obj, FacesOfBrokenFilesAreNotSaidToBeDropped) {
  const TemporaryFolder folder;
  EXPECT_EQ(said_of(folder, three_and("f 1 2 3\nf 1 2 9\n"), MtlUse::Lab).size(), 1u);
}

TEST(Errors_Obj, AnMtllibWithoutANameIsAWarning) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const ObjModel model =
      parse_obj(folder.file("a.obj"), three_and("f 1 2 3\nmtllib\nmtllib \n"), {}, diagnostics);
  ASSERT_FALSE(diagnostics.list().empty());
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(first_said(diagnostics),
            fmt::format("{}:5:1: warning: no file is named; expected the name of an MTL file\n"
                        "mtllib\n^",
                        folder.file("a.obj")));
}

TEST(Errors_Mtl, NameThePlaceAndWhatWasExpected) {
  const std::vector<Case> cases{
      {"newmtl a\nKd 1 x 1\n",
       "a.mtl:2:6: error: 'x' is not a number; expected a number after 'Kd'\nKd 1 x 1\n     ^"},
      {"newmtl a\nKd 1 1\n",
       "a.mtl:2:7: error: 'Kd' has 2 numbers; expected 3, or 1 for all\nKd 1 1\n      ^"},
      {"newmtl a\nKe # none\n",
       "a.mtl:2:4: error: 'Ke' has 0 numbers; expected 3, or 1 for all\nKe # none\n   ^"},
      {"newmtl a\nNs\n", "a.mtl:2:3: error: 'Ns' has 0 numbers; expected 1\nNs\n  ^"},
      {"newmtl a\nTr # 1\n", "a.mtl:2:4: error: 'Tr' has 0 numbers; expected 1\nTr # 1\n   ^"},
      {"newmtl a\nNs inf\n",
       "a.mtl:2:4: error: 'inf' is not a finite number; expected a number after 'Ns'\nNs inf\n   "
       "^"},
      {"newmtl a\nillum glass\n",
       "a.mtl:2:7: error: 'glass' is not a number; expected a number after 'illum'\n"
       "illum glass\n      ^"},
      {"newmtl\nKd 1 1 1\n", "a.mtl:1:1: error: a material without a name\nnewmtl\n^"},
      {"Kd 1 1 1\nKs 1 1 1\n",
       "a.mtl:1:1: warning: 'Kd' stands before the first 'newmtl': what stands there is left "
       "out\nKd 1 1 1\n^"},
      {"newmtl a\nKdd 1 1 1\nKdd 1\n",
       "a.mtl:2:1: warning: unknown statement 'Kdd' is left out, did you mean 'Kd'?\n"
       "Kdd 1 1 1\n^"},
      {"newmtl a\nnewmtl a\n",
       "a.mtl:2:1: warning: material 'a' is defined again; the first definition counts\n"
       "newmtl a\n^"},
      {"newmtl a\nmap_Kd\n",
       "a.mtl:2:7: error: no file is named; expected the name of an image\nmap_Kd\n      ^"},
      {"newmtl a\nbump -bm x a.png\n",
       "a.mtl:2:10: error: 'x' is not a number; expected a number after '-bm'\n"
       "bump -bm x a.png\n         ^"},
      {"newmtl a\nmap_Kd -clamp\n",
       "a.mtl:2:14: error: nothing stands behind '-clamp'\nmap_Kd -clamp\n             ^"},
      {"newmtl a\nmap_Kd -s 2 2 2 a.png\n",
       "a.mtl:2:8: warning: texture option '-s' is left out\nmap_Kd -s 2 2 2 a.png\n       ^"},
      {"newmtl a\nmap_Kd a.png -s 2 2 2\n",
       "a.mtl:2:14: warning: '-s' behind the name of an image is part of it; options stand before "
       "it\nmap_Kd a.png -s 2 2 2\n             ^"},
      {"newmtl a\nKd spectral a.rfl 1\n",
       "a.mtl:2:4: warning: 'spectral' is left out; expected three numbers\n"
       "Kd spectral a.rfl 1\n   ^"},
      {"newmtl a\nmap_Pm a.png\n",
       "a.mtl:2:1: warning: 'map_Pm' is left out: only a factor is supported here\n"
       "map_Pm a.png\n^"},
  };
  for (const Case& c : cases) {
    Diagnostics diagnostics;
    const MtlLibrary library = parse_mtl("a.mtl", c.text, MtlUse::Full, diagnostics);
    EXPECT_EQ(first_said(diagnostics), c.expected);
    EXPECT_EQ(diagnostics.list().size(), 1u) << c.text;
  }
}

TEST(Errors_Mtl, ATextureThatIsTakenForAnotherMachinesIsNoted) {
  const TemporaryFolder folder;
  folder.put("brick.png", std::string("x"));
  Diagnostics diagnostics;
  const MtlLibrary library = parse_mtl(
      folder.file("a.mtl"), "newmtl a\nmap_Kd C:\\textures\\brick.png\n", MtlUse::Lab, diagnostics);
  EXPECT_EQ(library.images.at(0).path, folder.file("brick.png"));
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].severity, Severity::Note);
  EXPECT_EQ(diagnostics.list()[0].message,
            fmt::format("file '{}' is taken for 'C:\\textures\\brick.png', which does not exist",
                        folder.file("brick.png")));
}

TEST(Errors_Mtl, ASpellingOfOtherLetterCaseIsNoted) {
  const TemporaryFolder folder;
  folder.put("Brick.PNG", std::string("x"));
  Diagnostics diagnostics;
  const MtlLibrary library =
      parse_mtl(folder.file("a.mtl"), "newmtl a\nmap_Kd brick.png\n", MtlUse::Lab, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].severity, Severity::Note);
  EXPECT_EQ(library.images.at(0).path, folder.file("Brick.PNG"));
}

}  // namespace
}  // namespace candela::obj
