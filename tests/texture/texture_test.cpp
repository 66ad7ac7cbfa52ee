// Lookups against the definition worked out in double: texel centres, wrapping, encodings.
#include "renderer/texture/texture.h"

#include <gtest/gtest.h>
#include <half.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/encode.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

TextureHandle added(TextureStore& store, const std::string& path,
                    Encoding encoding = Encoding::Linear, Wrap wrap = Wrap::Repeat) {
  Diagnostics diagnostics;
  const TextureHandle handle = store.add({path, encoding, wrap, {}}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics.list().front());
  return handle;
}

double linear_of(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

unsigned sample(int x, int y, int c) {
  return static_cast<unsigned>(x * 37 + y * 91 + c * 53 + x * y * 7) % 256;
}

// A texel of the picture `sample`, wrapped by definition; outside of Wrap::Black: -1.
int wrapped(int i, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::Repeat:
      return ((i % size) + size) % size;
    case Wrap::Clamp:
      return std::clamp(i, 0, size - 1);
    case Wrap::Mirror: {
      const int folded = ((i % (2 * size)) + 2 * size) % (2 * size);
      return folded < size ? folded : 2 * size - 1 - folded;
    }
    case Wrap::Black:
      return i < 0 || i >= size ? -1 : i;
  }
  return 0;
}

double expected(Vec2d uv, int c, int width, int height, Encoding encoding, Wrap wrap) {
  const double x = uv.x * width - 0.5;
  const double y = (1 - uv.y) * height - 0.5;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const int column = wrapped(x0 + i % 2, width, wrap);
    const int row = wrapped(y0 + i / 2, height, wrap);
    const double weight =
        (i % 2 == 1 ? x - x0 : 1 - (x - x0)) * (i / 2 == 1 ? y - y0 : 1 - (y - y0));
    double value = column < 0 || row < 0 ? 0 : sample(column, row, c) / 255.0;
    if (encoding == Encoding::Srgb && c < 3) value = linear_of(value);
    if (encoding == Encoding::Gamma22 && c < 3) value = std::pow(value, 2.2);
    sum += weight * value;
  }
  return encoding == Encoding::LabGamma && c < 3 ? std::pow(sum, 2.2) : sum;
}

constexpr Encoding all_encodings[] = {Encoding::Linear, Encoding::Srgb, Encoding::Gamma22,
                                      Encoding::LabGamma};

TEST(Unit_Texture, LookupsFollowTheirDefinition) {
  const TemporaryFolder folder;
  constexpr int width = 7, height = 5;
  const std::string path = folder.put("x.png", crafted::png_rgba(width, height, sample));
  TextureStore store;
  for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror, Wrap::Black})
    for (const Encoding encoding : all_encodings) {
      const TextureHandle texture = added(store, path, encoding, wrap);
      for (int i = 0; i < 2000; ++i) {
        const Vec2f uv{std::fmod(static_cast<float>(i) * 0.618034f, 6.0f) - 3,
                       std::fmod(static_cast<float>(i) * 0.754878f, 6.0f) - 3};
        const Vec4f found = store.lookup(texture, uv);
        for (int c = 0; c < 4; ++c)
          ASSERT_NEAR(found[c], expected(Vec2d(uv), c, width, height, encoding, wrap), 2e-5)
              << uv.x << ' ' << uv.y << " channel " << c << " wrap " << static_cast<int>(wrap);
      }
    }
}

TEST(Unit_Texture, TexelCentresGiveTheTexelItselfAndVRunsUpwards) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.png", crafted::png_rgba(4, 3, sample));
  TextureStore store;
  const TextureHandle texture = added(store, path);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      const Vec2f uv{(static_cast<float>(x) + 0.5f) / 4, 1 - (static_cast<float>(y) + 0.5f) / 3};
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(store.lookup(texture, uv)[c], sample(x, y, c) / 255.0, 1e-6);
    }
}

TEST(Unit_Texture, AConstantPictureIsExactEverywhere) {
  const TemporaryFolder folder;
  const std::string path = folder.put(
      "x.png", crafted::png_rgba(5, 3, [](int, int, int c) { return c == 1 ? 0u : 255u; }));
  TextureStore store;
  for (const Encoding encoding : all_encodings) {
    const TextureHandle texture = added(store, path, encoding);
    for (int i = 0; i < 500; ++i) {
      const float t = static_cast<float>(i) * 0.0371f;
      EXPECT_EQ(store.lookup(texture, {t, -t * 1.7f}), Vec4f(1, 0, 1, 1));
    }
  }
}

