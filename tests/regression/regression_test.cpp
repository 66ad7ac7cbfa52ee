// Every asset and integrator against its reference image, by z-tests on pixels, blocks and the
// whole.
//
// References are 64x64 EXRs in this folder, of 128 renders of 32 samples a pixel: R G B the mean
// radiance (to look at), bounded.R .G .B and variance.R .G .B the mean of x / (1 + x) and the
// variance of that mean. An image under test is 16 such renders; its variance follows from the
// reference's, which has seen eight times more, pooled with its neighbours': a pixel that rare
// events make bright would look certain in renders that missed them. `CANDELA_WRITE_REFERENCES=1
// candela_tests --gtest_filter='Regression_*'` renders them anew (look at them before committing).
// On failure image, reference and difference are kept in the test's output folder.
#include <filesystem>

#include <gtest/gtest.h>

#include "renderer/base/parallel.h"
#include "renderer/image/image_io.h"
#include "tests/regression/asset_case.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/image_test.h"

namespace candela {
namespace {

namespace fs = std::filesystem;
using regression::Case;
using regression::described;
using regression::reference_path;
using test::RenderSettings;

constexpr int size = 64;
constexpr int samples_a_replicate = 32;
constexpr int replicates = 16;
constexpr int reference_replicates = 128;
constexpr std::uint64_t first_reference_seed = 1'000'000;

std::vector<Case> cases() {
  std::vector<Case> list = regression::all_assets_by(IntegratorKind::Path, "path");
  for (Case& c : regression::pbrt_assets()) list.push_back(std::move(c));
  return list;
}

// The mean of independent renders and the variance of that mean.
struct Measured {
  Image radiance{size, size, {"R", "G", "B"}};
  Image mean{size, size, {"R", "G", "B"}};  // of x / (1 + x)
  Image variance{size, size, {"R", "G", "B"}};
};

Measured measure(const description::SceneDescription& description, const Case& c, int count,
                 std::uint64_t first_seed) {
  RenderSettings settings = test::settings_of(size, samples_a_replicate);
  settings.options.integrator = c.integrator;
  const Scene scene = test::compiled(description, settings.options);
  std::vector<double> radiance(size * size * 3), sum(radiance), squares(radiance);
  for (int i = 0; i < count; ++i) {
    settings.options.seed = first_seed + static_cast<std::uint64_t>(i);
    const Image image = test::rendered(scene, settings).film.to_image(false);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      const double x = image.values[k];
      const double v = x / (1 + x);
      radiance[k] += x;
      sum[k] += v;
      squares[k] += v * v;
    }
  }
  Measured out;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const double mean = sum[k] / count;
    out.radiance.values[k] = static_cast<float>(radiance[k] / count);
    out.mean.values[k] = static_cast<float>(mean);
    out.variance.values[k] =
        static_cast<float>(std::max(0.0, squares[k] / count - mean * mean) / (count - 1));
  }
  return out;
}

void write_reference(const Case& c) {
  const Measured m = measure(described(c), c, reference_replicates, first_reference_seed);
  Image image(size, size,
              {"R", "G", "B", "bounded.R", "bounded.G", "bounded.B", "variance.R", "variance.G",
               "variance.B"});
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      image.values[9 * i + k] = m.radiance.values[3 * i + k];
      image.values[9 * i + 3 + k] = m.mean.values[3 * i + k];
      image.values[9 * i + 6 + k] = m.variance.values[3 * i + k];
    }
  EXPECT_FALSE(write_image(reference_path(c), image, {}).has_errors());
}

