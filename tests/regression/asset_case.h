// An asset and an integrator, with the reference image that lies beside the tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
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

// The scenes of pbrt-v4's format, which only `path` renders as they are meant.
inline std::vector<Case> pbrt_assets() {
  std::vector<Case> list;
  for (const std::string asset : {"pbrt_lights", "pbrt_materials", "pbrt_media", "pbrt_mixtures",
                                  "pbrt_place_textures", "pbrt_shapes", "pbrt_textured_lights"})
    list.push_back({asset, IntegratorKind::Path, asset + "_path"});
  return list;
}

inline std::string reference_path(const Case& c) {
  return fmt::format("{}/tests/regression/{}.exr", CANDELA_SOURCE_DIR, c.name);
}

inline description::SceneDescription described(const Case& c) {
  std::string file = fmt::format("{}/assets/{}/{}", CANDELA_SOURCE_DIR, c.asset, c.asset);
  file += std::filesystem::exists(file + ".pbrt") ? ".pbrt" : ".yaml";
  Result<description::SceneDescription> loaded = load(file, {});
  EXPECT_TRUE(loaded) << file;
  for (const Diagnostic& diagnostic : loaded.diagnostics.list())
    EXPECT_NE(diagnostic.severity, Severity::Error) << to_string(diagnostic);
  return loaded ? std::move(*loaded) : description::SceneDescription{};
}

}  // namespace candela::regression
