#include "renderer/image/formats/decode_exr.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/formats/damage.h"
#include "renderer/image/formats/exr_slices.h"

namespace candela {
namespace {

// A file may point anywhere: what lies outside of it is not read.
class FileInMemory final : public Imf::IStream {
 public:
  explicit FileInMemory(const Bytes& bytes) : IStream("memory.exr"), bytes_(bytes) {}

  bool read(char* out, int count) override {
    const auto size = static_cast<std::uint64_t>(std::max(count, 0));
    if (place_ > bytes_.size() || size > bytes_.size() - place_)
      throw std::runtime_error("it ends too early");
    std::memcpy(out, bytes_.data() + place_, size);
    place_ += size;
    return place_ < bytes_.size();
  }
  std::uint64_t tellg() override { return place_; }
  void seekg(std::uint64_t place) override { place_ = place; }

 private:
  const Bytes& bytes_;
  std::uint64_t place_ = 0;
};

constexpr int threads = 0;  // of OpenEXR's own

std::vector<std::string> plain_names(std::size_t count) {
  if (count == 1) return {"Y"};
  if (count == 3) return {"R", "G", "B"};
  if (count == 4) return {"R", "G", "B", "A"};
  return {};
}

// Throws std::bad_alloc where a lack of memory is the reason, which OpenEXR tells in a type of its
// own as well: it says nothing of the file.
void throw_if_out_of_memory(const std::exception& exception) {
  const std::string_view reason = exception.what();
  if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr ||
      reason.find("Failed to allocate memory") != std::string_view::npos)
    throw std::bad_alloc();
}

// Not found, of another type or at fewer places than there are pixels: not plain.
bool is_plain(const Imf::Channel* channel, Imf::PixelType type) {
  return channel != nullptr && channel->type == type && channel->xSampling == 1 &&
         channel->ySampling == 1;
}

std::optional<ImageHeader> plain_header(const Imf::Header& file) {
  const Imf::ChannelList& channels = file.channels();
  std::size_t count = 0;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) ++count;
  ImageHeader header;
  header.channels = plain_names(count);
  if (header.channels.empty()) return std::nullopt;
  const Imf::PixelType type = channels.begin().channel().type;
  const bool all_are = std::ranges::all_of(header.channels, [&](const std::string& name) {
    return is_plain(channels.findChannel(name), type);
  });
  if (!all_are || (type != Imf::HALF && type != Imf::FLOAT)) return std::nullopt;
  const Imath::Box2i& window = file.dataWindow();
  header.width = window.max.x - window.min.x + 1;
  header.height = window.max.y - window.min.y + 1;
  header.left = window.min.x;
  header.top = window.min.y;
  header.sample_type = type == Imf::HALF ? SampleType::Half : SampleType::Float;
  header.alpha_channel = count == 4 ? 3 : -1;
  return header;
}

}  // namespace

std::optional<ImageHeader> plain_exr_header(const Bytes& bytes) {
  const FloatingPointTraps traps(Traps::Off);
  try {
    FileInMemory memory(bytes);
    return plain_header(Imf::InputFile(memory, threads).header());
  } catch (const std::exception& exception) {
    throw_if_out_of_memory(exception);
    return std::nullopt;
  }
}

Result<DecodedImage> decode_plain_exr(const Bytes& bytes, const ImageHeader& header) {
  const FloatingPointTraps traps(Traps::Off);
  DecodedImage decoded;
  decoded.header = header;
  decoded.samples = allocate_samples(header);
  try {
    FileInMemory memory(bytes);
    Imf::InputFile file(memory, threads);
    file.setFrameBuffer(exr_slices(header, decoded.samples.get()));
    file.readPixels(header.top, header.top + header.height - 1);
  } catch (const std::exception& exception) {
    throw_if_out_of_memory(exception);
    return is_damaged(exception.what());
  }
  return decoded;
}

}  // namespace candela