TEST(Unit_Texture, AnyFloatIsACoordinate) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const TemporaryFolder folder;
  const std::string path = folder.put("x.png", crafted::png_rgba(7, 5, sample));
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float largest = std::numeric_limits<float>::max();
  TextureStore store;
  for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror, Wrap::Black}) {
    const TextureHandle texture = added(store, path, Encoding::Linear, wrap);
    for (const float u : {nan, infinity, -infinity, largest, -largest, 1e10f, 16777216.5f,
                          8388607.5f, -8388607.5f, -1e-10f, -1e-40f, 1.0f, 0.99999994f, -0.0f})
      for (const float v : {0.3f, u}) {
        const Vec4f found = store.lookup(texture, {u, v});
        store.prefetch(texture, {u, v});
        for (int c = 0; c < 4; ++c) {
          EXPECT_GE(found[c], 0) << u;
          EXPECT_LE(found[c], 1) << u;
        }
      }
  }
  const TextureHandle repeated = added(store, path);
  for (const float whole : {1.0f, -3.0f, 4096.0f, 16777216.0f, 1e20f})
    EXPECT_EQ(store.lookup(repeated, {whole, 0.3f}), store.lookup(repeated, {0, 0.3f})) << whole;
  EXPECT_EQ(store.lookup(repeated, {nan, 0.3f}), store.lookup(repeated, {0, 0.3f}));
  EXPECT_EQ(store.lookup(repeated, {4096.25f, 0.3f}), store.lookup(repeated, {0.25f, 0.3f}));
}

TEST(Unit_Texture, GreyFillsColourAndMissingAlphaIsOne) {
  const TemporaryFolder folder;
  TextureStore store;
  const auto value = [](int, int, int c) { return c == 0 ? 51u : 102u; };
  const auto lookup = [&](const char* name, crafted::PngColour colour) {
    const std::string path = folder.put(name, crafted::png_of(2, 2, colour, 8, value));
    return store.lookup(added(store, path), {0.3f, 0.3f});
  };
  EXPECT_EQ(lookup("g.png", crafted::Grey), Vec4f(0.2f, 0.2f, 0.2f, 1));
  EXPECT_EQ(lookup("ga.png", crafted::GreyAlpha), Vec4f(0.2f, 0.2f, 0.2f, 0.4f));
  EXPECT_EQ(lookup("rgb.png", crafted::Rgb), Vec4f(0.2f, 0.4f, 0.4f, 1));
  EXPECT_EQ(lookup("rgba.png", crafted::Rgba), Vec4f(0.2f, 0.4f, 0.4f, 0.4f));
}

TEST(Unit_Texture, SixteenBitsAndFloatsDecodeAsPreciselyAsTheyAre) {
  const TemporaryFolder folder;
  const std::string deep = folder.put(
      "deep.png",
      crafted::png_of(2, 1, crafted::Grey, 16, [](int, int, int) { return 257u * 30 + 5; }));
  Image image(2, 1, {"R", "G", "B"});
  image.values = {3.5f, 0.5f, 0.25f, 3.5f, 0.5f, 0.25f};
  const std::string wide = folder.file("wide.exr");
  ASSERT_FALSE(write_image(wide, image, {}).has_errors());
  TextureStore store;
  const double stored = (257 * 30 + 5) / 65535.0;
  const Vec2f uv{0.4f, 0.7f};
  EXPECT_NEAR(store.lookup(added(store, deep), uv).x, stored, 1e-8);
  EXPECT_NEAR(store.lookup(added(store, deep, Encoding::Srgb), uv).x, linear_of(stored), 1e-8);
  EXPECT_NEAR(store.lookup(added(store, deep, Encoding::LabGamma), uv).x, std::pow(stored, 2.2),
              1e-8);
  EXPECT_EQ(store.lookup(added(store, wide), uv), Vec4f(3.5f, 0.5f, 0.25f, 1));
  EXPECT_NEAR(store.lookup(added(store, wide, Encoding::Srgb), uv).x, linear_of(3.5), 1e-5);
  EXPECT_EQ(store.info(added(store, deep)).bytes, 4u);
  EXPECT_EQ(store.info(added(store, wide)).bytes, 24u);
}

template <class Number>
std::string put_exr(const TemporaryFolder& folder, const std::string& name,
                    const ImageHeader& header, const std::vector<float>& values) {
  DecodedImage image{header, allocate_samples(header)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Number number(values[i]);
    std::memcpy(image.samples.get() + i * sizeof number, &number, sizeof number);
  }
  const Result<std::string> bytes = encode_samples(image, -1);
  if (!bytes) throw std::runtime_error(to_string(bytes.diagnostics.list()[0]));
  return folder.put(name, Bytes(bytes->begin(), bytes->end()));
}

