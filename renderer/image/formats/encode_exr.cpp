#include "renderer/image/formats/encode_exr.h"

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <ctime>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/formats/exr_slices.h"

namespace candela {
namespace {

class FileInMemory final : public Imf::OStream {
 public:
  FileInMemory() : OStream("memory.exr") {}

  void write(const char* bytes, int count) override {
    const std::size_t end = place_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    bytes_.replace(place_, static_cast<std::size_t>(count), bytes, static_cast<std::size_t>(count));
    place_ = end;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t place_ = 0;
};

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm local{};
  localtime_r(&seconds, &local);
  return fmt::format("{:04}:{:02}:{:02} {:02}:{:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1,
                     local.tm_mday, local.tm_hour, local.tm_min, local.tm_sec);
}

void insert(Imf::Header& header, const EncodableAttribute& attribute) {
  const std::string name = attribute.first == "DateTime" ? "capDate" : attribute.first;
  if (const auto* text = std::get_if<std::string>(&attribute.second))
    header.insert(name, Imf::StringAttribute(*text));
  else if (const auto* number = std::get_if<double>(&attribute.second))
    header.insert(name, Imf::DoubleAttribute(*number));
  else
    header.insert(name, Imf::IntAttribute(std::get<int>(attribute.second)));
}

Imath::Box2i window(int left, int top, int width, int height) {
  return {{left, top}, {left + width - 1, top + height - 1}};
}

Imf::Header header_of(const Encodable& image) {
  const ImageHeader& picture = image.header;
  Imf::Header header(window(0, 0, image.full_width, image.full_height),
                     window(picture.left, picture.top, picture.width, picture.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const std::string& channel : picture.channels)
    header.channels().insert(channel, Imf::Channel(exr_pixel_type(picture)));
  for (const EncodableAttribute& attribute : image.attributes) insert(header, attribute);
  if (header.find("capDate") == header.end()) insert(header, {"DateTime", now()});
  return header;
}

// The table of where its rows lie is written when the file's object ends.
void write_to(FileInMemory& memory, const Encodable& image) {
  constexpr int threads = 0;  // of OpenEXR's own
  Imf::OutputFile file(memory, header_of(image), threads);
  file.setFrameBuffer(exr_slices(image.header, image.samples));  // which it only reads
  file.writePixels(image.header.height);
}

}  // namespace

Result<std::string> encode_exr(const Encodable& image) {
  const FloatingPointTraps traps(Traps::Off);
  try {
    FileInMemory memory;
    write_to(memory, image);
    return memory.take();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    return failure(exception.what());
  }
}

}  // namespace candela
