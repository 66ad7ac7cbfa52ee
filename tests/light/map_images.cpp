#include "tests/light/map_images.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "renderer/image/encode.h"

namespace candela::light_test {
namespace {

// Tests run as processes of their own, side by side.
std::string output_path(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(CANDELA_TEST_OUTPUT) / "light";
  std::filesystem::create_directories(folder);
  return (folder / fmt::format("{}_{}", getpid(), name)).string();
}

template <class Number>
void write(const std::string& path, int width, int height, SampleType type,
           const TexelFunction& texel) {
  DecodedImage image{{width, height, type, {"R", "G", "B"}}, nullptr};
  image.samples = allocate_samples(image.header);
  std::byte* place = image.samples.get();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec3f value = texel(x, y);
      for (int c = 0; c < 3; ++c, place += sizeof(Number)) {
        const auto number = static_cast<Number>(value[c]);
        std::memcpy(place, &number, sizeof number);
      }
    }
  const Result<std::string> bytes = encode_samples(image, -1);
  if (!bytes || write_file_atomically(path, *bytes).has_errors())
    throw std::runtime_error("cannot write " + path);
}

}  // namespace

description::Image write_float_map(const std::string& name, int width, int height,
                                   const TexelFunction& texel) {
  description::Image image;
  image.path = output_path(name + ".exr");
  write<float>(image.path, width, height, SampleType::Float, texel);
  return image;
}

description::Image write_byte_map(const std::string& name, int width, int height,
                                  const TexelFunction& texel) {
  description::Image image;
  image.path = output_path(name + ".png");
  image.encoding = description::Encoding::LabGamma;
  write<unsigned char>(image.path, width, height, SampleType::U8, texel);
  return image;
}

namespace {

template <class Map>
MapEnvironment map_of(const description::Image& image, const Mat3d& world_from_map,
                      std::size_t max_cells) {
  MapEnvironment result;
  Map map;
  map.image = description::ImageHandle(std::size_t{0});
  map.world_from_map = world_from_map;
  result.environment =
      build_environment(map, std::span(&image, 1), result.textures, result.diagnostics, max_cells);
  return result;
}

}  // namespace

MapEnvironment lat_long(const description::Image& image, const Mat3d& world_from_map,
                        std::size_t max_cells) {
  return map_of<description::LatLongEnvironment>(image, world_from_map, max_cells);
}

MapEnvironment equal_area(const description::Image& image, const Mat3d& world_from_map,
                          std::size_t max_cells) {
  return map_of<description::EqualAreaEnvironment>(image, world_from_map, max_cells);
}

MapEnvironment cube(const std::array<description::Image, 6>& faces, std::size_t max_cells) {
  MapEnvironment result;
  description::CubeEnvironment map;
  for (std::size_t i = 0; i < 6; ++i) map.faces[i] = description::ImageHandle(i);
  result.environment =
      build_environment(map, faces, result.textures, result.diagnostics, max_cells);
  return result;
}

}  // namespace candela::light_test
