// tools/bench cycles, without Blender: what it hands to Blender is the scene that candela renders,
// and its statistics see what differs and nothing else.
#include <numbers>

#include "tests/tools/cycles_questions.h"

namespace candela::cli_test {
namespace {

const std::string blocks = CANDELA_SOURCE_DIR "/tools/benchmarks/blender/scenes/";

class Unit_CyclesComparison : public CyclesQuestions {};

// The camera's matrix and angle, the meshes' transforms: where candela sees a point, the camera
// that Blender gets sees it too, and it lies on a triangle that Blender gets.
TEST_F(Unit_CyclesComparison, TheCameraSeesWhatCandelasSees) {
  const std::string folder = fresh_folder("positions");
  for (const std::string& scene :
       {blocks + "point_lit.yaml",
        std::string(CANDELA_SOURCE_DIR "/assets/cornell_box_diffuse/cornell_box_diffuse.yaml")}) {
    const std::string exr = folder + "/positions.exr";
    ASSERT_EQ(run_candela({"render", scene, "-o", exr, "--size", "24x16", "--spp", "1", "--filter",
                           "box", "--aov", "position,depth", "--quiet"})
                  .exit_code,
              0);
    const Json found = ask({"positions", scene, exr});
    EXPECT_GT(found["count"], 150) << scene;
    EXPECT_LE(found["pixels"], 0.501) << scene;
    EXPECT_GT(found["pixels"], 0.4) << scene;  // box-filtered samples fill their pixels
    EXPECT_LT(found["off_surface"], 1e-6) << scene;
  }
}

TEST_F(Unit_CyclesComparison, LightsAreInPhysicalUnitsAndBlendersAxes) {
  constexpr double pi = std::numbers::pi;
  const Json point = ask({"scene", blocks + "point_lit.yaml", "2"})["lights"][0];
  EXPECT_EQ(point["type"], "POINT");
  const std::vector<double> position{1.8, -2.2, 5.4};                  // twice (1.1, 2.7, -.9)
  const std::vector<double> intensity{24 * pi, 21.6 * pi, 16.8 * pi};  // four times pi I
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(point["position"][i], position[i], 1e-12);
    EXPECT_NEAR(point["radiant_intensity"][i], intensity[i], 1e-12);
  }
  const Json sun = ask({"scene", blocks + "sun_lit.yaml", "2"})["lights"][0];
  const double length = std::sqrt(1.4 * 1.4 + 1.1 * 1.1 + 0.5 * 0.5);
  const std::vector<double> towards{-0.5 / length, 1.4 / length, 1.1 / length};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(sun["towards"][i], towards[i], 1e-12);
  EXPECT_NEAR(sun["irradiance"][0], 1.2 * pi, 1e-12);
}

TEST_F(Unit_CyclesComparison, OnlyTheWallThatIsNotPlaneHasNormalsOfItsOwn) {
  const Json scene =
      ask({"scene", CANDELA_SOURCE_DIR "/assets/cornell_box_diffuse/cornell_box_diffuse.yaml"});
  for (const Json& mesh : scene["meshes"])
    EXPECT_EQ(mesh["normals"].is_null(), mesh["name"] != "green_wall") << mesh["name"];
}

TEST_F(Unit_CyclesComparison, WhatIsNotComparedIsRefused) {
  EXPECT_EQ(
      ask({"refused", CANDELA_SOURCE_DIR "/assets/cornell_box/cornell_box.yaml"}),
      "material 'brushed_steel': of cook_torrance only F0: 1 with kd: 0 and geometry: smith is "
      "compared");
  EXPECT_EQ(ask({"refused", CANDELA_SOURCE_DIR "/assets/glass_and_metal/glass_and_metal.yaml"}),
            "material 'floor': 'kd_map' is not compared; expected only Name, Type, kd, Emission, "
            "TwoSided");
  EXPECT_TRUE(ask({"refused", blocks + "sun_lit.yaml"}).is_null());
}

// Instances that are turned, stretched and moved, of a model that has a place of its own; and what
// Blender is told of materials.
TEST_F(Unit_CyclesComparison, InstancesLieWhereCandelasLie) {
  const std::string folder = fresh_folder("instances");
  std::filesystem::copy(CANDELA_SOURCE_DIR "/assets/glass_and_metal/cube.obj", folder);
  const std::string scene = folder + "/scene.yaml", exr = folder + "/positions.exr";
  write_text(scene, R"(
Cameras: [{Eye: [1, 3, 6], Target: [0, 0, 0], Fovy: 50}]
Environment: {Radiance: [1, 2, 3], Scale: 2}
Materials:
  - {Name: mirror, Type: mirror, kd: .9}
  - {Name: metal, Type: cook_torrance, kd: 0, ks: .8, F0: 1, geometry: smith, roughness: .09}
  - {Name: glass, Type: dielectric, ior: 1.4}
Models:
  - Mesh: cube.obj
    Material: mirror
    Translation: [.2, 0, 0]
    Scale: [1, .5, 1]
    Instances:
      - {Translation: [-1.5, 0, 0], Rotation: [[.8, 0, .6], [0, 1, 0], [-.6, 0, .8]]}
      - {Translation: [1, .3, -.5], Scale: [1, 3, .6]}
  - {Mesh: cube.obj, Material: metal, Translation: [0, -1, 0], Scale: [9, .1, 9]}
  - {Mesh: cube.obj, Material: glass, Translation: [0, 0, 2], Scale: [.5, .5, .5]}
)");
  ASSERT_EQ(run_candela({"render", scene, "-o", exr, "--size", "24x16", "--spp", "1", "--filter",
                         "box", "--aov", "position,depth", "--quiet"})
                .exit_code,
            0);
  const Json found = ask({"positions", scene, exr});
  EXPECT_GT(found["count"], 150);
  EXPECT_LE(found["pixels"], 0.501);
  EXPECT_LT(found["off_surface"], 1e-6);
  const Json described = ask({"scene", scene});
  const Json& meshes = described["meshes"];
  EXPECT_EQ(described["environment"]["scale"], (Json{2.0, 4.0, 6.0}));
  EXPECT_EQ(meshes[0]["surface"], "glossy");
  EXPECT_EQ(meshes[0]["roughness"], 0);
  EXPECT_NEAR(meshes[1]["roughness"], 0.3, 1e-12);  // Cycles squares it
  EXPECT_EQ(meshes[1]["albedo"], (Json{0.8, 0.8, 0.8}));
  EXPECT_EQ(meshes[2]["surface"], "glass");
  EXPECT_EQ(meshes[2]["ior"], 1.4);
}

// What candela converts is read as what it was made of: camera, lights, lamps, meshes, units.
TEST_F(Unit_CyclesComparison, PbrtFilesAreTheScenesThatTheyWereMadeOf) {
  const std::string folder = fresh_folder("made_of"), file = folder + "/scene.pbrt";
  const std::string box = CANDELA_SOURCE_DIR "/assets/cornell_box_diffuse/";
  // A wall that is not plane has normals of its own, which stretching turns; mirrored besides.
  write_text(folder + "/stretched.yaml", R"(
Cameras: [{Eye: [1, 3, 6], Target: [0, 0, 0], Fovy: 50}]
Environment: {Radiance: [1, 2, 3]}
Materials:
  - {Name: glass, Type: dielectric, ior: 1.4}
Models:
  - Mesh: )" + box + R"(green_wall.obj
    Material: glass
    Scale: [.004, .02, -.005]
    Rotation: [[.8, 0, .6], [0, 1, 0], [-.6, 0, .8]]
    Translation: [.2, 0, 1]
)");
  for (const std::string& scene : {blocks + "point_lit.yaml", blocks + "sun_lit.yaml",
                                   box + "cornell_box_diffuse.yaml", folder + "/stretched.yaml"}) {
    ASSERT_EQ(run_candela({"convert", scene, file}).exit_code, 0);
    const Json apart = ask({"apart", scene, file, "2"});
    ASSERT_TRUE(apart.is_number()) << scene;
    EXPECT_LT(apart, 2e-6) << scene;  // normals are floats in the file's meshes
  }
}

// Lamps face where ReverseOrientation and mirroring transforms turn them: what Blender is told is
// what candela's camera sees.
TEST_F(Unit_CyclesComparison, PbrtLampsShineWhereCandelasDo) {
  const std::string folder = fresh_folder("pbrt_lamps");
  std::string scene = R"(LookAt .5 1.5 6  0 .6 0  .1 1 0
Scale -1 1 1
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 48 "integer yresolution" 32 "float iso" 200
WorldBegin
Material "diffuse" "rgb reflectance" [ .5 .4 .3 ]
Shape "bilinearmesh" "point3 P" [ -8 -.5 8   8 -.5 8   -8 -.5 -8   8 -.5 -8 ]
Material "diffuse" "rgb reflectance" [ 0 0 0 ]
)";
  for (const char* lamp :
       {"[ 1 2 3 ] Translate -2 0 0", "[ 2 3 4 ] ReverseOrientation Translate -1 0 0",
        "[ 3 4 5 ] Scale 1 1 -2", "[ 4 5 6 ] Translate 1 0 0 Scale -1 1 1",
        "[ 5 6 7 ] \"bool twosided\" true ReverseOrientation Translate 2 0 0"})
    scene += fmt::format(R"(AttributeBegin AreaLightSource "diffuse" "rgb L" {}
  Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ]
    "point3 P" [ -.4 0 0  .4 0 0  .4 .8 0  -.4 .8 0 ]
AttributeEnd
)",
                         lamp);
  write_text(folder + "/scene.pbrt", scene);
  const std::string file = folder + "/plain.pbrt", exr = folder + "/picture.exr";
  ASSERT_EQ(run_candela({"convert", folder + "/scene.pbrt", file}).exit_code, 0);
  ASSERT_EQ(run_candela({"render", file, "-o", exr, "--spp", "1", "--filter", "box", "--aov",
                         "position,depth", "--quiet"})
                .exit_code,
            0);
  const Json found = ask({"positions", file, exr});
  EXPECT_GT(found["count"], 800);
  EXPECT_LE(found["pixels"], 0.501);
  EXPECT_LT(found["off_surface"], 1e-6);
  const Json lamps = ask({"lamps", file, exr});
  const std::vector<bool> faces{true, false, false, true, false};
  ASSERT_EQ(lamps.size(), faces.size());
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    EXPECT_EQ(lamps[i]["faces"], faces[i]) << i;
    EXPECT_EQ(lamps[i]["two_sided"], i == 4) << i;
    for (std::size_t c = 0; c < 3; ++c) {
      const double radiance = 2.0 * static_cast<double>(1 + i + c);  // iso doubles all light
      EXPECT_NEAR(lamps[i]["shines"][c], radiance, 1e-12) << i;
      EXPECT_NEAR(lamps[i]["seen"][c], faces[i] || i == 4 ? radiance : 0, 1e-5) << i;
    }
  }
}