TEST(Unit_Texture, HalvesStayHalvesAndWhatIsNotFiniteIsReplacedAndTold) {
  const TemporaryFolder folder;
  const std::string path =
      put_exr<Imath::half>(folder, "half.exr", {4, 1, SampleType::Half, {"Y"}},
                           {0.5f, std::numeric_limits<float>::infinity(), NAN, -0.25f});
  TextureStore store;
  const TextureHandle texture = added(store, path);
  EXPECT_EQ(store.info(texture).bytes, 8u);
  const auto texel = [&](float i) { return store.lookup(texture, {(i + 0.5f) / 4, 0.5f}).x; };
  EXPECT_EQ(texel(0), 0.5f);
  EXPECT_EQ(texel(1), 65504.0f);
  EXPECT_EQ(texel(2), 0.0f);
  EXPECT_EQ(texel(3), -0.25f);
  const Diagnostics found = store.decoding_diagnostics();
  ASSERT_EQ(found.warning_count(), 1u);
  EXPECT_NE(found.list()[0].message.find("2 values that are not finite"), std::string::npos);
}

std::vector<std::string> files_of_all_kinds(const TemporaryFolder& folder) {
  std::vector<float> values;
  for (int i = 0; i < 7 * 5 * 4; ++i)
    values.push_back(static_cast<float>(sample(i, 3, 1)) / 100 - 0.5f);
  const std::vector<std::string> rgba = {"R", "G", "B", "A"};
  return {folder.put("rgba.png", crafted::png_rgba(7, 5, sample)),
          folder.put("rgb.png", crafted::png_of(7, 5, crafted::Rgb, 8, sample)),
          folder.put("grey.png", crafted::png_of(7, 5, crafted::GreyAlpha, 8, sample)),
          folder.put("deep.png",
                     crafted::png_of(7, 5, crafted::Rgba, 16,
                                     [](int x, int y, int c) { return 251 * sample(x, y, c); })),
          put_exr<Imath::half>(folder, "half.exr", {7, 5, SampleType::Half, rgba}, values),
          put_exr<float>(folder, "float.exr", {7, 5, SampleType::Float, rgba}, values)};
}

// Visibility asks for alpha alone, shading for all: one answer, whatever file and encoding.
TEST(Unit_Texture, AlphaAloneHasTheSameBits) {
  const TemporaryFolder folder;
  const std::vector<std::string> paths = files_of_all_kinds(folder);
  TextureStore store;
  for (const std::string& path : paths)
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror, Wrap::Black})
      for (const Encoding encoding : all_encodings) {
        const TextureHandle texture = added(store, path, encoding, wrap);
        for (int i = 0; i < 500; ++i) {
          const Vec2f uv{std::fmod(static_cast<float>(i) * 0.618034f, 4.0f) - 2,
                         std::fmod(static_cast<float>(i) * 0.754878f, 4.0f) - 2};
          ASSERT_EQ(store.lookup_alpha_at(texture, {.uv = uv}), store.lookup(texture, uv).w)
              << path << " at " << uv.x << ' ' << uv.y;
        }
      }
}

// Tables over all texels read whole rows: those of a lookup at each texel's centre. All bytes.
TEST(Unit_Texture, RowsHaveTheBitsOfTheirTexels) {
  const TemporaryFolder folder;
  std::vector<std::string> paths = files_of_all_kinds(folder);
  paths.push_back(
      folder.put("bytes.png", crafted::png_of(256, 2, crafted::Rgb, 8, [](int x, int, int c) {
                   return static_cast<unsigned>((x + 85 * c) % 256);
                 })));
  TextureStore store;
  for (const std::string& path : paths)
    for (const Encoding encoding : all_encodings) {
      const TextureHandle texture = added(store, path, encoding, Wrap::Clamp);
      const TextureInfo& size = store.info(texture);
      for (int y = 0; y < size.height; ++y) {
        const std::vector<Vec4f> row = store.texels(texture, y);
        ASSERT_EQ(row.size(), static_cast<std::size_t>(size.width));
        for (int x = 0; x < size.width; ++x)
          ASSERT_EQ(row[static_cast<std::size_t>(x)], store.texel(texture, x, y))
              << path << " at " << x << ' ' << y;
      }
    }
}

// The lab takes the first texel of what is one texel wide or high; the others filter along it.
TEST(Unit_Texture, ALineOfTexelsIsOneColourInTheLabsEncodingAlone) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.png", crafted::png_of(4, 1, crafted::Grey, 8, sample));
  TextureStore store;
  const TextureHandle lab = added(store, path, Encoding::LabGamma);
  const TextureHandle linear = added(store, path);
  const TextureHandle gamma = added(store, path, Encoding::Gamma22);
  EXPECT_NEAR(store.lookup(gamma, {0.625f, 0.2f}).x, std::pow(sample(2, 0, 0) / 255.0, 2.2), 1e-6);
  EXPECT_NEAR(store.lookup(lab, {0.625f, 0.2f}).x, std::pow(sample(0, 0, 0) / 255.0, 2.2), 1e-7);
  EXPECT_NEAR(store.lookup(linear, {0.625f, 0.2f}).x, sample(2, 0, 0) / 255.0, 1e-6);
}

