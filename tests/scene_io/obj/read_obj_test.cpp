#include "scene_io/obj/read_obj.h"

#include <gtest/gtest.h>

#include "tests/scene_io/obj/check_model.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::obj {
namespace {

using description::Mesh;

ObjModel parse(std::string_view text, MtlUse use = MtlUse::Ignore, Diagnostics* said = nullptr) {
  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = use;
  ObjModel model = parse_obj("nowhere/test.obj", std::string(text), options, diagnostics);
  EXPECT_EQ(fault_of(model), "");
  if (said != nullptr) {
    *said = diagnostics;
  } else {
    for (const Diagnostic& d : diagnostics.list()) ADD_FAILURE() << to_string(d);
  }
  return model;
}

const std::string square =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

TEST(Unit_Obj, ReadsPositionsUvsAndNormalsByCorner) {
  const ObjModel model = parse(square + "f 1/1/1 2/2/1 3/3/1\n");
  ASSERT_EQ(model.meshes.size(), 1u);
  const Mesh& mesh = model.meshes[0];
  EXPECT_EQ(mesh.name, "nowhere/test.obj");
  EXPECT_EQ(mesh.span.line, 10u);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2f>{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(mesh.normals, std::vector<Vec3f>(3, {0, 0, 1}));
  EXPECT_TRUE(mesh.materials.empty());
}

TEST(Unit_Obj, NumbersAreReadAsDoubles) {
  const ObjModel model = parse("v 0.1 1e-3 -.5\nv +1. 2 3E+2\nv 1234567.89012 0 0\nf 1 2 3\n");
  EXPECT_EQ(model.meshes[0].positions,
            (std::vector<Vec3d>{{0.1, 1e-3, -0.5}, {1, 2, 300}, {1234567.89012, 0, 0}}));
}

TEST(Unit_Obj, VerticesAreUniqueByPositionUvAndNormal) {
  const ObjModel model =
      parse(square + "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\nf 1/2/1 3/3/1 4/4/1\n");
  EXPECT_EQ(model.meshes[0].positions.size(), 5u);
  EXPECT_EQ(model.meshes[0].triangles.size(), 3u);
}

TEST(Unit_Obj, BackwardIndicesCountFromTheirOwnLine) {
  const ObjModel model =
      parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 1 2\nf 4 1 2\n");
  const Mesh& mesh = model.meshes[0];
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.positions[mesh.triangles[0][0]], Vec3d(0, 0, 0));
  EXPECT_EQ(mesh.positions[mesh.triangles[1][0]], Vec3d(5, 5, 5));
  EXPECT_EQ(mesh.triangles[1], mesh.triangles[2]);
}

TEST(Unit_Obj, IndicesMayReachForward) {
  EXPECT_EQ(parse("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").meshes[0].triangles.size(), 1u);
}

TEST(Unit_Obj, LinesMayBeContinuedEndWindowsStyleAndHoldTabsAndComments) {
  const std::string plain = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  const std::vector<std::string> others{
      "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n",
      "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2\\\n 3 4",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\r\n3 4 \r\n",
      "\tv\t0 0\t0  \nv 1 0 0 # one\n  v 1 1 0\n\n# c:\\temp\\\nv 0 1 0\nf 1 2 3 4 # 5 6\n",
      "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
      "v 0 0 0 1 0 0\nv 1 0 0 .5\nv 1 1 0 1 .5 .5 .5\nv 0 1 0 1\nf 1// 2/ 3 4\n",
  };
  const ObjModel expected = parse(plain);
  for (const std::string& text : others) {
    const ObjModel model = parse(text);
    ASSERT_EQ(model.meshes.size(), 1u) << text;
    EXPECT_EQ(model.meshes[0].positions, expected.meshes[0].positions) << text;
    EXPECT_EQ(model.meshes[0].triangles, expected.meshes[0].triangles) << text;
  }
}

// Two triangles that fold along an edge.
const std::string folded = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\n";

TEST(Unit_Obj, MissingNormalsAreSummedByAreaOverSharedVertices) {
  const ObjModel model = parse(folded + "f 1 2 3\nf 1 4 2\n");
  const Mesh& mesh = model.meshes[0];
  // (0,0,1) with twice the area 1 and (0,1,0) with 2.
  const Vec3f expected = normalize(Vec3f(0, 2, 1));
  EXPECT_LT(length(mesh.normals[0] - expected), 1e-6f);
  EXPECT_LT(length(mesh.normals[1] - expected), 1e-6f);
  EXPECT_EQ(mesh.normals[2], Vec3f(0, 0, 1));
  EXPECT_EQ(mesh.uvs, std::vector<Vec2f>(4, {0.5f, 0.5f}));
}

TEST(Unit_Obj, OneMissingNormalOrUvReplacesAll) {
  const ObjModel model = parse(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .1 .2\nvn 0 1 0\nf 1/1/1 2/1/1 3//1\nf 1/1/1 2/1/1 3/1\n");
  EXPECT_EQ(model.meshes[0].uvs[0], Vec2f(0.5f));
  EXPECT_EQ(model.meshes[0].normals[0], Vec3f(0, 0, 1));
}

TEST(Unit_Obj, NormalsDoNotSmoothAcrossShapes) {
  for (const char* const statement : {"g b", "o", "g"}) {
    const ObjModel model = parse(folded + "g a\nf 1 2 3\n" + statement + "\nf 1 4 2\n");
    const Mesh& mesh = model.meshes[0];
    EXPECT_EQ(mesh.positions.size(), 6u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh.normals[i], Vec3f(0, 0, 1));
    for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(mesh.normals[i], Vec3f(0, 1, 0));
  }
  EXPECT_EQ(parse(folded + "f 1 2 3\nusemtl x\ns 1\nf 1 4 2\n").meshes[0].positions.size(), 4u);
}

TEST(Unit_Obj, MissingNormalsMayStayMissing) {
  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = MtlUse::Ignore;
  options.smooth_missing_normals = false;
  const ObjModel model = parse_obj("x.obj", folded + "f 1 2 3\n", options, diagnostics);
  EXPECT_TRUE(model.meshes[0].normals.empty());
}

TEST(Unit_Obj, ZeroAndExtremeNormalsStayUsable) {
  const ObjModel model = parse(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 1e-300 0 0\nvn 0 -1e300 1e300\nf 1//1 2//2 3//3\n");
  EXPECT_EQ(model.meshes[0].normals, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, -1, 1}}));
}

