#include <cmath>

#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "scene_io/pbrt/shape.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using description::Mesh;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

Mesh mesh_of(const std::string& text) {
  const auto scene = pbrt_world(text);
  EXPECT_EQ(scene.meshes.size(), 1u) << text;
  return scene.meshes.empty() ? Mesh{} : scene.meshes[0];
}

Vec3d face_of(const Mesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += length(face_of(mesh, i)) / 2;
  return area;
}

// The least cosine between a triangle and the normals at its corners.
double agreement_of(const Mesh& mesh) {
  double least = 1;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t corner : mesh.triangles[i])
      least = std::min(least, dot(normalize(face_of(mesh, i)), Vec3d(mesh.normals[corner])));
  return least;
}

TEST(Unit_PbrtShapes, SpheresHaveTheirAreaAndPointOutwards) {
  const Mesh mesh = mesh_of("Scale 1 1 2 Shape \"sphere\" \"float radius\" 3");
  EXPECT_NEAR(area_of(mesh), 4 * pi_double * 9, 1e-9);
  EXPECT_GT(agreement_of(mesh), 0.999);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    ASSERT_LT(length(normalize(mesh.positions[i]) - Vec3d(mesh.normals[i])), 1e-6);
  // u goes around from +x over +y, v from the lower pole to the upper one.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d p = normalize(mesh.positions[i]);
    ASSERT_NEAR(p.z, -std::cos(pi_double * mesh.uvs[i].y), 1e-6);
    const double u = 2 * pi_double * mesh.uvs[i].x;
    ASSERT_NEAR(p.x, std::sqrt(1 - p.z * p.z) * std::cos(u), 1e-5);
    ASSERT_NEAR(p.y, std::sqrt(1 - p.z * p.z) * std::sin(u), 1e-5);
  }
}

// u goes around as the sphere's does.
TEST(Unit_PbrtShapes, DisksAndCylindersAreCoveredOnce) {
  const Mesh disk = mesh_of("Shape \"disk\" \"float radius\" 2 \"float innerradius\" 1");
  for (std::size_t i = 0; i < disk.positions.size(); ++i) {
    const double u = 2 * pi_double * disk.uvs[i].x;
    const double radius = 2 - disk.uvs[i].y;  // v goes from the rim inwards
    ASSERT_NEAR(disk.positions[i].x, radius * std::cos(u), 2e-3);
    ASSERT_NEAR(disk.positions[i].y, radius * std::sin(u), 2e-3);
  }
  const Mesh cylinder =
      mesh_of("Shape \"cylinder\" \"float radius\" 2 \"float zmin\" 1 \"float zmax\" 4");
  for (std::size_t i = 0; i < cylinder.positions.size(); ++i) {
    const double u = 2 * pi_double * cylinder.uvs[i].x;
    ASSERT_NEAR(cylinder.positions[i].x, 2 * std::cos(u), 2e-3);
    ASSERT_NEAR(cylinder.positions[i].y, 2 * std::sin(u), 2e-3);
    ASSERT_NEAR(cylinder.positions[i].z, 1 + 3 * cylinder.uvs[i].y, 1e-6);
  }
}

// What docs/pbrt.md states: how far the mesh is from the sphere, and what it covers from any side.
TEST(Unit_PbrtShapes, SpheresAreMeshesNearTheSphere) {
  const Mesh mesh = mesh_of("Scale 1 1 2 Shape \"sphere\"");
  double farthest = 0;  // of vertices and planes: all else lies between
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vec3d& p = mesh.positions[mesh.triangles[i][0]];
    if (length(face_of(mesh, i)) < 1e-12) continue;
    farthest = std::max(
        {farthest, std::abs(length(p) - 1), std::abs(dot(p, normalize(face_of(mesh, i))) - 1)});
  }
  EXPECT_LT(farthest, 0.0004);
  EXPECT_GT(farthest, 0.0002);
  for (const Vec3d& side : {Vec3d(0, 0, 1), Vec3d(1, 0, 0), normalize(Vec3d(3, 4, 9))}) {
    double projected = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      projected += std::abs(dot(face_of(mesh, i), side)) / 4;
    EXPECT_NEAR(projected / pi_double, 1, 0.00015);
  }
}

