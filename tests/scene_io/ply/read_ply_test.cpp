#include "scene_io/ply/read_ply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "tests/scene_io/gzip.h"
#include "tests/scene_io/mutate.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::ply {
namespace {

using description::Mesh;

struct Outcome {
  std::optional<Mesh> mesh;
  Diagnostics diagnostics;
};

Outcome outcome_of(std::string_view bytes, bool smooth = false) {
  Outcome outcome;
  outcome.mesh = parse_ply("a.ply", bytes, {smooth}, outcome.diagnostics);
  return outcome;
}

Mesh parse(std::string_view bytes, bool smooth = false) {
  Outcome outcome = outcome_of(bytes, smooth);
  for (const Diagnostic& d : outcome.diagnostics.list()) ADD_FAILURE() << to_string(d);
  return outcome.mesh.value_or(Mesh{});
}

// Numbers appended as a PLY body of one of the two byte orders.
class Bytes {
 public:
  explicit Bytes(std::endian order) : order_(order) {}
  template <class T>
  Bytes& add(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (order_ != std::endian::native) std::reverse(bytes, bytes + sizeof(T));
    text_.append(bytes, sizeof(T));
    return *this;
  }
  template <class T>
  Bytes& add_all(std::initializer_list<T> values) {
    for (const T value : values) add(value);
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::endian order_;
  std::string text_;
};

const std::string header_tail =
    "comment made by hand \\\nobj_info none\nelement vertex 5\nproperty float x\nproperty float y\n"
    "property double z\nproperty uchar red\nproperty float nx\nproperty float ny\n"
    "property float nz\nproperty list uchar short extra\nproperty float s\nproperty float t\n"
    "element edge 2\nproperty int a\nproperty list int float weights\n"
    "element face 2\nproperty ushort flags\nproperty list uchar int vertex_indices\n"
    "property float quality\nend_header\n";

std::string binary(std::endian order) {
  Bytes b(order);
  const float corners[5][2] = {{0, 0}, {2, 0}, {2, 2}, {1, 3}, {0, 2}};
  for (const auto& [x, y] : corners) {
    b.add(x).add(y).add(0.1).add(std::uint8_t{200}).add_all<float>({0, 0, 1});
    b.add(std::uint8_t{2}).add_all<std::int16_t>({-7, 300}).add(x / 2).add(y / 3);
  }
  b.add(1).add(2).add_all<float>({1, 2}).add(2).add(0);
  b.add(std::uint16_t{1}).add(std::uint8_t{3}).add_all<int>({0, 1, 2}).add(1.0f);
  b.add(std::uint16_t{1}).add(std::uint8_t{5}).add_all<int>({0, 1, 2, 3, 4}).add(1.0f);
  const char* const name =
      order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
  return fmt::format("ply\nformat {} 1.0\n{}{}", name, header_tail, b.text());
}

const std::string ascii =
    "ply\r\nformat ascii 1.0\r\n" + header_tail +
    "0 0 .1 200 0 0 1 2 -7 300 0 0\n2 0 .1 200 0 0 1 2 -7 300 1 0\n"
    "2 2 .1 200 0 0 1 2 -7 300 1 0.66666668653\n1 3 .1 200 0 0 1 2 -7 300 .5 1\n"
    "0 2 .1 200 0 0 1 2 -7 300\n0 0.66666668653\n1 2 1 2\n2 0\n1 3 0 1 2 1\n1 5 0 1 2 3 4 1";

TEST(Unit_Ply, AsciiAndBothByteOrdersGiveTheSameMesh) {
  const Mesh expected = parse(ascii);
  ASSERT_EQ(expected.positions.size(), 5u);
  EXPECT_EQ(expected.positions[3], Vec3d(1, 3, 0.1));
  EXPECT_EQ(expected.normals, std::vector<Vec3f>(5, {0, 0, 1}));
  EXPECT_EQ(expected.uvs[3], Vec2f(0.5f, 1.0f));
  EXPECT_EQ(expected.triangles.size(), 4u);
  EXPECT_EQ(expected.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(expected.name, "a.ply");
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Mesh mesh = parse(binary(order));
    EXPECT_EQ(mesh.positions, expected.positions);
    EXPECT_EQ(mesh.normals, expected.normals);
    EXPECT_EQ(mesh.uvs, expected.uvs);
    EXPECT_EQ(mesh.triangles, expected.triangles);
  }
}

std::string triangle_header(std::string_view more = "", std::string_view faces = "1") {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\n{}element face {}\nproperty list uchar uint vertex_index\nend_header\n",
      more, faces);
}

// And only where triangles share a vertex: else there is nothing to smooth.
TEST(Unit_Ply, MissingNormalsAreComputedOnlyWhereAsked) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string two = triangle_header("", "2") + points + "3 0 1 2\n3 0 1 2\n";
  EXPECT_TRUE(parse(two).normals.empty());
  EXPECT_TRUE(parse(two).uvs.empty());
  EXPECT_EQ(parse(two, true).normals, std::vector<Vec3f>(3, {0, 0, 1}));
  EXPECT_TRUE(parse(triangle_header() + points + "3 0 1 2\n", true).normals.empty());
}