TEST(Unit_Obj, QuadsTakeTheShorterDiagonal) {
  const ObjModel model = parse("v 0 0 0\nv 1 -3 0\nv 2 0 0\nv 1 3 0\nf 1 2 3 4\n");
  EXPECT_EQ(model.meshes[0].triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Unit_Obj, ABowIsUntiedInTheDirectionOfItsNormals) {
  for (const double side : {1.0, -1.0}) {
    Diagnostics said;
    const ObjModel model = parse(
        fmt::format("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 {}\nf 1//1 2//1 3//1 4//1\n", side),
        MtlUse::Ignore, &said);
    ASSERT_EQ(said.list().size(), 1u);
    EXPECT_EQ(said.list()[0].message,
              "1 quad's edges cross; the corners are taken in the order in which they do not");
    EXPECT_EQ(said.list()[0].span.line, 6u);
    const Mesh& mesh = model.meshes[0];
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3d cross_product =
          cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      EXPECT_GT(cross_product.z * side, 0.0);
      area += std::abs(cross_product.z) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 1.0);
  }
}

// Lines on both sides of the stretches that are parsed in parallel.
TEST(Unit_Obj, LargeFilesReadAsSmallOnes) {
  std::string text;
  constexpr int count = 120'000;
  for (int i = 0; i < count; ++i) {
    text += fmt::format("v {} {} {}\n", i, i % 7, -i);
    if (i % 3 == 2)
      text += i % 2 == 0 ? "f -3 -2 \\\n-1\n" : fmt::format("f {} {} {}\n", i - 1, i, i + 1);
    if (i % 1000 == 0) text += "g part # next\n";
  }
  ASSERT_GT(text.size(), 2u << 20);
  const Mesh mesh = std::move(parse(text).meshes.at(0));
  ASSERT_EQ(mesh.triangles.size(), count / 3u);
  ASSERT_EQ(mesh.positions.size(), std::size_t{count});
  for (int i = 0; i < count; ++i) {
    ASSERT_EQ(mesh.positions[static_cast<std::size_t>(i)], Vec3d(i, i % 7, -i));
  }
}

const std::string two_materials =
    "newmtl red: one\nKd 1 0 0\nnewmtl unused\nnewmtl blue\nKd 0 0 1\nmap_Kd tex\\Brick.PNG\n";

