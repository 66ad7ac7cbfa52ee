// Samples of any depth and any channel of them go through a file as they are.
#include <gtest/gtest.h>

#include <cstring>

#include "renderer/image/encode.h"

namespace candela {
namespace {

template <class Sample>
DecodedImage image_of(SampleType type, int width, int height, std::vector<std::string> channels) {
  DecodedImage image;
  image.header = {width, height, type, std::move(channels), -1, true};
  if (image.header.channels.back() == "A")
    image.header.alpha_channel = static_cast<int>(image.header.channels.size()) - 1;
  image.samples = allocate_samples(image.header);
  for (std::size_t i = 0; i < image.header.sample_count(); ++i) {
    const auto sample = static_cast<Sample>(37 * i + 5);
    std::memcpy(image.samples.get() + i * sizeof sample, &sample, sizeof sample);
  }
  return image;
}

DecodedImage through_a_file(const DecodedImage& image, int channel) {
  const Result<std::string> bytes = encode_samples(image, channel);
  EXPECT_TRUE(bytes) << to_string(bytes.diagnostics.list()[0]);
  Result<DecodedImage> back =
      decode_image("picture.png", Bytes(bytes->begin(), bytes->end()), DecodeLimits{});
  EXPECT_TRUE(back) << to_string(back.diagnostics.list()[0]);
  return back ? std::move(*back) : DecodedImage{};
}

template <class Sample>
void expect_samples(const DecodedImage& back, const DecodedImage& image, std::size_t channel,
                    std::size_t count) {
  ASSERT_EQ(back.header.channels.size(), count);
  const std::size_t all = image.header.channels.size();
  const std::size_t pixels = image.header.sample_count() / all;
  for (std::size_t i = 0; i < pixels * count; ++i) {
    const std::size_t from = count == 1 ? i * all + channel : i;
    EXPECT_EQ(std::memcmp(back.samples.get() + i * sizeof(Sample),
                          image.samples.get() + from * sizeof(Sample), sizeof(Sample)),
              0)
        << i;
  }
}

TEST(Unit_EncodeSamples, BytesWithStraightAlpha) {
  const auto image = image_of<std::uint8_t>(SampleType::U8, 5, 3, {"R", "G", "B", "A"});
  expect_samples<std::uint8_t>(through_a_file(image, -1), image, 0, 4);
  for (const int channel : {0, 2, 3})
    expect_samples<std::uint8_t>(through_a_file(image, channel), image,
                                 static_cast<std::size_t>(channel), 1);
}

TEST(Unit_EncodeSamples, SixteenBitsAndFloats) {
  const auto wide = image_of<std::uint16_t>(SampleType::U16, 4, 4, {"R", "G", "B"});
  expect_samples<std::uint16_t>(through_a_file(wide, -1), wide, 0, 3);
  expect_samples<std::uint16_t>(through_a_file(wide, 1), wide, 1, 1);
  const auto floats = image_of<float>(SampleType::Float, 4, 2, {"R", "G", "B"});
  expect_samples<float>(through_a_file(floats, -1), floats, 0, 3);
  expect_samples<float>(through_a_file(floats, 2), floats, 2, 1);
}

TEST(Errors_EncodeSamples, ChannelsThatAreNotThere) {
  const auto image = image_of<std::uint8_t>(SampleType::U8, 1, 1, {"Y"});
  const Result<std::string> bytes = encode_samples(image, 1);
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.diagnostics.list()[0].message, "it has no channel 1");
}

}  // namespace
}  // namespace candela
