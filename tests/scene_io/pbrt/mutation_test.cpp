// Spoiled copies of a scene that uses every directive and most parameters: each must end, in a
// scene that validates or in errors that say where.
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/mutate.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

constexpr std::string_view everything = R"(Option "seed" 3
LookAt 0 1 5  0 0 0  0 1 0
Scale -1 1 1
Camera "perspective" "float fov" 45 "float lensradius" .1 "float focaldistance" 5
  "float screenwindow" [ -1 1 -1 1 ]
Film "rgb" "integer xresolution" 64 "integer yresolution" 48 "float iso" 200 # comment
PixelFilter "gaussian" "float xradius" 2
Sampler "halton" "integer pixelsamples" 4
Integrator "path" "integer maxdepth" 7
WorldBegin
Texture "map" "spectrum" "imagemap" "string filename" "picture.png" "float uscale" 2
Texture "half" "spectrum" "scale" "texture tex" "map" "float scale" .5
Texture "board" "spectrum" "checkerboard" "texture tex1" "half" "rgb tex2" [ 0 .5 1 ]
Texture "holes" "float" "imagemap" "string filename" "picture.exr" "bool invert" true
Texture "mixed" "float" "mix" "texture tex1" "holes" "float tex2" 1 "float amount" .25
MakeNamedMaterial "wall" "string type" "diffuse" "texture reflectance" "board"
MakeNamedMaterial "steel" "string type" "conductor" "rgb eta" [ .2 .9 1 ] "rgb k" [ 3 2 1 ]
  "float uroughness" .1 "float vroughness" .2 "bool remaproughness" false
MakeNamedMedium "fog" "string type" "homogeneous"
MakeNamedMaterial "both" "string type" "mix" "string materials" [ "wall" "steel" ]
  "texture amount" "mixed"
LightSource "goniometric" "string filename" "picture.png" "float power" 9
LightSource "projection" "string filename" "picture.exr" "float fov" 50
Texture "flat" "spectrum" "checkerboard" "string mapping" "planar" "vector3 v1" [ 1 0 2 ]
Texture "snow" "spectrum" "directionmix" "texture tex1" "flat" "vector3 dir" [ 0 1 1 ]
LightSource "distant" "point3 from" [ 0 0 9 ] "blackbody L" 5000
LightSource "infinite" "string filename" "picture.exr" "float scale" .5
AttributeBegin
  Rotate 30 0 1 0
  LightSource "spot" "rgb I" [ 1 2 3 ] "float coneangle" 20
  Attribute "shape" "float radius" .5 "float phimax" 10
  AreaLightSource "diffuse" "rgb L" [ 9 8 7 ] "bool twosided" true
  Shape "sphere"
AttributeEnd
NamedMaterial "wall"
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 0 ] "integer indices" [ 0 1 2 1 3 2 ]
  "point2 uv" [ 0 0 1 0 0 1 1 1 ] "normal N" [ 0 0 1 0 0 1 0 0 1 0 0 1 ] "texture alpha" "mixed"
ReverseOrientation
Shape "plymesh" "string filename" "triangle.ply"
ObjectBegin "thing"
  NamedMaterial "steel"
  Shape "loopsubdiv" "integer levels" 1 "integer indices" [ 0 1 2 ] "point3 P" [ 0 0 0 1 0 0 0 1 0 ]
  Material "coateddiffuse" "float roughness" .3 "texture displacement" "holes"
  Shape "bilinearmesh" "point3 P" [ 0 0 0  1 0 0  0 1 0  1 1 1 ]
ObjectEnd
CoordinateSystem "here"
Transform [ 1 0 0 0  0 1 0 0  0 0 1 0  3 0 0 1 ]
ObjectInstance "thing"
CoordSysTransform "here"
ObjectInstance "thing"
Material "diffuse" "texture reflectance" "snow"
Shape "disk"
NamedMaterial "both"
Shape "disk" "float radius" 2
Material "dielectric" "spectrum eta" "glass-BK7"
Include "world.pbrt"
Material "conductor" "rgb reflectance" [ .9 .8 .7 ]
  #candela: "string model" "mirror" "rgb mirror.reflectance" [ .9 .8 .7 ]
Shape "disk" "float radius" 2
MakeNamedMaterial "lab" "string type" "diffuse" "texture displacement" "holes"
  #candela: "string model" "lab" "float lab.shininess" 9 "texture heights" "holes" "float heightscale" 2
NamedMaterial "lab"
Shape "disk" "float radius" 3
Material "glass"
Shape "cylinder" "float zmax" 2
)";

TEST(Unit_PbrtMutations, TheScenesOwnTextIsFine) {
  const auto scene = test::pbrt_scene(everything);
  EXPECT_EQ(scene.instances.size(), 13u);
  EXPECT_EQ(scene.lights.size(), 5u);
  const Diagnostics problems = description::validate(scene);
  EXPECT_FALSE(problems.has_errors()) << to_string(problems.list().front());
}

TEST(Stress_PbrtMutations, SpoiledScenesEndInASceneOrInErrors) {
  Mutator mutate(20260101);
  const int count = mutation_count();
  int whole = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = mutate(std::string(everything));
    const auto scene = test::parse_pbrt_text(text);
    if (!scene) {
      ASSERT_TRUE(scene.diagnostics.has_errors()) << text;
      continue;
    }
    ++whole;
    const Diagnostics problems = description::validate(*scene);
    ASSERT_FALSE(problems.has_errors()) << to_string(problems.list().front()) << "\n" << text;
  }
  // Both ways are taken often.
  EXPECT_GT(whole, count / 50);
  EXPECT_LT(whole, count * 19 / 20);
}

}  // namespace
}  // namespace candela