Measured read_reference(const Case& c) {
  const Result<Image> image = read_image(reference_path(c));
  Measured out;
  if (!image) {
    ADD_FAILURE() << "no reference " << reference_path(c);
    return out;
  }
  const auto channel = [&](const char* name) {
    const int index = image->channel_index(name);
    EXPECT_GE(index, 0) << name;
    return static_cast<std::size_t>(std::max(index, 0));
  };
  const std::array mean{channel("bounded.R"), channel("bounded.G"), channel("bounded.B")};
  const std::array variance{channel("variance.R"), channel("variance.G"), channel("variance.B")};
  for (std::size_t i = 0; i < image->pixel_count(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      out.mean.values[3 * i + k] = image->values[image->channel_count() * i + mean[k]];
      out.variance.values[3 * i + k] = image->values[image->channel_count() * i + variance[k]];
    }
  return out;
}

// Each value, or the mean of its 5 x 5 neighbourhood where that is larger.
Image pooled(const Image& variance) {
  Image out = variance;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        float count = 0;
        for (int v = std::max(y - 2, 0); v <= std::min(y + 2, size - 1); ++v)
          for (int u = std::max(x - 2, 0); u <= std::min(x + 2, size - 1); ++u, ++count)
            sum += variance.pixel(u, v)[c];
        out.pixel(x, y)[c] = std::max(variance.pixel(x, y)[c], sum / count);
      }
  return out;
}

statistics::ImageTestResult compare(const Measured& image, const Measured& reference) {
  const Image reference_variance = pooled(reference.variance);
  Image variance = reference_variance;
  for (float& v : variance.values) v *= static_cast<float>(reference_replicates) / replicates;
  statistics::ImageTestOptions options;
  options.level = 1e-3;
  options.degrees_of_freedom = replicates - 1;  // means of so few renders have tails
  return statistics::compare_images({&image.mean, &variance},
                                    {&reference.mean, &reference_variance}, options);
}

void keep_evidence(const Case& c, const Measured& a, const Measured& reference) {
  const fs::path folder = fs::path(CANDELA_TEST_OUTPUT) / "regression";
  fs::create_directories(folder);
  Image difference = a.mean;
  for (std::size_t i = 0; i < difference.values.size(); ++i)
    difference.values[i] = std::abs(difference.values[i] - reference.mean.values[i]);
  (void)write_image((folder / (c.name + "-image.exr")).string(), a.mean, {});
  (void)write_image((folder / (c.name + "-reference.exr")).string(), reference.mean, {});
  (void)write_image((folder / (c.name + "-difference.exr")).string(), difference, {});
}

// Every light of a scene, whatever its kind.
struct Dim {
  double factor;

  void operator()(description::PointLight& light) const { light.intensity *= factor; }
  void operator()(description::SpotLight& light) const { light.intensity *= factor; }
  void operator()(description::GoniometricLight& light) const { dim_intensity(light); }
  void operator()(description::ProjectionLight& light) const { dim_intensity(light); }
  void operator()(description::DirectionalLight& light) const { light.irradiance *= factor; }
  void operator()(description::TriangleLight& light) const { light.radiance *= factor; }
  void operator()(description::ConstantEnvironment& light) const { light.radiance *= factor; }
  void operator()(description::LatLongEnvironment& light) const { light.scale *= factor; }
  void operator()(description::EqualAreaEnvironment& light) const { light.scale *= factor; }
  void operator()(description::CubeEnvironment&) const { ADD_FAILURE() << "cannot dim a skybox"; }

 private:
  template <class Light>
  void dim_intensity(Light& light) const {
    light.intensity *= factor;
  }
};

void dim_lights(description::SceneDescription& scene, double factor) {
  for (description::Material& material : scene.materials) material.emission *= factor;
  for (description::Light& light : scene.lights) std::visit(Dim{factor}, light.kind);
}

class Regression_Images : public testing::TestWithParam<Case> {};

TEST_P(Regression_Images, MatchesItsReference) {
  const Case c = GetParam();
  if (std::getenv("CANDELA_WRITE_REFERENCES") != nullptr) write_reference(c);
  const Measured reference = read_reference(c);
  const Measured image = measure(described(c), c, replicates, 1);
  const statistics::ImageTestResult result = compare(image, reference);
  EXPECT_TRUE(result.passed) << result.message;
  if (!result.passed) keep_evidence(c, image, reference);
}

// The test above sees lights that are 2 % too dim.
TEST_P(Regression_Images, FailsWhenLightsAreDimmedByTwoPerCent) {
  const Case c = GetParam();
  description::SceneDescription dimmed = described(c);
  dim_lights(dimmed, 0.98);
  const Measured image = measure(dimmed, c, replicates, 1);
  EXPECT_FALSE(compare(image, read_reference(c)).passed);
}

INSTANTIATE_TEST_SUITE_P(, Regression_Images, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace candela