TEST(Unit_Ply, TextureCoordinatesHaveManyNames) {
  for (const auto& [u, v] :
       {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
    const std::string more = fmt::format("property float {}\nproperty float {}\n", u, v);
    const Mesh mesh = parse(triangle_header(more) + "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 .25\n3 0 1 2\n");
    EXPECT_EQ(mesh.uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {0, 0.25f}})) << u;
  }
}

// In pbrt's order, whichever stands first in the file.
TEST(Unit_Ply, OfSeveralTextureCoordinatesThoseNamedUAndVCount) {
  const std::string more =
      "property float s\nproperty float t\nproperty float u\nproperty float v\n";
  const Mesh mesh = parse(triangle_header(more) +
                          "0 0 0 9 9 0 0\n1 0 0 9 9 1 0\n0 1 0 9 9 0 .25\n" + "3 0 1 2\n");
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {0, 0.25f}}));
}

TEST(Unit_Ply, FacesOfFewerThanThreeCornersAreLeftOut) {
  const Outcome outcome =
      outcome_of(triangle_header("", "3") + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 0\n");
  ASSERT_TRUE(outcome.mesh);
  EXPECT_EQ(outcome.mesh->triangles.size(), 1u);
  ASSERT_EQ(outcome.diagnostics.list().size(), 1u);
  EXPECT_EQ(to_string(outcome.diagnostics.list()[0]),
            "a.ply: warning: faces of fewer than 3 corners are left out: 2");
}

TEST(Unit_Ply, StripsTurnEveryOtherTriangle) {
  const Mesh mesh = parse(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0 1 0 0 0 1 0 1 1 0\n8 0 1 2 3 -1 0 1 3\n");
  EXPECT_EQ(mesh.triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {2, 1, 3}, {0, 1, 3}}));
}