TEST_F(Unit_CyclesComparison, WhatIsNotComparedOfPbrtFilesIsRefused) {
  const std::string file = fresh_folder("pbrt_refused") + "/scene.pbrt";
  const std::string view = "Scale -1 1 1\nLookAt 0 0 5  0 0 0  0 1 0\n";
  const std::string camera = "Camera \"perspective\" \"float fov\" 40\n";
  const auto reason = [&](const std::string& text) {
    write_text(file, text);
    return ask({"refused", file});
  };
  EXPECT_TRUE(reason(view + camera).is_null());
  EXPECT_EQ(reason("LookAt 0 0 5  0 0 0  0 1 0\n" + camera),
            "a camera that mirrors the picture; Blender's do not");
  EXPECT_EQ(reason(view + "Camera \"perspective\" \"float fov\" 40 \"float lensradius\" 0.1"),
            "the camera: 'float lensradius' is not compared; expected only float fov, float fovy");
  EXPECT_EQ(reason("MakeNamedMaterial \"steel\" \"string type\" \"conductor\"\n" + view + camera),
            "material 'steel' is of the type conductor, which has no exact counterpart in Cycles; "
            "only diffuse and dielectric are compared");
  EXPECT_EQ(reason(view + camera + "AttributeBegin\nShape \"sphere\" \"float radius\" 1\n"),
            "a shape of the type sphere; expected plymesh");
  EXPECT_EQ(reason(view + camera + "ObjectBegin \"tree\"\n"), "ObjectBegin is not compared");
  EXPECT_EQ(reason("Integrator \"path\" \"integer maxdepth\" 5 # bounces\n"
                   "  #candela: \"rgb ambient\" [ 1 1 1 ]\n" +
                   view + camera),
            "Integrator: 'rgb ambient' is not compared; expected only integer maxdepth, bool "
            "unlimited");
  EXPECT_EQ(reason(""), "the scene has no camera");
}

