// tools/bench peers --nearest, without Blender: what stands in for a pbrt file's metals, coats,
// textures, spheres and skies is near to what candela renders, and is told.
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/tools/cycles_questions.h"

namespace candela::cli_test {
namespace {

class Unit_CyclesNearest : public CyclesQuestions {};

const std::string view = R"(LookAt 0 0 5  0 0 0  0 1 0
Scale -1 1 1
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 32 "integer yresolution" 32
WorldBegin
)";

// What candela converts, in a folder of its own.
std::string converted(const std::string& name, const std::string& text) {
  const std::string folder = fresh_folder(name);
  write_text(folder + "/scene.pbrt", text);
  EXPECT_EQ(run_candela({"convert", folder + "/scene.pbrt", folder + "/plain.pbrt"}).exit_code, 0);
  return folder + "/plain.pbrt";
}

std::string rendered(const std::string& scene, std::vector<std::string> options) {
  const std::string exr = scene + ".exr";
  std::vector<std::string> words{"render", scene,     "-o",          exr,   "--filter",
                                 "box",    "--quiet", "--max-depth", "none"};
  words.insert(words.end(), options.begin(), options.end());
  EXPECT_EQ(run_candela(words).exit_code, 0);
  return exr;
}

const char* const surfaces = R"(
MakeNamedMaterial "gold" "string type" "conductor" "rgb eta" [ .2 .9 1.5 ] "rgb k" [ 3.9 2.5 1.6 ]
  "float roughness" .09 "bool remaproughness" false
MakeNamedMaterial "rough" "string type" "dielectric" "float roughness" .0081 "float eta" 1.4
MakeNamedMaterial "clear" "string type" "dielectric"
MakeNamedMaterial "coat" "string type" "coateddiffuse" "float roughness" 0
MakeNamedMedium "green" "string type" "homogeneous" "rgb sigma_a" [ .5 .2 .4 ] "rgb sigma_s" [ 0 0 0 ]
)";

TEST_F(Unit_CyclesNearest, MetalsGlassesAndMediaAreToldInBlendersTerms) {
  std::string text = view + surfaces;
  for (const char* name : {"gold", "rough", "coat"})
    text += "NamedMaterial \"" + std::string(name) +
            "\" Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]\n";
  text += R"(NamedMaterial "clear" MediumInterface "green" "" Shape "sphere" "float radius" .5)";
  const std::string file = converted("surfaces", text);
  EXPECT_NE(ask({"refused", file}).get<std::string>().find("has no exact counterpart"),
            std::string::npos);
  const Json scene = ask({"nearest", file, "2"});
  const Json& meshes = scene["meshes"];
  EXPECT_EQ(meshes[0]["surface"], "metal");
  EXPECT_NEAR(meshes[0]["roughness"], 0.3, 1e-12);  // Cycles squares it
  EXPECT_NEAR(meshes[0]["albedo"][1], (0.01 + 6.25) / (3.61 + 6.25), 1e-12);
  EXPECT_EQ(meshes[1]["surface"], "glass");
  EXPECT_NEAR(meshes[1]["roughness"], 0.3, 1e-6);  // the root of the root: pbrt remaps
  EXPECT_EQ(meshes[1]["ior"], 1.4);
  EXPECT_EQ(meshes[2]["roughness"], 0);
  EXPECT_EQ(meshes[3]["roughness"], 0);
  EXPECT_NEAR(meshes[3]["absorption"][0], 0.25, 1e-12);  // lengths are twice as long
  Json told;
  for (const Json& part : scene["approximated"]) told[part["what"]] = part["names"];
  EXPECT_EQ(told, (Json{{"metal by eta and k", {"gold"}},
                        {"rough glass", {"rough"}},
                        {"coat over a diffuse surface", {"coat"}},
                        {"sphere", {"clear"}}}));
}

// Turned, mirrored, enlarged: centre, radius and power; its radiance is what the camera sees.
TEST_F(Unit_CyclesNearest, SpheresThatShineAreLightsWithARadius) {
  const std::string file = converted("ball", view + R"(
Material "diffuse" "rgb reflectance" [ 0 0 0 ]
AttributeBegin AreaLightSource "diffuse" "rgb L" [ 1 2 3 ]
  Translate 1 2 3 Rotate 30 1 1 0 Scale -2 2 2 Shape "sphere" "float radius" .5
AttributeEnd
)");
  const Json scene = ask({"nearest", file, "3"});
  ASSERT_EQ(scene["meshes"].size(), 0u);
  const Json& light = scene["lights"][0];
  EXPECT_NEAR(light["radius"], 3, 1e-5);
  const std::vector<double> position{-9, -3, 6};  // Blender's axes: (-z, -x, y)
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(light["position"][i], position[i], 1e-5);
    EXPECT_NEAR(light["radiant_intensity"][i], 9 * std::numbers::pi * static_cast<double>(i + 1),
                1e-3);
  }
}