// Whole spheres stay spheres where nothing stretches them, however they are written.
TEST(Unit_PbrtShapes, WholeSpheresAreExact) {
  const auto radius_of = [](const std::string& text) {
    const Mesh mesh = mesh_of(text);
    EXPECT_EQ(mesh.sphere.has_value(), mesh.triangles.empty()) << text;
    return mesh.sphere ? mesh.sphere->radius : 0;
  };
  const std::string sphere = "Shape \"sphere\" \"float radius\" 3 ";
  EXPECT_EQ(radius_of(sphere), 3);
  EXPECT_EQ(radius_of("Shape \"sphere\""), 1);
  EXPECT_EQ(radius_of("Rotate 33 1 2 3 Scale -2 2 2 Translate 7 8 9 " + sphere), 3);
  EXPECT_EQ(radius_of(sphere + "\"float zmin\" -9 \"float zmax\" 3 \"float phimax\" 360"), 3);
  EXPECT_EQ(radius_of(sphere + "\"float zmin\" -2.9"), 0);
  EXPECT_EQ(radius_of(sphere + "\"float zmax\" 2.9"), 0);
  EXPECT_EQ(radius_of(sphere + "\"float phimax\" 359"), 0);
  EXPECT_EQ(radius_of("Scale 1 1 1.001 " + sphere), 0);
  // Turned, with the six digits of an exporter.
  EXPECT_EQ(radius_of("Transform [ .866025 .5 0 0 -.5 .866025 0 0 0 0 1 0 0 0 0 1 ] " + sphere), 3);
  EXPECT_FALSE(mesh_of(sphere).sphere->faces_inwards);
  EXPECT_FALSE(mesh_of("Scale -1 1 1 " + sphere).sphere->faces_inwards);
  EXPECT_TRUE(mesh_of("ReverseOrientation " + sphere).sphere->faces_inwards);
}

// An object's sphere is exact if all uses of the object leave it round.
TEST(Unit_PbrtShapes, SpheresOfObjectsAreExactWhereAllUsesAreRound) {
  const std::string object = R"(
    ObjectBegin "a" Scale 2 2 2 Shape "sphere" ObjectEnd
    ObjectInstance "a"
    Translate 3 0 0 Rotate 20 0 1 0 )";
  const auto round = pbrt_world(object + "ObjectInstance \"a\"");
  ASSERT_EQ(round.meshes.size(), 1u);
  EXPECT_TRUE(round.meshes[0].sphere);
  EXPECT_EQ(round.instances.size(), 2u);
  const auto stretched = pbrt_world(object + "Scale 1 2 1 ObjectInstance \"a\"");
  ASSERT_EQ(stretched.meshes.size(), 1u);
  EXPECT_FALSE(stretched.meshes[0].sphere);
  // One that is squeezed flat again by its use.
  const auto undone = pbrt_world(
      "ObjectBegin \"b\" Scale 1 2 1 Shape \"sphere\" ObjectEnd Scale 1 .5 1 ObjectInstance "
      "\"b\"");
  ASSERT_EQ(undone.meshes.size(), 1u);
  EXPECT_TRUE(undone.meshes[0].sphere);
}

TEST(Unit_PbrtShapes, PartsOfSpheres) {
  const Mesh mesh =
      mesh_of("Shape \"sphere\" \"float radius\" 2 \"float zmin\" 0 \"float phimax\" 90");
  EXPECT_NEAR(area_of(mesh), 4 * pi_double * 4 / 8, 1e-9);
  for (const Vec3d& p : mesh.positions) {
    ASSERT_GT(p.x, -1e-9);
    ASSERT_GT(p.y, -1e-9);
    ASSERT_GT(p.z, -1e-9);
  }
}

TEST(Unit_PbrtShapes, DisksAndCylinders) {
  const Mesh disk =
      mesh_of("Shape \"disk\" \"float radius\" 2 \"float innerradius\" 1 \"float height\" 5");
  EXPECT_NEAR(area_of(disk), pi_double * 3, 1e-9);
  EXPECT_NEAR(agreement_of(disk), 1, 1e-12);
  EXPECT_EQ(disk.normals[0], Vec3f(0, 0, 1));
  EXPECT_EQ(disk.positions[0].z, 5);
  EXPECT_EQ(disk.uvs[0], Vec2f(0, 0));
  EXPECT_NEAR(disk.positions[0].x, 2, 1e-3);  // v = 0 is the rim
  const Mesh cylinder =
      mesh_of("Shape \"cylinder\" \"float radius\" 2 \"float zmin\" 1 \"float zmax\" 4");
  EXPECT_NEAR(area_of(cylinder), 2 * pi_double * 2 * 3, 1e-9);
  EXPECT_GT(agreement_of(cylinder), 0.999);
}

