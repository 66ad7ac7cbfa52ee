// `candela info` lists what compiling left out: every reason there is, once, with its count.
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;
using Counts = std::map<std::string, std::uint64_t>;

// The text says the same as the JSON.
Counts dropped_from(const std::string& scene) {
  const ProgramResult json = run_candela({"info", scene, "--json"});
  const ProgramResult text = run_candela({"info", scene});
  EXPECT_EQ(json.exit_code, 0) << json.error;
  EXPECT_EQ(text.exit_code, 0) << text.error;
  const Json info = Json::parse(json.output);
  Counts counts;
  for (const Json& entry : info.at("dropped")) counts[entry.at("what")] = entry.at("count");
  std::string lines = "\n  dropped     \n";
  for (const auto& [what, count] : counts) lines += fmt::format("    {}: {}\n", what, count);
  EXPECT_NE(text.output.find(lines), std::string::npos) << text.output;
  return counts;
}

// A ground of side * side vertices, so many that the scene's unit is not that of what lies far out.
std::string ground_of_pbrt(int side) {
  std::string points, indices;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      points += fmt::format("{} {} -2 ", x - side / 2, y - side / 2);
      const int i = y * side + x;
      if (x + 1 < side && y + 1 < side)
        indices +=
            fmt::format("{} {} {} {} {} {} ", i, i + 1, i + side + 1, i, i + side + 1, i + side);
    }
  return "Shape \"trianglemesh\" \"point3 P\" [ " + points + "] \"integer indices\" [ " + indices +
         "]\n";
}

TEST(Unit_Dropped, GeometryAndMediaOfPbrtFiles) {
  const std::string scene = fresh_folder("pbrt") + "/scene.pbrt";
  write_text(scene,
             "LookAt 0 0 9  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin\n"
             "LightSource \"point\" \"point3 from\" [ 0 4 4 ]\n"
             "MakeNamedMedium \"air\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ 0 0 0 ]\n"
             "  \"rgb sigma_s\" [ 0 0 0 ]\nMaterial \"diffuse\"\n" +
                 ground_of_pbrt(40) +
                 // One that stays, one without area, one too far away; the last two vertices are
                 // theirs alone or nobody's.
                 "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 0  1 -1 0  1 1 0  1e30 0 0  0 0 1 ]\n"
                 "  \"integer indices\" [ 0 1 2  0 1 1  0 1 3 ]\n"
                 "  \"normal N\" [ 0 0 1  0 0 1  0 0 1  0 0 1  0 0 1 ]\n"
                 "  \"point2 uv\" [ 0 0  1 0  1 1  0 1  0 0 ]\n"
                 "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 1  1 -1 1  1 1 1 ]\n"
                 "  \"integer indices\" [ 0 1 2 ] \"float alpha\" 0\n"
                 "Shape \"sphere\" \"float radius\" .2 \"float alpha\" 0\n"
                 "Shape \"sphere\" \"float radius\" 1e-30\n"
                 "AttributeBegin\nTranslate 1e30 0 0\nShape \"sphere\"\nAttributeEnd\n"
                 "AttributeBegin\nMediumInterface \"air\" \"\"\nShape \"sphere\"\nAttributeEnd\n"
                 "ObjectBegin \"nowhere\"\nShape \"trianglemesh\" \"integer indices\" [ 0 1 2 ]\n"
                 "  \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]\nObjectEnd\n");
  EXPECT_EQ(dropped_from(scene),
            (Counts{{"triangles with vertices that are not finite or too far away", 1},
                    {"triangles without area", 1},
                    {"triangles that are wholly clear", 1},
                    {"vertices that no triangle needs", 2 + 3},
                    {"normals that say what the winding says", 3},
                    {"texture coordinates that nothing reads", 3},
                    {"spheres that are not finite or too far away", 1},
                    {"spheres that are too small beside the scene", 1},
                    {"spheres that are wholly clear", 1},
                    {"meshes without a place", 1},
                    {"instances that are the only one of their mesh", 7},
                    {"media that are clear or nowhere", 1}}));
}

TEST(Unit_Dropped, LightsMaterialsAndInstancesOfYamlFiles) {
  const std::string folder = fresh_folder("yaml");
  write_text(folder + "/quad.obj", "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 4 3 2 1\n");
  write_text(folder + "/scene.yaml",
             "Cameras: [{Eye: [0, 1, 4], Target: [0, 0, 0]}]\n"
             "Lights: [{Type: Point, Position: [0, 1, 2], Intensity: [0, 0, 0]}]\n"
             "Materials:\n"
             "  - {Name: white, Type: diffuse}\n"
             "  - {Name: unworn, Type: diffuse}\n"
             "  - {Name: lamp, Type: diffuse, Emission: [1, 1, 1]}\n"
             "Models:\n"
             "  - {Mesh: quad.obj, Material: white}\n"
             "  - Mesh: quad.obj\n    Material: lamp\n    Instances:\n"
             "      - Translation: [0, 2, 0]\n      - Translation: [3, 2, 0]\n");
  Counts counts = dropped_from(folder + "/scene.yaml");
  // Of normals and coordinates the file has none; those that its reader makes up do not matter.
  std::erase_if(counts, [](const auto& entry) {
    return entry.first.starts_with("normals") || entry.first.starts_with("texture");
  });
  EXPECT_EQ(counts, (Counts{{"black lights", 1},
                            {"materials that nothing wears", 1},
                            {"instances that are the only one of their mesh", 1},
                            {"instances that are lamps", 2}}));
}

TEST(Unit_Dropped, NothingOfWhatIsNeeded) {
  const std::string folder = fresh_folder("nothing");
  const std::string scene = folder + "/scene.pbrt";
  write_text(scene,
             "LookAt 0 0 9  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin\n"
             "LightSource \"point\" \"point3 from\" [ 0 4 4 ]\nMaterial \"diffuse\"\n"
             "ObjectBegin \"twice\"\nShape \"trianglemesh\" \"integer indices\" [ 0 1 2 ]\n"
             "  \"point3 P\" [ -1 -1 0  1 -1 0  1 1 0 ] \"normal N\" [ 0 0 1  0 1 1  1 0 1 ]\n"
             "ObjectEnd\nObjectInstance \"twice\"\nTranslate 2 0 0\nObjectInstance \"twice\"\n");
  const ProgramResult text = run_candela({"info", scene});
  EXPECT_NE(text.output.find("\n  dropped     nothing\n"), std::string::npos) << text.output;
}

}  // namespace
}  // namespace candela::cli_test