TEST(Unit_TextureStore, EqualRequestsAreOneAndEqualPathsShareTheirPixels) {
  const TemporaryFolder folder;
  const std::string path = folder.put("x.png", crafted::png_rgba(8, 8, sample));
  TextureStore store;
  const TextureHandle first = added(store, path);
  EXPECT_EQ(added(store, path), first);
  EXPECT_EQ(added(store, folder.path() + "/./x.png"), first);
  const TextureHandle other = added(store, path, Encoding::Srgb);
  EXPECT_NE(other, first);
  EXPECT_NE(added(store, path, Encoding::Linear, Wrap::Clamp), first);
  EXPECT_EQ(store.size(), 3u);
  store.prefetch(first, {0, 0});
  EXPECT_FALSE(store.is_decoded(first)) << "nor does asking the memory";
  EXPECT_EQ(store.decoded_bytes(), 0u);
  (void)store.lookup(other, {0, 0});
  EXPECT_TRUE(store.is_decoded(first));
  EXPECT_EQ(store.decoded_bytes(), 256u);
  EXPECT_EQ(store.path(first), path);
  TextureStore moved = std::move(store);
  EXPECT_NEAR(moved.lookup(first, {0.0625f, 0.9375f}).x, sample(0, 0, 0) / 255.0, 1e-6);
}

TEST(Errors_TextureStore, WhatCannotBeReadIsMagentaWithAWarningAtItsPlace) {
  const TemporaryFolder folder;
  folder.put("broken.png", std::string("no image"));
  const auto file = std::make_shared<const std::string>("scene.yaml");
  for (const char* name : {"none.png", "broken.png", "x.gif", ""}) {
    TextureStore store;
    Diagnostics found;
    const TextureHandle texture = store.add(
        {*name == 0 ? "" : folder.file(name), Encoding::Srgb, Wrap::Black, {file, 3, 9}}, found);
    EXPECT_FALSE(found.has_errors());
    ASSERT_EQ(found.warning_count(), 1u) << name;
    EXPECT_EQ(to_string(found.list()[0]).find("scene.yaml:3:9: warning: texture '"), 0u);
    EXPECT_NE(found.list()[0].message.find("; it is magenta"), std::string::npos);
    EXPECT_EQ(store.lookup(texture, {0.5f, 0.5f}), Vec4f(1, 0, 1, 1));
  }
}

// libpng cannot be kept from a line on the error stream here.
TEST(Errors_TextureStore, PixelsThatBreakWhenTheyAreNeededAreMagentaToo) {
  const TemporaryFolder folder;
  crafted::Png image;
  image.width = image.height = 4;
  image.samples = crafted::Bytes(12, 1);  // a quarter of what the header says
  const std::string path = folder.put("x.png", crafted::png(image));
  TextureStore store;
  const TextureHandle texture = added(store, path);
  EXPECT_TRUE(store.decoding_diagnostics().list().empty());
  testing::internal::CaptureStderr();
  EXPECT_EQ(store.lookup(texture, {0.1f, 0.2f}), Vec4f(1, 0, 1, 1));
  (void)testing::internal::GetCapturedStderr();
  const Diagnostics found = store.decoding_diagnostics();
  ASSERT_EQ(found.warning_count(), 1u);
  EXPECT_NE(found.list()[0].message.find("; it is magenta"), std::string::npos);
}

// Whether the header or the pixels are what is broken.
TEST(Errors_TextureStore, WhatIsBrokenLeavesOpaqueWhatIsOpaque) {
  const TemporaryFolder folder;
  crafted::Png image;
  image.width = image.height = 4;
  image.samples = crafted::Bytes(36, 1);
  folder.put("pixels.png", crafted::png(image));
  folder.put("header.png", std::string("no image"));
  for (const char* name : {"pixels.png", "header.png"}) {
    TextureStore store;
    Diagnostics found;
    const TextureHandle texture =
        store.add({folder.file(name), Encoding::Linear, Wrap::Repeat, {}}, found);
    testing::internal::CaptureStderr();
    EXPECT_EQ(store.scalar_kind(texture), TextureStore::ScalarKind::Alpha) << name;
    (void)testing::internal::GetCapturedStderr();
  }
}

}  // namespace
}  // namespace candela