TEST(Unit_PbrtShapes, OrientationFollowsTheNormalsAndReverseOrientation) {
  const std::string triangle = "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]";
  const std::string down = triangle + " \"normal N\" [ 0 0 -1  0 0 -1  0 0 -2 ]";
  EXPECT_GT(face_of(mesh_of(triangle), 0).z, 0);
  EXPECT_LT(face_of(mesh_of("ReverseOrientation " + triangle), 0).z, 0);
  EXPECT_LT(face_of(mesh_of(down), 0).z, 0);
  const Mesh up = mesh_of("ReverseOrientation " + down);
  EXPECT_GT(face_of(up, 0).z, 0);
  EXPECT_EQ(up.normals[2], Vec3f(0, 0, 2));
}

// Placed by what mirrors them, they face the same way.
TEST(Unit_PbrtShapes, MirroringKeepsTheOutside) {
  for (const std::string shape :
       {"Shape \"disk\"", "Shape \"cylinder\"", "Shape \"sphere\" \"float zmin\" 0",
        "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]"}) {
    const Mesh plain = mesh_of(shape);
    const Mesh mirrored = mesh_of("Scale -1 1 1 " + shape);
    EXPECT_EQ(plain.normals, mirrored.normals);
    EXPECT_EQ(plain.triangles, mirrored.triangles);
  }
}

TEST(Unit_PbrtShapes, TexturedTrianglesWithoutCoordinatesGetThem) {
  const std::string shape = "Shape \"plymesh\" \"string filename\" \"triangle.ply\"";
  EXPECT_TRUE(mesh_of(shape).uvs.empty());
  const Mesh textured = mesh_of(
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"picture.png\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\"\n" +
      shape);
  ASSERT_EQ(textured.uvs.size(), 3u);
  EXPECT_EQ(textured.uvs[1], Vec2f(1, 0));
  EXPECT_EQ(textured.uvs[2], Vec2f(1, 1));
}

// By the order of the corners in the file, whichever way the triangle then faces.
TEST(Unit_PbrtShapes, TheirCoordinatesDoNotTurnWithTheTriangle) {
  const std::string brushed = "Material \"conductor\" \"float uroughness\" .4 ";
  const std::string triangle =
      "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0 1 0 0 1 1 0] ";
  for (const std::string& turned :
       {"ReverseOrientation " + triangle, triangle + "\"normal N\" [0 0 -1 0 0 -1 0 0 -1]"}) {
    const Mesh mesh = mesh_of(brushed + turned);
    EXPECT_EQ(mesh.triangles.at(0), (std::array<std::uint32_t, 3>{0, 2, 1})) << turned;
    ASSERT_EQ(mesh.uvs.size(), 3u) << turned;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(mesh.uvs[i], Vec2f(mesh.positions[i].x, mesh.positions[i].y)) << turned;
  }
}

// Which the direction of a brushed metal needs: a width along alone differs from that of both.
TEST(Unit_PbrtShapes, SoDoThoseOfBrushedMetals) {
  for (const std::string name : {"uroughness", "vroughness"})
    EXPECT_EQ(mesh_of("Material \"conductor\" \"float " + name +
                      "\" .4 Shape \"plymesh\" \"string filename\" \"triangle.ply\"")
                  .uvs.size(),
              3u)
        << name;
  EXPECT_TRUE(mesh_of("Material \"conductor\" \"float roughness\" .4 Shape \"plymesh\" \"string "
                      "filename\" \"triangle.ply\"")
                  .uvs.empty());
}

TEST(Unit_PbrtShapes, AnglesOutOfRangeAreToldOf) {
  EXPECT_EQ(pbrt_world_warning("Shape \"disk\" \"float phimax\" 400"),
            "2:14: 'phimax' is 400, expected 0 to 360: 360 is used");
  EXPECT_EQ(pbrt_world_warning("Shape \"disk\" \"float innerradius\" -4"),
            "2:14: 'innerradius' is -4, expected at least 0: 0 is used");
  EXPECT_EQ(pbrt_world_warning("LightSource \"spot\" \"float coneangle\" 200 Shape \"disk\""),
            "2:20: 'coneangle' is 200, expected 0 to 180: 180 is used");
  EXPECT_EQ(pbrt_world_warning("LightSource \"spot\" \"float conedeltaangle\" -20 Shape \"disk\""),
            "2:20: 'conedeltaangle' is -20, expected at least 0: 0 is used");
}

