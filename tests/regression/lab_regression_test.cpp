// Every asset through whitted and raster against its reference image.
//
// Nothing in these integrators is random, so there is no variance to test against: two builds may
// differ by rounding only (libm at compile time, Embree's instruction set), which moves values by
// some 1e-6 and can flip a ray that passes within rounding of an edge. So every pixel must agree to
// 1e-4 of its value, but for one in two hundred. `CANDELA_WRITE_REFERENCES=1` renders the
// references anew (look at them before committing).
#include <gtest/gtest.h>

#include "renderer/image/image_io.h"
#include "tests/regression/asset_case.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using regression::Case;
using regression::described;
using regression::reference_path;

constexpr int size = 64;

std::vector<Case> cases() {
  std::vector<Case> list = regression::all_assets_by(IntegratorKind::Whitted, "whitted");
  for (Case& c : regression::all_assets_by(IntegratorKind::Raster, "raster"))
    list.push_back(std::move(c));
  return list;
}

Image picture(const description::SceneDescription& description, const Case& c) {
  test::RenderSettings settings = test::settings_of(size, 4);
  settings.options.integrator = c.integrator;
  return test::rendered(description, settings).film.to_image(false);
}

// Pixels with a channel that is further off than rounding brings.
int pixels_apart(const Image& a, const Image& b) {
  int apart = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      bool is_apart = false;
      for (int c = 0; c < 3; ++c) {
        const float tolerance = 1e-4f * b.pixel(x, y)[c] + 1e-6f;
        is_apart |= !(std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]) <= tolerance);
      }
      apart += is_apart ? 1 : 0;
    }
  return apart;
}

Image reference_of(const Case& c) {
  Result<Image> image = read_image(reference_path(c));
  EXPECT_TRUE(image) << "no reference " << reference_path(c);
  return image ? std::move(*image) : Image(size, size, {"R", "G", "B"});
}

class Regression_LabImages : public testing::TestWithParam<Case> {};

constexpr int most_apart = size * size / 200;

TEST_P(Regression_LabImages, MatchesItsReference) {
  const Case c = GetParam();
  const Image image = picture(described(c), c);
  if (std::getenv("CANDELA_WRITE_REFERENCES") != nullptr) {
    EXPECT_FALSE(write_image(reference_path(c), image, {}).has_errors());
  }
  EXPECT_LE(pixels_apart(image, reference_of(c)), most_apart);
}

// The test above sees lights that are 0.1 % too dim.
TEST_P(Regression_LabImages, FailsWhenLightsAreDimmedByATenthOfAPerCent) {
  const Case c = GetParam();
  description::SceneDescription dimmed = described(c);
  for (description::Light& light : dimmed.lights) {
    if (auto* sun = std::get_if<description::DirectionalLight>(&light.kind))
      sun->irradiance *= 0.999;
    if (auto* point = std::get_if<description::PointLight>(&light.kind)) point->intensity *= 0.999;
  }
  for (description::Material& material : dimmed.materials) material.emission *= 0.999;
  EXPECT_GT(pixels_apart(picture(dimmed, c), reference_of(c)), 20 * most_apart);
}

INSTANTIATE_TEST_SUITE_P(, Regression_LabImages, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace candela
