// An asset and an integrator, with the reference image that lies beside the tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/render.h"
#include "scene_io/load.h"

namespace candela::regression {

struct Case {
  std::string asset;
  IntegratorKind integrator;
  std::string name;
};

// Every asset by an integrator of this name.
inline std::vector<Case> all_assets_by(IntegratorKind integrator, const std::string& name) {
  std::vector<Case> list;
  for (const std::string asset :
       {"cornell_box", "cornell_box_diffuse", "cutouts", "glass_and_metal"})
    list.push_back({asset, integrator, asset + "_" + name});
  return list;
}

inline std::string reference_path(const Case& c) {
  return std::string(CANDELA_SOURCE_DIR) + "/tests/regression/" + c.name + ".exr";
}

inline description::SceneDescription described(const Case& c) {
  const std::string file =
      std::string(CANDELA_SOURCE_DIR) + "/assets/" + c.asset + "/" + c.asset + ".yaml";
  Result<description::SceneDescription> loaded = load(file, {});
  EXPECT_TRUE(loaded) << file;
  for (const Diagnostic& diagnostic : loaded.diagnostics.list())
    EXPECT_NE(diagnostic.severity, Severity::Error) << to_string(diagnostic);
  return loaded ? std::move(*loaded) : description::SceneDescription{};
}

}  // namespace candela::regression
