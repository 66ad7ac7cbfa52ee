// Spoiled copies of a scene that uses every key: each must end, in a scene that validates or in
// errors that say where.
#include <cstdlib>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

constexpr std::string_view everything = R"(Reflection: Empirical
AmbientIntensity: [0.05, 0.05, 0.05]
Skyboxes:
  - ["rt.png", "lt.png", "up.png", "dn.png", "ft.png", "bk.png"]
Render: {Width: 64, Height: 48, SamplesPerPixel: 4, MaxDepth: none, Integrator: path,
  Filter: box, Seed: 1, Exposure: .5}
Cameras:
  - &camera
    Eye: [0, 2, 4]
    Target: [0, 0, 0]
    Up: [0, 1, 0]
    Fovy: 45.5
    ZNear: 0.1
    ZFar: 1e2
    LensRadius: .1
    FocusDistance: 4
  - *camera
Lights:
  # a comment
  - Type: Point
    Position: [0, 5, 0]
    Intensity: [1e5, 1e5, 1e5]
  - {Type: Directional, Direction: [2, 1, .8], Intensity: [2, 2, 1.5]}
  - {Type: Spot, Direction: [0, 1, 0], CutOff: 20, OuterCutOff: 30}
  - Type: Area
    p0: [0, 0, 0]
    p1: [1, 0, 0]
    p2: [0, 1, 0]
    Direction: [0, 0, -1]
    TwoSided: false
Materials:
  - Name: lab
    Blend: Opaque
    Diffuse: [.5, .5, .5, 1]
    Specular: [.4, .4, .4, 32.]
    Shininess: 64
    HeightMap: picture.png
  - Name: "mapped"
    AlbedoMap: picture.png
    MetallicMap: 'other.png'
  - {Name: steel, Type: cook_torrance, kd: .2, ks: [.8, .8, .8], roughness: .3, fresnel: exact,
     geometry: smith, metal: iron}
  - {Name: wall, Type: diffuse, kd_map: picture.png, opacity_map: other.png, normal_map: rt.png}
  - {Name: mirror, Type: mirror, Reflectance: .9}
  - {Name: gold, Type: conductor, eta: [.2, .5, 1.3], k: [3.4, 2.2, 1.9], roughness: .1}
  - {Name: glass, Type: dielectric, ior: 1.5, transmittance: [1, .9, .8]}
  - {Name: pane, Type: thin_dielectric, ior: 1.5}
  - {Name: lamp, Type: diffuse, kd: 0, Emission: [17, 12, 4], TwoSided: true}
Models:
  - Mesh: triangle.obj
    Material: lab
    Translation: [0.1, -1, 0]
    Scale: [10, 10, 10]
    Rotation: [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]
  - Mesh: triangle.ply
    Material: lamp
    Instances: [{Translation: [1, 0, 0]}, {Scale: [2, 2, 2]}]
  - {Mesh: quad.obj, Material: glass}
ComplexModels:
  - Mesh: with_mtl.obj
)";

constexpr std::string_view fragments[] = {
    "&a ",  "*camera", "{",     "}",          "[",      "]",     ": ",    "- ",      "\n",
    "\n  ", "? ",      "|",     "> ",         "'",      "\"",    "!!str", "%YAML 1", "---\n",
    "...",  "#",       "~",     ".nan",       "-.inf",  "1e999", "-",     "\t",      "\xef\xbb\xbf",
    "\xff", "\\",      "<<: *", ",",          "0x10",   "!",     "@",     "`",       "|2-\n",
    ">-9",  "\"\\u12", "\r",    "\r\n",       "0",      "1e30",  "1e-40", "\"\\x",   "[[[[[[[[[[",
    "%TAG", "camera",  "Type:", "picture.pn", "folder", "pipe",  ".",     "e",       "9999999999"};

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (std::size_t i = 1 + below(4); i > 0 && !text.empty(); --i) mutate(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  void mutate(std::string& text) {
    const std::size_t at = below(text.size());
    const std::string_view fragment = fragments[below(std::size(fragments))];
    switch (below(7)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, fragment);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), below(80)));
        break;
      case 4:
        text.resize(at);
        break;
      case 5:
        text.replace(at, fragment.size(), fragment);
        break;
      default:
        std::swap(text[at], text[below(text.size())]);
    }
  }

  std::mt19937_64 random_;
};

void expect_sound(const Result<description::SceneDescription>& result, const std::string& text) {
  if (!result) {
    ASSERT_TRUE(result.diagnostics.has_errors()) << text;
    for (const Diagnostic& diagnostic : result.diagnostics.list())
      ASSERT_FALSE(diagnostic.message.empty()) << text;
    return;
  }
  const Diagnostics problems = description::validate(*result);
  for (const Diagnostic& problem : problems.list())
    ASSERT_NE(problem.severity, Severity::Error) << to_string(problem) << "\n" << text;
}

TEST(Unit_Lab3Mutations, TheScenesOwnTextIsFine) {
  // Area lights and glowing materials together, an overridden number: but no error.
  const auto result = test::parse_lab3_text(everything);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->materials.size(), 11u);
  EXPECT_EQ(result->lights.size(), 5u);
  EXPECT_EQ(result->cameras.size(), 2u);
  EXPECT_EQ(result->instances.size(), 6u);
  EXPECT_FALSE(description::validate(*result).has_errors());
}

TEST(Stress_Lab3Mutations, SpoiledScenesEndInASceneOrInErrors) {
  const int count = std::getenv("CANDELA_HEAVY") ? 200000 : 10000;
  Mutator mutator(20240607);
  int whole = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = mutator(std::string(everything));
    const auto result = test::parse_lab3_text(text);
    expect_sound(result, text);
    if (::testing::Test::HasFatalFailure()) return;
    whole += result ? 1 : 0;
  }
  // Both ways are taken often.
  EXPECT_GT(whole, count / 20);
  EXPECT_LT(whole, count * 19 / 20);
}

}  // namespace
}  // namespace candela
