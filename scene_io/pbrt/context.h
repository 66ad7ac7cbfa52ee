// What the steps that make a SceneDescription of a Program share.
#pragma once

#include <set>
#include <string>

#include "renderer/description/scene_description.h"
#include "scene_io/image_index.h"
#include "scene_io/pbrt/program.h"

namespace candela::pbrt {

struct Context {
  Program& program;
  description::SceneDescription& scene;
  const Report& report;
  double imaging_ratio = 1;  // of the film: all light is multiplied by it
  std::set<std::string> warned = {};
  ImageIndex images = {};

  // The same for another scene: what nothing uses is read for its errors alone.
  [[nodiscard]] Context for_unused(description::SceneDescription& unused) const {
    unused.path = scene.path;
    return {program, unused, report, imaging_ratio, warned};
  }
  // Of several like it the first is enough.
  void warn_once(const std::string& key, const Place& place, std::string message) {
    if (warned.insert(key).second) report.warning(place, std::move(message));
  }
  // What is done in another way and looks alike; no warning, so `--strict` renders it.
  void note_once(const std::string& key, const Place& place, std::string message) {
    if (warned.insert(key).second) report.note(place, std::move(message));
  }
};

}  // namespace candela::pbrt