TEST_F(Unit_CyclesComparison, TimesAreReadFromBlendersLog) {
  const std::string log = fresh_folder("log") + "/blender.log";
  write_text(log,
             "CPU seconds: 0.250000\nCPU seconds: 1.500000\n"
             "I1121 session.cpp:464] Total render time: 0.76\n"
             "I1121 session.cpp:465] Render time (without synchronization): 0.496396\n"
             "I1121 session.cpp:465] Render time (without synchronization): 5.1e-05\n");
  EXPECT_EQ(ask({"times", log}), (Json{{0.496396, 5.1e-05}, {0.25, 1.5}}));
}

TEST_F(Unit_CyclesComparison, DifferencesAreSeenAndNoiseIsNot) {
  const Json equal = ask({"pictures", "1", "0"});
  EXPECT_EQ(equal["failures"].size(), 0u) << equal;
  EXPECT_NEAR(equal["black_p"], 1, 1e-9);
  for (const double spread : equal["spread"]) EXPECT_NEAR(spread, 1, 0.35);
  // The block's mean has a standard error of .1 sqrt(2 / (8 * 64)) = .00625.
  const Json shifted = ask({"pictures", "1", "0.08"});
  ASSERT_GE(shifted["failures"].size(), 3u) << shifted;
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_EQ(shifted["failures"][c].get<std::string>().find("block 2, 1 of "), 0u) << shifted;
}

