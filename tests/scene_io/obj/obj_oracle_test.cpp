// Our OBJ reader against tinyobjloader (in double): the same triangles for each material, in order,
// with the same positions, texture coordinates and normals. Where corners have no normal, ours are
// held against a sum over tinyobjloader's own indices.
#ifdef CANDELA_HAS_TINYOBJLOADER

#define TINYOBJLOADER_USE_DOUBLE
#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <map>
#include <random>
#include <tuple>

#include "scene_io/obj/read_obj.h"
#include "tests/scene_io/shared_scenes.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::obj {
namespace {

using description::Mesh;
using Key = std::tuple<int, int, int>;

struct Sum {
  Vec3d value{0.0};
  double uncertainty = 0.0;
  Sum& operator+=(const Sum& other) {
    value += other.value;
    uncertainty += other.uncertainty;
    return *this;
  }
};

struct OracleMesh {
  std::vector<tinyobj::index_t> corners;  // three a triangle
  std::vector<std::size_t> shapes;        // of each corner
};

// tinyobjloader takes the empty index in "1/2/" for an index 0.
std::string without_trailing_slashes(std::string text) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_last = i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\n';
    if (text[i] != '/' || !is_last) text[kept++] = text[i];
  }
  text.resize(kept);
  return text;
}

std::string mtl_beside(const std::string& path) {
  std::string text;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(path).parent_path())) {
    if (entry.path().extension() == ".mtl") text += contents_of(entry.path().string());
  }
  return text;
}

class Oracle {
 public:
  explicit Oracle(const std::string& path) {
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    if (!reader_.ParseFromString(without_trailing_slashes(contents_of(path)), mtl_beside(path),
                                 config)) {
      ADD_FAILURE() << reader_.Error();
    }
    const auto& shapes = reader_.GetShapes();
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      const tinyobj::mesh_t& mesh = shapes[s].mesh;
      for (std::size_t f = 0; f < mesh.material_ids.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
          add(by_material_[mesh.material_ids[f]], mesh.indices[3 * f + k], s);
          add(whole_, mesh.indices[3 * f + k], s);
        }
      }
    }
  }

  [[nodiscard]] std::size_t material_count() const { return reader_.GetMaterials().size(); }
  [[nodiscard]] const OracleMesh& of_material(int id) { return by_material_[id]; }
  [[nodiscard]] const OracleMesh& whole() const { return whole_; }

  [[nodiscard]] Vec3d position(const tinyobj::index_t& i) const {
    const auto& v = reader_.GetAttrib().vertices;
    const auto at = static_cast<std::size_t>(3 * i.vertex_index);
    return {v[at], v[at + 1], v[at + 2]};
  }
  [[nodiscard]] Vec3d normal(const tinyobj::index_t& i) const {
    const auto& v = reader_.GetAttrib().normals;
    const auto at = static_cast<std::size_t>(3 * i.normal_index);
    return {v[at], v[at + 1], v[at + 2]};
  }
  [[nodiscard]] Vec2f uv(const tinyobj::index_t& i) const {
    const auto& v = reader_.GetAttrib().texcoords;
    const auto at = static_cast<std::size_t>(2 * i.texcoord_index);
    return {static_cast<float>(v[at]), static_cast<float>(v[at + 1])};
  }
  // One normal a corner, however it comes about, and how far rounding may have moved it.
  [[nodiscard]] std::vector<Sum> normals(const OracleMesh& mesh, bool by_shape) const {
    bool is_complete = true;
    for (const auto& i : mesh.corners) is_complete = is_complete && i.normal_index >= 0;
    std::map<std::tuple<std::size_t, Key>, Sum> sums;
    const auto key = [&](std::size_t c) {
      const auto& i = mesh.corners[c];
      return std::tuple(by_shape ? mesh.shapes[c] : 0,
                        Key(i.vertex_index, i.texcoord_index, i.normal_index));
    };
    for (std::size_t c = 0; !is_complete && c < mesh.corners.size(); c += 3) {
      const Vec3d a = position(mesh.corners[c]);
      const Vec3d b = position(mesh.corners[c + 1]) - a;
      const Vec3d d = position(mesh.corners[c + 2]) - a;
      // tinyobjloader's decimals are off by some units in the last place.
      const double moved = 1e-14 * length(a) * (length(b) + length(d));
      for (std::size_t k = 0; k < 3; ++k) sums[key(c + k)] += {cross(b, d), moved};
    }
    std::vector<Sum> all;
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
      all.push_back(is_complete ? Sum{normal(mesh.corners[c]), 0.0} : sums[key(c)]);
    }
    return all;
  }

 private:
  static void add(OracleMesh& mesh, const tinyobj::index_t& index, std::size_t shape) {
    mesh.corners.push_back(index);
    mesh.shapes.push_back(shape);
  }

  tinyobj::ObjReader reader_;
  std::map<int, OracleMesh> by_material_;
  OracleMesh whole_;
};

bool is_near(const Vec3d& a, const Vec3d& b) {
  return length(a - b) <= 1e-14 * (length(a) + length(b));
}
bool has_direction(const Vec3d& a, const Sum& expected) {
  const double size = length(expected.value);
  if (length(a) == 0.0) return size <= expected.uncertainty;
  return length(normalize(a) * size - expected.value) <= 1e-6 * size + 2 * expected.uncertainty;
}

