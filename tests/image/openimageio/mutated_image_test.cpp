// Seeded damage to small files of every kind: a sentence or a picture, never a crash, and nothing
// on the error stream. The variable CANDELA_MUTATED_COPIES asks for more.
#include <gtest/gtest.h>

#include <cstdlib>

#include "renderer/image/decode.h"
#include "tests/image/crafted_files.h"
#include "tests/image/openimageio/sample_files.h"

namespace candela {
namespace {

// Numbers from a counter, the same wherever the test runs.
class Stream {
 public:
  explicit Stream(std::uint64_t seed) : seed_(seed) {}
  std::size_t below(std::size_t limit) { return next() % limit; }

 private:
  std::uint64_t next() {  // splitmix64
    std::uint64_t z = (seed_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t seed_;
};

std::uint64_t copies_of(std::uint64_t usual) {
  const char* const asked = std::getenv("CANDELA_MUTATED_COPIES");
  return asked == nullptr ? usual : std::strtoull(asked, nullptr, 10);
}

void damage_once(crafted::Bytes& bytes, std::size_t reach, Stream& stream) {
  if (bytes.empty()) return;
  const std::size_t place = stream.below(std::min(reach, bytes.size()));
  const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(place);
  switch (stream.below(8)) {
    case 0:
    case 1:
      *at = static_cast<unsigned char>(*at ^ (1u << stream.below(8)));
      return;
    case 2:
    case 3:
      *at = static_cast<unsigned char>(stream.below(256));
      return;
    case 4:
      *at = 255;
      return;
    case 5:
      *at = 0;
      return;
    case 6:
      bytes.erase(
          at, at + static_cast<std::ptrdiff_t>(std::min(stream.below(16), bytes.size() - place)));
      return;
    default:
      if (stream.below(4) == 0) bytes.resize(place);
  }
}

// Half of the damage falls into the first 200 bytes, where headers are.
crafted::Bytes damaged(crafted::Bytes bytes, std::uint64_t seed) {
  Stream stream(seed);
  const std::size_t reach = stream.below(2) == 0 ? 200 : bytes.size();
  const std::size_t count = 1 + stream.below(6);
  for (std::size_t i = 0; i < count; ++i)
    damage_once(bytes, std::max<std::size_t>(reach, 1), stream);
  return bytes;
}

// Headers are read without a decoder where that is possible: they say what is decoded all the same.
void expect_header_of(const std::string& name, const crafted::Bytes& bytes,
                      const DecodeLimits& limits, const ImageHeader& decoded) {
  const Result<ImageHeader> header = decode_header(name, bytes, limits);
  ASSERT_TRUE(header) << name;
  EXPECT_EQ(header->width, decoded.width) << name;
  EXPECT_EQ(header->height, decoded.height) << name;
  EXPECT_EQ(header->channels, decoded.channels) << name;
  EXPECT_EQ(header->sample_type, decoded.sample_type) << name;
  EXPECT_EQ(header->alpha_channel, decoded.alpha_channel) << name;
  EXPECT_EQ(header->alpha_is_straight, decoded.alpha_is_straight) << name;
}

void expect_sentence_or_picture(const std::string& name, const crafted::Bytes& bytes) {
  DecodeLimits limits;
  limits.max_bytes = std::size_t{64} << 20;
  const Result<DecodedImage> image = decode_image(name, bytes, limits);
  if (image) {
    EXPECT_GT(image->header.sample_count(), 0u);
    expect_header_of(name, bytes, limits, image->header);
    return;
  }
  ASSERT_EQ(image.diagnostics.error_count(), 1u);
  const std::string& message = image.diagnostics.list().front().message;
  EXPECT_EQ(message.find("'" + name + "' "), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Errors_MutatedImage, ThousandsOfDamagedFilesGiveSentencesOrPictures) {
  const std::uint64_t copies = copies_of(1000);
  const auto files = sample_files();
  testing::internal::CaptureStderr();
  for (const auto& [name, bytes] : files)
    for (std::uint64_t copy = 0; copy < copies; ++copy)
      expect_sentence_or_picture(name, damaged(bytes, copy * 1000003 + bytes.size()));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Checksums would stop most damage at the door.
TEST(Errors_MutatedImage, DamagedPngsWithRightChecksumsToo) {
  const std::uint64_t copies = copies_of(2000);
  testing::internal::CaptureStderr();
  for (const auto& [name, bytes] : sample_files())
    if (name.ends_with(".png"))
      for (std::uint64_t copy = 0; copy < copies; ++copy)
        expect_sentence_or_picture(name, crafted::with_right_checksums(damaged(bytes, copy)));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace candela