TEST_F(Unit_CyclesNearest, SpheresBecomeMeshesOfTheirAreaThatFaceOutwards) {
  const Json found = ask({"ball", "1.5"});
  EXPECT_NEAR(found["area"], 9 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(found["volume"], 4.5 * std::numbers::pi, 0.02);
  EXPECT_GT(found["least_outwards"], 0.99);  // cosine between a face's normal and its place
  EXPECT_LT(found["unclosed"], 1e-12);       // the sum of the faces' normals by their areas
  EXPECT_LT(found["normals"], 1e-12);
}

// What candela's camera sees of a checkerboard is what Blender's formula makes of the coordinates
// that Blender gets, also where a transform mirrors the mesh.
TEST_F(Unit_CyclesNearest, TexturesLieWhereCandelasLie) {
  const std::string file = converted("checks", view + R"(
Texture "floor" "spectrum" "checkerboard" "float uscale" 7 "float vscale" 3
  "rgb tex1" [ .1 .2 .3 ] "rgb tex2" [ .7 .6 .5 ]
Material "diffuse" "texture reflectance" "floor"
Shape "trianglemesh" "point3 P" [ -2 -2 -1  2 -2 0  2 0 0  -2 0 0 ]
  "integer indices" [ 0 1 2 0 2 3 ] "point2 uv" [ -1 0  1 0  1 1  -1 1.5 ]
Scale -1 1 1 Rotate 20 0 0 1
Shape "trianglemesh" "point3 P" [ -2 0.2 1  2 .2 0  2 2 0  -2 2 0 ]
  "integer indices" [ 0 1 2 0 2 3 ] "point2 uv" [ 0 0  1 .2  1 1  .3 1 ]
)");
  const std::string exr =
      rendered(file, {"--size", "48x48", "--spp", "1", "--aov", "albedo,position,depth"});
  const Json found = ask({"checks", file, exr});
  EXPECT_GT(found["dark"], 300);
  EXPECT_GT(found["light"], 300);
  EXPECT_EQ(found["wrong"], 0);
}

TEST_F(Unit_CyclesNearest, ImagesKeepTheirEncodingScaleAndEdge) {
  const std::string tiles = CANDELA_SOURCE_DIR "/assets/cutouts/tiles.png";
  const std::string file = converted("images", view + R"(
Texture "wall" "spectrum" "imagemap" "float uscale" 3 "string wrap" "clamp"
  "string filename" ")" + tiles + R"("
Material "diffuse" "texture reflectance" "wall"
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "point2 uv" [ 0 0  1 0  0 1 ]
)");
  const Json scene = ask({"nearest", file, "1"});
  const Json& image = scene["meshes"][0]["albedo"];
  EXPECT_EQ(image["colour_space"], "sRGB");
  EXPECT_EQ(image["beyond"], "EXTEND");
  EXPECT_EQ(image["uv_scale"], (Json{3, 1}));
  EXPECT_EQ(file_text(image["image"]), file_text(tiles));
  EXPECT_EQ(scene["meshes"][0]["uvs"], Json::parse("[[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]"));
}

// Cycles has black spots where one triangle lies in another's place. Back to back is no such pair.
TEST_F(Unit_CyclesNearest, TrianglesInOnePlaceAreGivenOnce) {
  const std::string file = converted("twins", view + R"(
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 0  1 0 0 ]
  "integer indices" [ 0 1 2  1 2 0  3 2 1  2 0 4  0 2 1 ]
)");
  const Json corners = ask({"scene", file})["meshes"][0]["corners"];
  ASSERT_EQ(corners.size(), 3u) << corners;
  EXPECT_EQ(corners[1][0], Json::parse("[0.0, -1.0, 1.0]"));  // (1, 1, 0) in Blender's axes
}

// Under light from everywhere a coated ball's middle shines as candela's: Fresnel's term and what
// comes from below, in the mean over the angles that light comes from: within 1 % (1.7 % where the
// width is .2, since Blender's Fresnel term knows the normal only).
TEST_F(Unit_CyclesNearest, CoatsLetAsMuchLightOutAsCandelas) {
  for (const char* width : {"0", ".05", ".1"}) {
    const std::string file = converted("coat", R"(LookAt 0 0 50  0 0 0  0 1 0
Scale -1 1 1
Camera "perspective" "float fov" .2
WorldBegin
LightSource "infinite" "rgb L" [ 1 1 1 ]
Material "coateddiffuse" "rgb reflectance" [ .3 .6 .9 ] "bool remaproughness" false
  "float roughness" )" + std::string(width) + R"(
Shape "sphere" "float radius" 1
)");
    const std::string exr = rendered(file, {"--size", "8x8", "--spp", "256"});
    const Json ours = ask({"mean", exr});
    const Json albedo = ask({"nearest", file, "1"})["meshes"][0]["albedo"];
    const double mirrored = 0.04;  // ((1.5 - 1) / (1.5 + 1))^2
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR((mirrored + (1 - mirrored) * albedo[c].get<double>()) / ours[c].get<double>(), 1,
                  0.01)
          << width << " " << c;
  }
}