TEST(Unit_Obj, MakesAMeshForEachMaterialWithFacesInTheOrderOfTheMtl) {
  const TemporaryFolder folder;
  folder.put("my materials.MTL", two_materials);
  std::filesystem::create_directories(folder.file("TEX"));
  folder.put("TEX/brick.png", std::string("x"));
  const std::string obj = folder.put(
      "a.obj",
      "mtllib My Materials.mtl\n" + square +
          "usemtl blue\nf 1 2 3\nusemtl red: one\nf 1 2 4\ng other\nusemtl blue\nf 1 3 4\n");
  Diagnostics diagnostics;
  description::SceneDescription scene;
  scene.materials.resize(5);
  scene.images.push_back(
      {"before.png", description::Encoding::Linear, description::Wrap::Repeat, {}});
  const auto handles = append_obj(obj, {}, scene, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list().size(), 2u);  // two spellings
  ASSERT_EQ(handles.size(), 2u);
  const Mesh& red = scene.meshes[handles[0].index];
  const Mesh& blue = scene.meshes[handles[1].index];
  EXPECT_EQ(red.name, "red: one");
  EXPECT_EQ(red.triangles.size(), 1u);
  EXPECT_EQ(red.materials, std::vector{description::MaterialHandle(5)});
  EXPECT_EQ(blue.name, "blue");
  EXPECT_EQ(blue.triangles.size(), 2u);
  EXPECT_EQ(blue.positions.size(), 4u);  // shared across groups
  EXPECT_EQ(blue.materials, std::vector{description::MaterialHandle(7)});
  ASSERT_EQ(scene.materials.size(), 8u);
  const auto& lab = std::get<description::LabMaterial>(scene.materials[7].model);
  ASSERT_EQ(scene.images.size(), 2u);
  EXPECT_EQ(scene.images[lab.diffuse.map.index].path, folder.file("TEX/brick.png"));
  EXPECT_EQ(scene.files, (std::vector<std::string>{obj, folder.file("my materials.MTL")}));
}

// Names go on to the end of the line, blanks, '#' and all; comments behind them do not count.
TEST(Unit_Obj, CommentsMayStandBehindNames) {
  const TemporaryFolder folder;
  folder.put("a.mtl", std::string("newmtl red # pure\nmap_Kd a.png # one\nnewmtl Material #25\n"
                                  "map_Kd b # c.png\nnewmtl Wood # 2\nnewmtl Wood # 3\n"));
  folder.put("b # c.png", std::string("x"));
  const std::string obj =
      folder.put("x.obj", "mtllib a.mtl # materials\nmtllib a.mtl #likewise\n" + square +
                              "usemtl red # the red one\nf 1 2 3\nusemtl Material #25\nf 1 2 4\n"
                              "usemtl Wood # 3\nf 1 3 4\n");
  Diagnostics diagnostics;
  const ObjModel model = read_obj(obj, {}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  ASSERT_EQ(model.meshes.size(), 3u);
  std::vector<std::string> worn;
  for (const Mesh& mesh : model.meshes) worn.push_back(mesh.name);
  EXPECT_EQ(worn, (std::vector<std::string>{"red # pure", "Material #25", "Wood # 3"}));
  ASSERT_EQ(model.images.size(), 2u);
  EXPECT_EQ(model.images[0].path, folder.file("a.png"));
  EXPECT_EQ(model.images[1].path, folder.file("b # c.png"));
}

// Beside a.mtl of two_materials.
ObjModel read_with_materials(const std::string& text) {
  const TemporaryFolder folder;
  folder.put("a.mtl", two_materials);
  Diagnostics diagnostics;
  ObjModel model = read_obj(folder.put("x.obj", text), {}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  return model;
}

TEST(Unit_Obj, NamesMayStandInTheNextLine) {
  const ObjModel model =
      read_with_materials("mtllib \\\na.mtl\n" + square + "usemtl \\\nblue\nf 1 2 3\n");
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].name, "blue");
}

TEST(Unit_Obj, AnMtlIsReadOnceByAnyNameOfIt) {
  const ObjModel model =
      read_with_materials("mtllib ./a.mtl\nmtllib a.mtl\n" + square + "usemtl blue\nf 1 2 3\n");
  EXPECT_EQ(model.materials.size(), 3u);
}

// Lines that end as on old Macs, but for the last, which an editor of today has added.
TEST(Unit_Obj, OldLinesEndsMayBeMixed) {
  EXPECT_EQ(parse("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r\n").meshes[0].triangles.size(), 1u);
}

TEST(Unit_Obj, EqualImagesOfSeveralFilesAreOne) {
  const TemporaryFolder folder;
  folder.put("a.mtl", two_materials);
  folder.put("b.mtl", two_materials + "map_Bump tex/Brick.PNG\n");
  description::SceneDescription scene;
  Diagnostics diagnostics;
  for (const std::string name : {"a", "b"}) {
    const std::string obj =
        folder.put(fmt::format("{}.obj", name),
                   fmt::format("mtllib {}.mtl\n{}usemtl blue\nf 1 2 3\n", name, square));
    append_obj(obj, {}, scene, diagnostics);
  }
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(scene.images.size(), 2u);  // the second as a height map is linear
}