// pbrt makes patches of them.
TEST(Unit_PbrtShapes, TexturedQuadsOfFilesGetThePatchsCoordinates) {
  const Mesh mesh = mesh_of(
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"picture.png\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\"\n"
      "Shape \"plymesh\" \"string filename\" \"quad.ply\"");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  ASSERT_EQ(mesh.uvs.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(mesh.uvs[i], Vec2f(mesh.positions[i].x > 0, mesh.positions[i].y > 0));
}

TEST(Unit_PbrtShapes, EqualShapesShareAMesh) {
  const auto scene = pbrt_world(R"(
    Shape "plymesh" "string filename" "triangle.ply"
    Material "conductor"
    Shape "plymesh" "string filename" "triangle.ply"
    ReverseOrientation
    Shape "plymesh" "string filename" "triangle.ply")");
  EXPECT_EQ(scene.meshes.size(), 2u);
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(scene.instances[0].mesh, scene.instances[1].mesh);
  EXPECT_TRUE(scene.instances[1].material_override.is_valid());
}

// Exporters write the same material before each shape.
TEST(Unit_PbrtShapes, EqualMaterialsAreOne) {
  const auto scene = pbrt_world(R"(
    Material "diffuse" "rgb reflectance" [ .1 .2 .3 ]
    Shape "disk"
    Material "diffuse" "rgb reflectance" [ .1 .2 .3 ]
    Shape "disk"
    Material "diffuse" "rgb reflectance" [ .1 .2 .4 ]
    Shape "disk")");
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_FALSE(scene.instances.at(1).material_override.is_valid());
}

TEST(Unit_PbrtShapes, ManyCurvedShapesAreCoarser) {
  EXPECT_EQ(pbrt::segments_for(1, 0), 128u);
  EXPECT_EQ(pbrt::segments_for(488, 0), 128u);
  EXPECT_EQ(pbrt::segments_for(2000, 0), 63u);
  EXPECT_EQ(pbrt::segments_for(1'000'000, 0), 12u);
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "Shape \"sphere\" \"float zmin\" -.5\n";
  const auto scene = pbrt_world(text);
  EXPECT_EQ(scene.instances.size(), 2000u);
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 63u * (2 * 31 - 1));  // a pole is of triangles
  EXPECT_NEAR(area_of(scene.meshes[0]), 3 * pi_double, 1e-9);
}

TEST(Unit_PbrtShapes, PatchesAreTheirSurface) {
  const std::string flat = "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  2 0 0  0 3 0  2 3 0 ]";
  EXPECT_EQ(mesh_of(flat).triangles.size(), 2u);
  EXPECT_NEAR(area_of(mesh_of(flat)), 6, 1e-12);
  EXPECT_GT(face_of(mesh_of(flat), 0).z, 0);
  const Mesh saddle = mesh_of("Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 1 ]");
  for (std::size_t i = 0; i < saddle.positions.size(); ++i) {
    const Vec3d& p = saddle.positions[i];
    ASSERT_NEAR(p.z, p.x * p.y, 1e-12);  // z = uv
    ASSERT_LT(length(normalize(Vec3d(-p.y, -p.x, 1)) - Vec3d(saddle.normals[i])), 1e-6);
  }
}

// Two triangles where they are the surface, and u and v do not matter.
TEST(Unit_PbrtShapes, FlatPatchesAreTwoTriangles) {
  const std::string trapezoid =
      "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  4 0 0  1 2 0  2 2 0 ] ";
  EXPECT_EQ(mesh_of(trapezoid).triangles.size(), 2u);
  EXPECT_NEAR(area_of(mesh_of(trapezoid)), 5, 1e-12);
  const std::string textured =
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"picture.png\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\"\n";
  EXPECT_EQ(mesh_of(textured + trapezoid).triangles.size(), 512u);
  EXPECT_EQ(mesh_of(trapezoid + "\"normal N\" [ 0 0 1  0 0 1  0 0 1  0 1 1 ]").triangles.size(),
            512u);
  EXPECT_EQ(mesh_of("Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  4 0 0  1 2 0  .5 .5 0 ]")
                .triangles.size(),
            512u);  // not convex
}