// studio_files/sky.exr in it.
std::string sky_folder() {
  const std::string folder = fresh_folder("sky"), assets = CANDELA_SOURCE_DIR "/assets/";
  write_text(folder + "/studio.yaml",
             "Cameras: [{Eye: [0, 0, 5], Target: [0, 0, 0]}]\n"
             "Environment: {Map: " +
                 assets +
                 "glass_and_metal/studio.hdr}\n"
                 "Materials: [{Name: white, Type: diffuse}]\n"
                 "Models: [{Mesh: " +
                 assets + "glass_and_metal/cube.obj, Material: white}]\n");
  EXPECT_EQ(run_candela({"convert", folder + "/studio.yaml", folder + "/studio.pbrt"}).exit_code,
            0);
  return folder;
}

// Turned and mirrored: the map that Cycles looks up holds what candela's camera sees.
TEST_F(Unit_CyclesNearest, SkiesAreWhereCandelasAre) {
  const std::string folder = sky_folder();
  for (const char* turn : {"", "Rotate 50 1 2 3", "Scale 1 -1 1 Rotate 200 -1 1 1"}) {
    const std::string file = converted("turned_sky", R"(LookAt 0 0 0  3 -1 2  0 1 0
Scale -1 1 1
Camera "perspective" "float fov" 130
WorldBegin
)" + std::string(turn) + " LightSource \"infinite\" \"string filename\" \"" +
                                                         folder + "/studio_files/sky.exr\"");
    const Json found = ask({"sky", file, rendered(file, {"--size", "24x24", "--spp", "256"})});
    EXPECT_GT(found["contrast"], 0.5) << turn;
    EXPECT_LT(found["mean"], 0.01) << turn;
  }
}

// All of it in one picture, by Blender itself: means within 2 %, nine tenths of the blocks within 4
// %.
TEST_F(Unit_CyclesNearest, CyclesRendersWhatIsNear) {
  if (std::getenv("CANDELA_HEAVY") == nullptr) GTEST_SKIP() << "only with CANDELA_HEAVY=1";
  if (!std::filesystem::exists("/usr/bin/blender")) GTEST_SKIP() << "Blender is not installed";
  const std::string folder = sky_folder();
  const std::string file = converted("near", R"(LookAt 0 1.5 6  0 .7 0  0 1 0
Scale -1 1 1
Camera "perspective" "float fov" 40
WorldBegin
AttributeBegin Rotate -90 1 0 0 LightSource "infinite" "string filename" ")" +
                                                 folder +
                                                 R"(/studio_files/sky.exr" AttributeEnd
Texture "tiles" "spectrum" "imagemap" "string filename" ")" CANDELA_SOURCE_DIR
                                                 R"(/assets/cutouts/tiles.png"
Texture "checks" "spectrum" "checkerboard" "float uscale" 6 "float vscale" 3
  "rgb tex1" [ .1 .2 .3 ] "rgb tex2" [ .7 .6 .5 ]
MakeNamedMedium "green" "string type" "homogeneous" "rgb sigma_a" [ .9 .2 .6 ] "rgb sigma_s" [ 0 0 0 ]
Material "coateddiffuse" "texture reflectance" "tiles" "float roughness" .1 "bool remaproughness" false
Shape "trianglemesh" "point3 P" [ -3 0 3  3 0 3  3 0 -2  -3 0 -2 ]
  "integer indices" [ 0 1 2 0 2 3 ] "point2 uv" [ 0 0  2 0  2 2  0 2 ]
Material "diffuse" "texture reflectance" "checks"
Shape "trianglemesh" "point3 P" [ -3 0 -2  3 0 -2  3 3 -2  -3 3 -2 ]
  "integer indices" [ 0 1 2 0 2 3 ] "point2 uv" [ 0 0  1 0  1 1  0 1 ]
AttributeBegin Translate -1.6 .7 0
  Material "conductor" "rgb eta" [ .2 .9 1.1 ] "rgb k" [ 3.9 2.5 2.1 ] "float roughness" .1
  Shape "sphere" "float radius" .7 AttributeEnd
AttributeBegin Translate 0 .7 0
  Material "coateddiffuse" "rgb reflectance" [ .6 .3 .1 ] "float roughness" .005
  Shape "sphere" "float radius" .7 AttributeEnd
AttributeBegin Translate 1.6 .7 0
  Material "dielectric" MediumInterface "green" ""
  Shape "sphere" "float radius" .7 AttributeEnd
AttributeBegin Translate .8 2.2 .5 Material "diffuse" "rgb reflectance" [ 0 0 0 ]
  AreaLightSource "diffuse" "rgb L" [ 20 18 15 ] Shape "sphere" "float radius" .2 AttributeEnd
)");
  const std::string exr = rendered(file, {"--size", "64x64", "--spp", "1024"});
  const Json found = ask({"cycles_beside", file, exr, folder + "/cycles", "1024"});
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found["means"][c], 1, 0.02) << c;
  EXPECT_LT(found["blocks"][57], 0.04) << found["blocks"];
}

}  // namespace
}  // namespace candela::cli_test