void expect_same(const Mesh& mesh, const Oracle& oracle, const OracleMesh& expected,
                 bool by_shape) {
  ASSERT_EQ(mesh.triangles.size() * 3, expected.corners.size()) << mesh.name;
  const std::vector<Sum> normals = oracle.normals(expected, by_shape);
  bool has_uvs = true;
  for (const auto& corner : expected.corners) has_uvs = has_uvs && corner.texcoord_index >= 0;
  std::size_t differing = 0;
  for (std::size_t c = 0; c < expected.corners.size(); ++c) {
    const std::uint32_t vertex = mesh.triangles[c / 3][c % 3];
    const tinyobj::index_t& corner = expected.corners[c];
    const Vec2f uv = has_uvs ? oracle.uv(corner) : Vec2f(0.5f);
    const bool is_same = is_near(mesh.positions[vertex], oracle.position(corner)) &&
                         length(mesh.uvs[vertex] - uv) <= 1e-6f * (1.0f + length(uv)) &&
                         has_direction(Vec3d(mesh.normals[vertex]), normals[c]);
    if (!is_same) ++differing;
  }
  EXPECT_EQ(differing, 0u) << mesh.name << " of " << expected.corners.size() << " corners";
}

void expect_same_as_oracle(const std::string& path) {
  SCOPED_TRACE(path);
  Oracle oracle(path);
  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = MtlUse::Ignore;
  const ObjModel whole = read_obj(path, options, diagnostics);
  ASSERT_EQ(whole.meshes.size(), 1u);
  expect_same(whole.meshes[0], oracle, oracle.whole(), true);

  const ObjModel lab = read_obj(path, {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(lab.materials.size(), oracle.material_count());
  std::size_t next = 0;
  for (std::size_t m = 0; m < lab.materials.size(); ++m) {
    const OracleMesh& expected = oracle.of_material(static_cast<int>(m));
    if (expected.corners.empty()) continue;
    ASSERT_LT(next, lab.meshes.size());
    EXPECT_EQ(lab.meshes[next].materials.at(0).index, m);
    expect_same(lab.meshes[next++], oracle, expected, false);
  }
  EXPECT_EQ(next, lab.meshes.size());
}

TEST(Agreement_Obj, SharedScenesReadAsTinyobjloaderReadsThem) {
  const auto folder = shared_scene("lab3");
  if (!folder) GTEST_SKIP() << "the lab3 scenes are not here";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder)) {
    // A crossed quad, which we untie (LAB3: it is meant as a rectangle).
    if (entry.path().extension() != ".obj" || entry.path().filename() == "light.obj") continue;
    expect_same_as_oracle(entry.path().string());
  }
}

// Convex faces of up to four corners: further ones may be cut otherwise.
std::string generated(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const bool has_uvs = below(3) > 0;
  const bool has_normals = below(3) > 0;
  std::string text = "mtllib m.mtl\n";
  int count = 0;
  for (int face = 0; face < 200; ++face) {
    if (below(20) == 0) text += fmt::format("usemtl m{}\n", below(4));
    if (below(20) == 0) text += below(2) == 0 ? "g part\n" : "o thing\n";
    const int corners = 3 + below(2);
    const double x = below(100), y = below(100), z = below(100);
    std::string line = "f";
    for (int k = 0; k < corners; ++k) {
      const double u = k == 1 || k == 2 ? 1.5 : 0.0, v = k >= 2 ? 1.0 : 0.0;
      text += fmt::format("v {} {:.7g} {}\nvt {} {}\nvn {} 1 {}e-1\n", x + u, y + v * 1.0001,
                          z + u * v, u, v, below(9), below(9));
      const bool is_backward = below(2) == 0;
      // Now and then a corner of an earlier face; a quad would no longer be convex.
      const int index =
          corners == 3 && k == 0 && face > 0 && below(4) == 0 ? 1 + below(count) : count + k + 1;
      const int shown = is_backward ? index - (count + corners) - 1 : index;
      line += fmt::format(" {}", shown);
      if (has_uvs || has_normals) line += '/';
      if (has_uvs) line += fmt::format("{}", shown);
      if (has_normals) line += fmt::format("/{}", shown);
    }
    count += corners;
    text += line + '\n';
  }
  return text;
}

TEST(Agreement_Obj, GeneratedFilesReadAsTinyobjloaderReadsThem) {
  const TemporaryFolder folder;
  folder.put("m.mtl", std::string("newmtl m0\nnewmtl m2\nnewmtl m1\nnewmtl m3\n"));
  for (unsigned seed = 0; seed < 40; ++seed) {
    expect_same_as_oracle(folder.put("a.obj", generated(seed)));
  }
}

}  // namespace
}  // namespace candela::obj

#else

#include <gtest/gtest.h>

TEST(Agreement_Obj, FilesReadAsTinyobjloaderReadsThem) {
  GTEST_SKIP() << "tinyobjloader in double (libtinyobjloader-dev) was not there to build with";
}

#endif