TEST(Unit_PbrtShapes, ManyPatchesAreCoarser) {
  EXPECT_EQ(pbrt::segments_for(0, 15'625), 128u);
  EXPECT_EQ(pbrt::patch_cells_for(128), 16u);
  EXPECT_EQ(pbrt::patch_cells_for(pbrt::segments_for(0, 100'000)), 6u);
  EXPECT_EQ(pbrt::patch_cells_for(pbrt::segments_for(0, 10'000'000)), 1u);
  std::string indices;
  for (int i = 0; i < 20'000; ++i) indices += "0 1 2 3\n";
  const std::string mesh = "Shape \"bilinearmesh\" \"integer indices\" [ " + indices + "] ";
  const Mesh saddles = mesh_of(mesh + "\"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 1 ]");
  EXPECT_EQ(saddles.triangles.size(), 20'000u * 2 * 14 * 14);
  // Flat ones take nothing from the others.
  const auto scene =
      pbrt_world(mesh + "\"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ]\n" + "Shape \"disk\"");
  EXPECT_EQ(scene.meshes.at(1).triangles.size(), 128u);
}

// The limit of Loop's surface at the vertices of an octahedron and of a tetrahedron is at
// (1 - n gamma) + gamma * (sum of the neighbours), on the way to the middle.
TEST(Unit_PbrtShapes, SubdivisionGoesToLoopsLimit) {
  const std::string octahedron =
      "Shape \"loopsubdiv\" \"integer indices\" [ 0 2 4  2 1 4  1 3 4  3 0 4  2 0 5  1 2 5  3 1 5  "
      "0 "
      "3 5 ] \"point3 P\" [ 1 0 0  -1 0 0  0 1 0  0 -1 0  0 0 1  0 0 -1 ] \"integer levels\" ";
  for (const char* levels : {"0", "1", "4"}) {
    const Mesh mesh = mesh_of(octahedron + levels);
    EXPECT_EQ(mesh.triangles.size(), 8u << (2 * std::atoi(levels)));
    // n = 4, beta = 3/32: gamma = 1 / (4 + 4) and the neighbours of a vertex cancel.
    EXPECT_LT(length(mesh.positions[0] - Vec3d(0.5, 0, 0)), 1e-12) << levels;
    // pbrt-v4's are on the other side than those of the faces' winding.
    EXPECT_LT(length(normalize(Vec3d(mesh.normals[0])) - Vec3d(-1, 0, 0)), 1e-6) << levels;
    const auto& [a, b, c] = mesh.triangles[0];
    const Vec3d& p = mesh.positions[a];
    EXPECT_LT(dot(cross(mesh.positions[b] - p, mesh.positions[c] - p), p), 0) << levels;
  }
  // A boundary is a cubic B-spline: the limit of a corner is 2/3 of itself and 1/6 of each side.
  const Mesh open = mesh_of(
      "Shape \"loopsubdiv\" \"integer levels\" 2 \"integer indices\" [ 0 1 2 ] \"point3 P\" [ 0 0 "
      "0  "
      "5 0 0  0 5 0 ]");
  EXPECT_LT(length(open.positions[0] - Vec3d(5, 5, 0) / 6.0), 1e-12);
}

TEST(Errors_PbrtShapes, ThoseWithoutAnAreaAreNamed) {
  for (const char* shape :
       {"\"cylinder\" \"float zmin\" 1 \"float zmax\" 1", "\"sphere\" \"float zmin\" 5",
        "\"disk\" \"float innerradius\" 2", "\"sphere\" \"float phimax\" 0",
        "\"disk\" \"float phimax\" 0", "\"cylinder\" \"float phimax\" 0"})
    EXPECT_EQ(pbrt_world_warning(fmt::format("Shape {}\nShape \"disk\"", shape)),
              "2:7: this shape has no area: it is left out");
}

TEST(Errors_PbrtShapes, WhatAMeshLacks) {
  EXPECT_EQ(pbrt_world_error("Shape \"trianglemesh\""),
            "2:7: a mesh without positions: expected \"point3 P\"");
  EXPECT_EQ(
      pbrt_world_error("Shape \"trianglemesh\" \"point3 P\" [ ] \"integer indices\" [ 0 1 2 ]"),
      "2:7: a mesh without positions: expected \"point3 P\"");
  EXPECT_EQ(pbrt_world_error("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 ]"),
            "2:22: 'P' has 4 values, expected triples");
  const std::string p = "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] ";
  EXPECT_EQ(pbrt_world_error(p + "\"integer indices\" [ 0 1 3 ]"),
            "2:7: \"indices\" has 3, but there are 3 vertices (from 0)");
  EXPECT_EQ(pbrt_world_error(p + "\"integer indices\" [ 0 1 ]"),
            "2:7: 2 indices, expected 3 for each face");
  EXPECT_EQ(pbrt_world_error(p + "\"normal N\" [ 0 0 1 ]"), "2:7: 1 normals N for 3 vertices");
  EXPECT_EQ(pbrt_world_error("Shape \"plymesh\""),
            "2:7: a plymesh without its file: expected \"string filename\"");
  EXPECT_EQ(pbrt_world_error("Shape \"sphere\" \"float radius\" 0"),
            "2:7: the radius is 0, expected above 0");
  EXPECT_EQ(pbrt_world_warning("Shape \"curve\" \"float width\" 1"),
            "2:7: a shape of type 'curve' is not supported and left out");
}

}  // namespace
}  // namespace candela
