#include "renderer/texture/texel_slope.h"

#include <gtest/gtest.h>

#include <vector>

#include "renderer/sampling/sobol.h"

namespace candela {
namespace {

// Values of [0, 1), as each type stores them.
std::vector<std::byte> random_samples(SampleType type, std::size_t count) {
  std::vector<std::byte> samples;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float value = owen_sobol_1d(i, 7);
    const auto put = [&](const auto& stored) {
      const auto* bytes = reinterpret_cast<const std::byte*>(&stored);
      samples.insert(samples.end(), bytes, bytes + sizeof(stored));
    };
    if (type == SampleType::U8) put(static_cast<std::uint8_t>(255 * value));
    if (type == SampleType::U16) put(static_cast<std::uint16_t>(65535 * value));
    if (type == SampleType::Half) put(static_cast<std::uint16_t>(0x3c00 * value));  // up to 1
    if (type == SampleType::Float) put(value);
  }
  samples.resize(samples.size() + 16);  // as images have it: a texel may be read as four samples
  return samples;
}

struct Picture {
  SampleType type;
  int channels;
  Encoding encoding;
  Wrap wrap;
  int width;
  int height;
};

// By its definition, of the bilinear filter.
Vec2f central_differences(const Picture& of, const TexelView& view, Vec2f uv) {
  const TexelFilter filter = texel_filters(of.type, of.channels, of.encoding, false).all;
  const auto at = [&](float du, float dv) {
    return filter(view, footprint_of(uv + Vec2f(du, dv), of.width, of.height, of.wrap)).x;
  };
  const auto width = static_cast<float>(of.width);
  const auto height = static_cast<float>(of.height);
  const float du = 0.5f / width;
  const float dv = 0.5f / height;
  return {(at(du, 0) - at(-du, 0)) * width, (at(0, dv) - at(0, -dv)) * height};
}

void expect_central_differences(const Picture& of) {
  const auto samples =
      random_samples(of.type, static_cast<std::size_t>(of.width * of.height * of.channels));
  const TexelView view{samples.data(), of.width, of.height};
  const SlopeFilter slope = slope_filter(of.type, of.channels, of.encoding, of.wrap);
  ASSERT_NE(slope, nullptr);
  const float most = static_cast<float>(std::max(of.width, of.height));
  for (std::uint32_t i = 0; i < 256; ++i) {
    const Vec2f uv = owen_sobol_2d(i, 3) * 4.0f - 2.0f;
    const Vec2f error = slope(view, uv) - central_differences(of, view, uv);
    ASSERT_LT(glm::length(error), 1e-5f * most * most)
        << "uv " << uv.x << " " << uv.y << ", " << of.width << "x" << of.height << ", "
        << of.channels << " channels of type " << static_cast<int>(of.type) << ", encoding "
        << static_cast<int>(of.encoding) << ", wrap " << static_cast<int>(of.wrap);
  }
}

TEST(Unit_TexelSlope, IsTheFiltersCentralDifferences) {
  const Vec2i sizes[] = {{1, 5}, {2, 1}, {2, 2}, {3, 7}, {16, 4}};
  for (const SampleType type :
       {SampleType::U8, SampleType::U16, SampleType::Half, SampleType::Float})
    for (int channels = 1; channels <= 4; ++channels)
      for (const Encoding encoding : {Encoding::Linear, Encoding::Srgb})
        for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
          for (const Vec2i& size : sizes)
            expect_central_differences({type, channels, encoding, wrap, size.x, size.y});
}

TEST(Unit_TexelSlope, IsContinuousAcrossTexels) {
  const auto samples = random_samples(SampleType::Float, 64);
  const TexelView view{samples.data(), 8, 8};
  const SlopeFilter slope = slope_filter(SampleType::Float, 1, Encoding::Linear, Wrap::Repeat);
  for (int half_texel = 0; half_texel <= 16; ++half_texel) {
    const float at = static_cast<float>(half_texel) / 16;
    for (const Vec2f& step : {Vec2f(1e-5f, 0), Vec2f(0, 1e-5f)}) {
      const Vec2f jump = slope(view, Vec2f(at, 0.3f) + step) - slope(view, Vec2f(at, 0.3f) - step);
      EXPECT_LT(glm::length(jump), 0.02f) << half_texel;
    }
  }
}

TEST(Unit_TexelSlope, IsLeftToLookupsWhereTexelsDoNotTellIt) {
  EXPECT_EQ(slope_filter(SampleType::U8, 1, Encoding::LabGamma, Wrap::Repeat), nullptr);
  EXPECT_EQ(slope_filter(SampleType::U8, 1, Encoding::Linear, Wrap::Mirror), nullptr);
  EXPECT_EQ(slope_filter(SampleType::U8, 1, Encoding::Linear, Wrap::Black), nullptr);
}

}  // namespace
}  // namespace candela