TEST_F(Unit_CyclesComparison, FormulasHaveTheirKnownValues) {
  // Tables of Student's t, two-sided.
  EXPECT_NEAR(ask({"tail", "2.228139", "10"}), 0.05, 1e-6);
  EXPECT_NEAR(ask({"tail", "4.587", "10"}), 0.001, 1e-6);
  EXPECT_NEAR(ask({"tail", "1", "1"}), 0.5, 1e-9);
  EXPECT_NEAR(ask({"tail", "0", "7.5"}), 1, 1e-9);
  // The form factor of a rectangle a by b over a point below its corner at the distance 1, times
  // pi.
  const double a = 2, b = 0.5, p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  EXPECT_NEAR(ask({"corner_irradiance", "2", "0.5", "1"}),
              (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / 2, 1e-12);
}

TEST_F(Unit_CyclesComparison, SamplesTakenAreReadFromBlendersLog) {
  const std::string log = fresh_folder("log") + "/blender.log";
  write_text(log,
             "Fra:1 | Scene, ViewLayer | Sample 0/4096\n"
             "Fra:1 | Scene, ViewLayer | Sample 704/4096\n"
             "Fra:1 | Scene, ViewLayer | Sample 0/4096\nSaved: '/a b.exr'\n"
             "Fra:1 | Scene, ViewLayer | Sample 48/4096\nSaved: '/c.exr'\n");
  EXPECT_EQ(ask({"samples", log}), (Json{{"/a b.exr", 704}, {"/c.exr", 48}}));
}

}  // namespace
}  // namespace candela::cli_test
