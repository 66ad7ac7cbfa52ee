// Where memory lacks while pictures are encoded, that is said and nothing else.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>
#include <random>

#include "renderer/base/lack_of_threads.h"
#include "renderer/base/parallel.h"
#include "renderer/image/encode.h"
#include "tests/address_space.h"

namespace candela {
namespace {

enum Outcome : int { Encoded, Refused, Lacking, Unlimited };

std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

bool limit_address_space(std::size_t bytes) {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = bytes;
  return ::setrlimit(RLIMIT_AS, &limit) == 0;
}

Outcome encode_within(std::size_t bytes, ImageFormat format, const Image& image) {
  const std::size_t taken = address_space();
  if (!limit_address_space(taken)) return Unlimited;
  void* volatile freed_by_other_tests = nullptr;  // this process ends soon
  do freed_by_other_tests = std::malloc(1 << 16);
  while (freed_by_other_tests != nullptr);
  if (!limit_address_space(taken + bytes)) return Unlimited;
  try {
    Outcome outcome = Refused;
    with_threads(1, [&] { outcome = encode_image(format, image, {}) ? Encoded : Refused; });
    return outcome;
  } catch (const std::bad_alloc&) {
    return Lacking;
  } catch (const std::exception& exception) {
    return is_lack_of_threads(exception) ? Lacking : Refused;
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
  if (!test::can_limit_address_space)
    GTEST_SKIP() << "the sanitizer needs more address space than the limits";
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