TEST(Unit_Ply, FacesMayStandBeforeTheVertices) {
  const Mesh mesh = parse(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\n"
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "4 0 1 2 3\n0 0 0 1 0 0 1 1 0 0 1 0\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(Unit_Ply, IsReadFromFilesGzippedOrNot) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string bytes = binary(std::endian::little);
  for (const std::string& path :
       {folder.put("a.ply", bytes), folder.put("a.ply.gz", gzip(bytes))}) {
    const auto mesh = read_ply(path, {}, diagnostics);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->triangles.size(), 4u);
    EXPECT_TRUE(mesh->materials.empty());
  }
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_FALSE(read_ply(folder.file("absent.ply"), {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Unit_Ply, StrangeNormalsAndTextureCoordinatesAreReplaced) {
  const std::string more =
      "property float nx\nproperty float ny\nproperty float nz\nproperty float u\nproperty float "
      "v\n";
  const Outcome outcome = outcome_of(triangle_header(more) +
                                     "0 0 0 nan 0 0 0 0\n1 0 0 0 0 1 inf 1\n0 1 0 0 0 0 1 1\n"
                                     "3 0 1 2\n");
  ASSERT_TRUE(outcome.mesh);
  EXPECT_EQ(outcome.mesh->normals, (std::vector<Vec3f>{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}));
  EXPECT_EQ(outcome.mesh->uvs[1], Vec2f(0, 1));
  EXPECT_EQ(outcome.diagnostics.list().at(0).message,
            "2 normals and texture coordinates are not finite and count as absent or 0");
}

TEST(Errors_Ply, NameThePlaceAndWhatWasExpected) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const auto with = [](std::string_view lines) {
    return fmt::format("ply\nformat ascii 1.0\n{}end_header\n", lines);
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "a.ply:1:1: error: is not a PLY file: expected 'ply' in the first line\n\n^"},
      {"solid x\n",
       "a.ply:1:1: error: is not a PLY file: expected 'ply' in the first line\nsolid x\n^"},
      {"ply\nformat ascii 1.0\n",
       "a.ply:3:1: error: the header has no end; expected 'end_header'\n\n^"},
      {"ply\nend_header\n",
       "a.ply:1:1: error: the header says no format; expected 'format ascii 1.0' or the like\n"
       "ply\n^"},
      {"ply\nformat binary 1.0\n",
       "a.ply:2:8: error: format 'binary'; expected ascii, binary_little_endian or "
       "binary_big_endian\nformat binary 1.0\n       ^"},
      {with("elemnt vertex 3\n"),
       "a.ply:3:1: error: 'elemnt' in the header; expected 'element', 'property' or 'end_header', "
       "did you mean 'element'?\nelemnt vertex 3\n^"},
      {with("element vertex many\n"),
       "a.ply:3:16: error: 'many' is not a count; expected 'element NAME COUNT'\n"
       "element vertex many\n               ^"},
      {with("element vertex -1\n"),
       "a.ply:3:16: error: '-1' is not a count; expected 'element NAME COUNT'\n"
       "element vertex -1\n               ^"},
      {with("property float x\n"),
       "a.ply:3:1: error: a property before the first element\nproperty float x\n^"},
      {with("element vertex 3\nproperty real x\n"),
       "a.ply:4:10: error: 'real' is not a type; expected one of char, uchar, short, ushort, int, "
       "uint, float, double\nproperty real x\n         ^"},
      {with("element vertex 3\nproperty float\n"),
       "a.ply:4:1: error: a property without a name\nproperty float\n^"},
      {with("element face 3\nproperty list float int vertex_indices\n"),
       "a.ply:4:1: error: a list whose length is no integer; expected an integer type\n"
       "property list float int vertex_indices\n^"},
      {with("element vertex 0\nproperty float x\nproperty list int int y\nproperty float z\n"),
       "a.ply:3:1: error: vertices without the properties x, y and z\nelement vertex 0\n^"},
      {with("element vertex 0\n" + xyz + "element vertex 0\n"),
       "a.ply:7:1: error: a second element 'vertex'\nelement vertex 0\n^"},
      {with("element vertex 0\n" + xyz), "a.ply: error: holds no vertices"},
      {with("element vertex 1\n" + xyz) + "0 0 0\n", "a.ply: error: holds no faces"},
      {with("element vertex 3\n" + xyz +
            "element face 1\nproperty list uchar int vertx_indices\n") +
           vertices + "3 0 1 2\n",
       "a.ply:7:1: error: faces without the list 'vertex_indices' or 'vertex_index'\n"
       "element face 1\n^"},
      {with("element vertex 4000000000\n" + xyz) + vertices,
       "a.ply:3:1: error: 4000000000 'vertex' are announced, but the file has only 18 bytes for "
       "them\nelement vertex 4000000000\n^"},
      {triangle_header() + "0 0 0\n1 x 0\n",
       "a.ply:11:3: error: found 'x', expected a number of 'vertex' 2 of 3\n1 x 0\n  ^"},
      {triangle_header() + "0 0 0\n1 nan 0\n0 1 0\n",
       "a.ply:11:7: error: 'vertex' 2 of 3 has a position that is not finite\n1 nan 0\n      ^"},
      {triangle_header() + vertices + "3 0 1 3\n",
       "a.ply:13:7: error: 'face' 1 of 1 has corner 3, but there are 3 vertices (from 0)\n"
       "3 0 1 3\n      ^"},
      {triangle_header() + vertices + "3 0 -1 2\n",
       "a.ply:13:5: error: 'face' 1 of 1 has corner -1, but there are 3 vertices (from 0)\n"
       "3 0 -1 2\n    ^"},
      {triangle_header() + vertices + "3 0 1.5 2\n",
       "a.ply:13:5: error: 'face' 1 of 1 has corner 1.5, but there are 3 vertices (from 0)\n"
       "3 0 1.5 2\n    ^"},
      {triangle_header() + vertices + "2 0 1\n",
       "a.ply: error: holds no face of 3 corners or more"},
      {triangle_header() + vertices + "4000000000 0 1\n",
       "a.ply:13:1: error: 'face' 1 of 1 announces 4000000000 corners, more than the file has "
       "bytes "
       "for\n4000000000 0 1\n^"},
      {triangle_header() + vertices + "-3 0 1\n",
       "a.ply:13:1: error: 'face' 1 of 1 announces -3 corners, expected a whole number of at least "
       "0\n"
       "-3 0 1\n^"},
      {triangle_header() + vertices + "3.7 0 1 2\n",
       "a.ply:13:1: error: 'face' 1 of 1 announces 3.7 corners, expected a whole number of at "
       "least 0\n"
       "3.7 0 1 2\n^"},
      {triangle_header("", "2") + vertices + "3 0 1 2\n",
       "a.ply:14:1: error: found the end of the file, expected a number of 'face' 2 of 2\n\n^"},
  };
  for (const auto& [text, expected] : cases) {
    const Outcome outcome = outcome_of(text);
    EXPECT_FALSE(outcome.mesh) << text;
    ASSERT_EQ(outcome.diagnostics.list().size(), 1u) << text;
    EXPECT_EQ(to_string(outcome.diagnostics.list()[0]), expected);
  }
}

TEST(Errors_Ply, BinaryFilesAreAnsweredByByte) {
  const std::string whole = binary(std::endian::little);
  const Outcome outcome = outcome_of(whole.substr(0, whole.size() - 10));
  EXPECT_FALSE(outcome.mesh);
  ASSERT_EQ(outcome.diagnostics.list().size(), 1u);
  EXPECT_EQ(outcome.diagnostics.list()[0].message,
            fmt::format(
                "'face' 2 of 2 announces 5 corners, more than the file has bytes for (before byte "
                "{})",
                whole.size() - 24));
}

// Headers that promise much get no memory: each of these would need gigabytes.
TEST(Errors_Ply, NothingIsAllocatedOnAHeadersWord) {
  for (const char* const count : {"1000000000", "4294967295", "9223372036854775807"}) {
    for (const char* const form : {"ascii", "binary_little_endian"}) {
      for (const char* const element : {"vertex", "face", "other"}) {
        std::string text = fmt::format("ply\nformat {} 1.0\n", form);
        for (const char* const name : {"vertex", "face", "other"}) {
          text += fmt::format("element {} {}\n", name, name == std::string(element) ? count : "0");
          text += name == std::string("vertex")
                      ? "property char x\nproperty char y\nproperty char z\n"
                      : "property list uint uint vertex_indices\n";
        }
        EXPECT_FALSE(outcome_of(text + "end_header\n12345678").mesh);
        EXPECT_FALSE(outcome_of(text + "element empty " + count + "\nend_header\n").mesh);
      }
    }
  }
}

std::string fault_of(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  for (const Vec3d& p : mesh.positions) {
    if (!is_finite(p)) return "a position is not finite";
  }
  for (const Vec3f& n : mesh.normals) {
    if (!is_finite(n)) return "a normal is not finite";
  }
  if (!mesh.normals.empty() && mesh.normals.size() != count) return "wrong count of normals";
  if (!mesh.uvs.empty() && mesh.uvs.size() != count) return "wrong count of uvs";
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= count) return "a vertex is out of range";
    }
  }
  return mesh.triangles.empty() ? "no triangles" : "";
}

TEST(Stress_Ply, MutatedFilesAreHarmless) {
  const std::vector<std::string> samples{ascii, binary(std::endian::little),
                                         binary(std::endian::big)};
  for (std::size_t s = 0; s < samples.size(); ++s) {
    Mutator mutate(static_cast<unsigned>(s));
    int unharmed = 0;
    for (int round = 0; round < mutation_count(); ++round) {
      const Outcome outcome = outcome_of(mutate(samples[s]), true);
      unharmed += outcome.mesh ? 1 : 0;
      ASSERT_NE(outcome.mesh.has_value(), outcome.diagnostics.has_errors());
      if (!outcome.mesh) continue;
      ASSERT_EQ(fault_of(*outcome.mesh), "") << "copy " << round << " of " << s;
    }
    // Were all refused, or none, the copies would try nothing.
    EXPECT_GT(unharmed, mutation_count() / 100);
    EXPECT_LT(unharmed, mutation_count() - mutation_count() / 100);
  }
}

}  // namespace
}  // namespace candela::ply
