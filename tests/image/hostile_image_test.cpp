// Files that lie, stop short, never end or are no files: a sentence each, and neither time nor
// memory goes by what they claim.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cstring>
#include <map>

#include "renderer/image/decode.h"
#include "renderer/image/encode.h"
#include "renderer/image/image_io.h"
#include "tests/image/crafted_files.h"
#include "tests/scenes/temporary_folder.h"

namespace candela {
namespace {

using crafted::operator+;

std::string message_of(const Diagnostics& diagnostics) {
  return diagnostics.list().empty() ? "" : diagnostics.list().front().message;
}

std::size_t peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

// Claims `side` x `side` pixels, of every kind of file.
std::map<std::string, crafted::Bytes> bombs(unsigned side) {
  const std::string number = std::to_string(side);
  crafted::Png png;
  png.width = png.height = side;
  const int signed_side = static_cast<int>(side);
  const unsigned short_side = std::min(side, 65535u);
  return {
      {"x.png", crafted::png(png)},
      {"x.hdr", crafted::text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + number + " +X " +
                              number + "\n\x02\x02")},
      {"x.ppm", crafted::text("P6\n" + number + " " + number + "\n255\nabc")},
      {"ascii.ppm", crafted::text("P3\n" + number + " " + number + "\n255\n1 2 3")},
      {"x.pfm", crafted::text("PF\n" + number + " " + number + "\n-1.0\nabcd")},
      {"x.bmp", crafted::bmp({signed_side, signed_side, 24, 0, {1, 2, 3}})},
      {"rle.bmp", crafted::bmp({signed_side, signed_side, 8, 1, {0, 1}})},
      {"x.tga", crafted::tga({2, short_side, short_side, 24, 0, 0, 0, {1, 2, 3}})},
      {"rle.tga", crafted::tga({10, short_side, short_side, 24, 0, 0, 0, {255, 1, 2, 3}})},
      {"x.exr", crafted::exr_claiming(signed_side, signed_side, false)},
      {"tiled.exr", crafted::exr_claiming(signed_side, signed_side, true)},
      {"x.tif", crafted::tiff_claiming(side, side)},
      {"x.jpg", crafted::jpeg_claiming(short_side, short_side)},
  };
}

TEST(Errors_HostileImage, NothingIsAllocatedOnAHeadersWord) {
#if defined(__SANITIZE_ADDRESS__)  // whose shadow takes an eighth of what is only reserved
  constexpr std::size_t room = std::size_t{512} << 20;
#else
  constexpr std::size_t room = std::size_t{64} << 20;
#endif
  (void)decode_image("warm.ppm", crafted::text("P3\n1 1\n255\n1 2 3\n"), {});  // loads the codecs
  // 100,000 is beyond every limit; 20,000 is not, and would be 1.2 GB of 8-bit RGB.
  for (const unsigned side : {100000u, 20000u}) {
    for (const auto& [name, bytes] : bombs(side)) {
      const std::size_t before = peak_memory_bytes();
      const Result<DecodedImage> image = decode_image(name, bytes, {});
      EXPECT_FALSE(image) << name;
      EXPECT_EQ(message_of(image.diagnostics).find("'" + name + "' "), 0u)
          << message_of(image.diagnostics);
      EXPECT_LT(peak_memory_bytes(), before + room) << name << ' ' << side;
    }
  }
}

TEST(Errors_HostileImage, ReadImageRefusesThemToo) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : bombs(100000)) {
    const Result<Image> image = read_image(folder.put(name, bytes));
    EXPECT_FALSE(image) << name;
    EXPECT_NE(message_of(image.diagnostics).find(name), std::string::npos);
  }
}

TEST(Errors_HostileImage, ATileOfAnExrMayNotBeHuge) {
  EXPECT_FALSE(decode_image("x.exr", crafted::exr_claiming(8, 8, true, 1u << 20), {}));
  EXPECT_FALSE(decode_image("x.exr", crafted::exr_claiming(8, 8, true, 0), {}));
}

