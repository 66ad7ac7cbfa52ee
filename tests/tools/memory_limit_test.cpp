// Where memory lacks for an image that candela decodes itself, the program ends with 5 and says so:
// the image does not count as damaged, and no picture comes out otherwise.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "renderer/image/image_io.h"
#include "tests/address_space.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Words = std::vector<std::string>;

ProgramResult run_within(std::size_t kibibytes, const Words& arguments) {
  Words words{"/bin/sh", "-c", fmt::format("ulimit -v {}; exec \"$0\" \"$@\"", kibibytes)};
  for (const std::string& word : candela_words(arguments)) words.push_back(word);
  return Program(words, ErrorStream::File).finish();
}

// The least address space, to a mebibyte, in which the arguments end well.
std::size_t least_kibibytes(const Words& arguments) {
  std::size_t fails = 0;
  std::size_t ends_well = std::size_t{4} << 20;
  EXPECT_EQ(run_within(ends_well, arguments).exit_code, 0);
  while (ends_well - fails > 1024) {
    const std::size_t middle = (fails + ends_well) / 2;
    (run_within(middle, arguments).exit_code == 0 ? ends_well : fails) = middle;
  }
  return ends_well;
}

// Within what suffices for `small` and ever more until it suffices for `large`. Decoding such
// images takes more than what the stack may still grow by, for want of which the system ends the
// process.
void expect_success_or_five(const Words& small, const Words& large) {
  if (!test::can_limit_address_space)
    GTEST_SKIP() << "the sanitizer needs more address space than the limits";
  constexpr std::size_t step = 1536;
  constexpr int most = 100;
  std::size_t limit = least_kibibytes(small);
  int too_small = 0;
  for (int i = 0; i < most; ++i, limit += step) {
    const ProgramResult result = run_within(limit, large);
    if (result.exit_code == 0) {
      EXPECT_EQ(result.error, "") << "what the render says otherwise";
      EXPECT_GT(too_small, 0) << "no limit was too small";
      return;
    }
    ++too_small;
    EXPECT_EQ(result.exit_code, 5) << limit << " KiB: " << result.error;
    EXPECT_NE(result.error.find("out of memory"), std::string::npos) << result.error;
  }
  ADD_FAILURE() << "no limit was enough";
}

Words render_of(const std::string& scene, const std::string& output, const std::string& size) {
  return {"render",       scene, "-q",     "-t", "1",  "--spp", "1",
          "--replicates", "1",   "--size", size, "-o", output};
}

// A floor with an image, and one without.
Words scene_with(const std::string& folder, const std::string& image) {
  const std::string texture =
      image.empty() ? ""
                    : "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + image +
                          "\"\nMaterial \"diffuse\" \"texture reflectance\" \"t\"\n";
  const std::string path = folder + (image.empty() ? "/plain.pbrt" : "/textured.pbrt");
  write_text(path, "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n" + texture +
                       "Translate 0 0 5 Shape \"disk\"\n");
  return render_of(path, folder + "/out.png", "8x8");
}

void expect_image_or_five(const std::string& name, int width, int height) {
  const std::string folder = fresh_folder("memory_" + name);
  const Image image(width, height, {"R", "G", "B"});
  ASSERT_FALSE(write_image(folder + "/" + name, image, {}).has_errors());
  expect_success_or_five(scene_with(folder, ""), scene_with(folder, name));
}

TEST(Errors_MemoryLimit, ImagesAreNotDamagedByIt) {
  expect_image_or_five("wide.exr", 60000, 64);
}

TEST(Errors_MemoryLimit, PngImagesAreNotDamagedByIt) {
  expect_image_or_five("wide.png", 60000, 64);
}

TEST(Errors_MemoryLimit, JpegImagesAreNotDamagedByIt) {
  expect_image_or_five("wide.jpg", 60000, 64);
}

}  // namespace
}  // namespace candela::cli_test