TEST(Unit_Obj, OneMtllibMayNameSeveralFiles) {
  const TemporaryFolder folder;
  folder.put("a.mtl", std::string("newmtl a\nmap_Kd 1.png\n"));
  folder.put("b.mtl", std::string("newmtl b\nmap_Kd 2.png\nbump 2.png\n"));
  const std::string obj = folder.put("x.obj", "mtllib a.mtl b.mtl\nmtllib a.mtl\n" + square +
                                                  "usemtl b\nf 1 2 3\nusemtl a\nf 1 2 4\n");
  Diagnostics diagnostics;
  const ObjModel model = read_obj(obj, {}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.meshes[0].name, "a");
  ASSERT_EQ(model.materials.size(), 2u);
  EXPECT_EQ(model.images.at(model.materials[1].height.index).path, folder.file("2.png"));
}

// A byte order mark, and lines that end by carriage returns alone.
TEST(Unit_Obj, AnMtlIsReadAsItsEditorLeftIt) {
  const TemporaryFolder folder;
  std::string old_mac = two_materials;
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  for (const std::string& text : {"\xEF\xBB\xBF" + std::string(two_materials), old_mac}) {
    folder.put("a.mtl", text);
    const std::string obj =
        folder.put("a.obj", "mtllib a.mtl\n" + square + "usemtl blue\nf 1 2 3\n");
    Diagnostics diagnostics;
    const ObjModel model = read_obj(obj, {}, diagnostics);
    EXPECT_TRUE(diagnostics.list().empty()) << diagnostics.list().front().message;
    ASSERT_EQ(model.materials.size(), 3u);
    EXPECT_EQ(model.materials[0].name, "red: one");
    EXPECT_EQ(model.meshes.size(), 1u);
  }
}

TEST(Unit_Obj, FacesWithoutAMaterialAreDroppedInLabModeAndGreyInFullMode) {
  const TemporaryFolder folder;
  folder.put("a.mtl", two_materials);
  const std::string text =
      "mtllib a.mtl\n" + square + "f 1 2 3\nf 1 2 4\nusemtl blue\nf 1 3 4\nusemtl blur\nf 1 2 4\n";
  Diagnostics lab;
  const ObjModel model = parse_obj(folder.file("a.obj"), text, {}, lab);
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].triangles.size(), 1u);
  ASSERT_EQ(lab.list().size(), 2u);
  EXPECT_EQ(lab.list()[0].message, "material 'blur' is not in the MTL, did you mean 'blue'?");
  EXPECT_EQ(
      lab.list()[1].message,
      "3 faces without a material are dropped, from here on; expected 'usemtl' with a material "
      "of the MTL before");
  EXPECT_EQ(lab.list()[1].span.line, 11u);

  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = MtlUse::Full;
  const ObjModel full = parse_obj(folder.file("a.obj"), text, options, diagnostics);
  ASSERT_EQ(full.meshes.size(), 2u);
  EXPECT_EQ(full.meshes[1].triangles.size(), 3u);
  EXPECT_EQ(full.materials[full.meshes[1].materials[0].index].name, "(no material)");
  options.material = description::MaterialHandle(3);
  const ObjModel given = parse_obj(folder.file("a.obj"), text, options, diagnostics);
  EXPECT_TRUE(given.meshes[1].materials.empty());
}

TEST(Unit_Obj, IgnoreModeTakesTheGivenMaterialAndOpensNoMtl) {
  const TemporaryFolder folder;
  const std::string obj =
      folder.put("a.obj", "mtllib absent.mtl\n" + square + "usemtl x\nf 1 2 3\nf 1 3 4\n");
  description::SceneDescription scene;
  Diagnostics diagnostics;
  ObjOptions options;
  options.materials = MtlUse::Ignore;
  options.material = description::MaterialHandle(9);
  const auto handles = append_obj(obj, options, scene, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  ASSERT_EQ(handles.size(), 1u);
  EXPECT_EQ(scene.meshes[0].materials, std::vector{options.material});
}

TEST(Unit_Obj, APolygonOf200000CornersIsRead) {
  std::string text;
  constexpr int count = 200'000;
  for (int i = 0; i < count; ++i) {
    const double angle = 2e-5 * i;
    text +=
        fmt::format("v {} {} 0\n", std::cos(angle) * (i % 2 + 1), std::sin(angle) * (i % 2 + 1));
  }
  text += 'f';
  for (int i = 1; i <= count; ++i) text += fmt::format(" {}", i);
  EXPECT_EQ(parse(text).meshes[0].triangles.size(), count - 2u);
}

}  // namespace
}  // namespace candela::obj