std::map<std::string, crafted::Bytes> whole_files() {
  Image image(40, 30, {"R", "G", "B", "A"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>((i * 7919) % 256) / 255.0f;
  std::map<std::string, crafted::Bytes> files;
  for (const char* name : {"x.exr", "x.png", "x.jpg", "x.hdr", "x.tif"}) {
    const Result<std::string> bytes = encode_image(*format_of_extension(name), image, {});
    files[name] = crafted::text(*bytes);
  }
  files["x.ppm"] = crafted::text("P6\n10 10\n255\n" + std::string(300, 'a'));
  files["x.bmp"] = crafted::bmp({8, 8, 24, 0, crafted::Bytes(192, 5)});
  files["x.tga"] = crafted::tga({2, 8, 8, 24, 0, 0, 0, crafted::Bytes(192, 5)});
  return files;
}

bool have_equal_samples(const DecodedImage& a, const DecodedImage& b) {
  const std::size_t bytes = a.header.sample_count() * size_of(a.header.sample_type);
  return a.header.sample_count() == b.header.sample_count() &&
         std::memcmp(a.samples.get(), b.samples.get(), bytes) == 0;
}

// A TIFF ends with strings that no pixel needs; otherwise a part is never taken for the whole.
TEST(Errors_HostileImage, TruncatedFilesGiveASentenceAndNoHalfPicture) {
  for (const auto& [name, bytes] : whole_files()) {
    const Result<DecodedImage> whole = decode_image(name, bytes, {});
    ASSERT_TRUE(whole) << name;
    int refused = 0;
    constexpr int steps = 50;
    for (int step = 0; step < steps; ++step) {
      crafted::Bytes part = bytes;
      part.resize(bytes.size() * static_cast<std::size_t>(step) / steps);
      const Result<DecodedImage> image = decode_image(name, part, {});
      if (image) {
        EXPECT_TRUE(have_equal_samples(*image, *whole)) << name << ' ' << step;
        continue;
      }
      ++refused;
      EXPECT_EQ(message_of(image.diagnostics).find("'" + name + "' "), 0u);
    }
    EXPECT_GE(refused, name == "x.tif" ? steps * 9 / 10 : steps) << name;
  }
}

TEST(Errors_HostileImage, OnlyRegularFilesAreOpened) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("fifo.png").c_str(), 0600), 0);
  std::filesystem::create_directory(folder.file("folder.png"));
  std::filesystem::create_symlink("/dev/zero", folder.file("zero.png"));
  std::filesystem::create_symlink("loop.png", folder.file("loop.png"));
  const std::map<std::string, std::string> expected{
      {"fifo.png", "is a FIFO"},      {"folder.png", "is a folder"},
      {"zero.png", "is a device"},    {"loop.png", "cannot be read"},
      {"none.png", "does not exist"}, {"none/x.png", "does not exist"}};
  for (const auto& [name, reason] : expected) {
    const Result<Image> image = read_image(folder.file(name));
    EXPECT_FALSE(image);
    EXPECT_NE(message_of(image.diagnostics).find(reason), std::string::npos)
        << message_of(image.diagnostics);
  }
}

TEST(Errors_HostileImage, OtherKindsAreNotTried) {
  const crafted::Bytes gif = crafted::text("GIF89a") + crafted::Bytes(40, 0);
  EXPECT_NE(message_of(decode_image("x.gif", gif, {}).diagnostics).find("expected one of .exr"),
            std::string::npos);
  EXPECT_NE(message_of(decode_image("x.png", gif, {}).diagnostics).find("does not begin as"),
            std::string::npos);
  EXPECT_FALSE(decode_image("x.png", {}, {}));
  EXPECT_FALSE(decode_image("x", gif, {}));
}

TEST(Errors_HostileImage, ATgaIndexBeyondItsPaletteIsNoColour) {
  EXPECT_FALSE(
      decode_image("x.tga", crafted::tga({1, 1, 1, 8, 0, 2, 24, {1, 2, 3, 4, 5, 6, 2}}), {}));
  EXPECT_FALSE(
      decode_image("x.tga", crafted::tga({1, 1, 1, 16, 0, 1, 32, {1, 2, 3, 4, 255, 255}}), {}));
}

TEST(Errors_HostileImage, DamageIsFoundByChecksumsAndSaid) {
  crafted::Bytes bytes = whole_files()["x.png"];
  bytes[bytes.size() / 2] ^= 1;
  const std::string message = message_of(decode_image("x.png", bytes, {}).diagnostics);
  EXPECT_NE(message.find("is damaged"), std::string::npos) << message;
}

}  // namespace
}  // namespace candela
