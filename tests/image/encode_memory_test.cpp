// Where memory lacks while pictures are encoded, that is said and nothing else.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <fstream>
#include <random>

#include "renderer/image/encode.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CANDELA_NEEDS_ADDRESS_SPACE 1
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CANDELA_NEEDS_ADDRESS_SPACE 1
#endif

namespace candela {
namespace {

enum Outcome : int { Encoded, Refused, Lacking };

std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

Outcome encode_within(std::size_t bytes, ImageFormat format, const Image& image) {
  const rlimit limit{address_space() + bytes, RLIM_INFINITY};
  ::setrlimit(RLIMIT_AS, &limit);
  try {
    return encode_image(format, image, {}) ? Encoded : Refused;
  } catch (const std::exception&) {  // std::bad_alloc, or oneTBB's where no thread can be started
    return Lacking;
  }
}

// In a process of its own.
int outcome_within(std::size_t bytes, ImageFormat format, const Image& image) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(encode_within(bytes, format, image));
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Errors_EncodeImage, WithoutTheMemory) {
#ifdef CANDELA_NEEDS_ADDRESS_SPACE
  GTEST_SKIP() << "the sanitizer needs more address space than the limits";
#endif
  Image noise(1024, 1024, {"R", "G", "B"});
  std::mt19937 random(1);
  for (float& value : noise.values) value = static_cast<float>(random()) * 0x1p-32f;
  constexpr std::size_t step = std::size_t{1} << 20;
  for (const ImageFormat format : {ImageFormat::Exr, ImageFormat::Png}) {
    int too_small = 0;
    int outcome = Lacking;
    for (std::size_t i = 0; i < 100 && outcome == Lacking; ++i) {
      outcome = outcome_within(i * step, format, noise);
      too_small += outcome == Lacking ? 1 : 0;
    }
    EXPECT_EQ(outcome, Encoded) << too_small << " limits were too small";
    EXPECT_GT(too_small, 0);
  }
}

}  // namespace
}  // namespace candela
