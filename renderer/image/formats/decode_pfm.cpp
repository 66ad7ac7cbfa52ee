#include "renderer/image/formats/decode_pfm.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <string_view>

namespace candela {
namespace {

struct PfmFile {
  int width = 0, height = 0;
  std::size_t channels = 0;
  std::endian order = std::endian::little;
  std::size_t data = 0;  // where the rows begin
};

// What stands before the rows: words, each followed by one white space.
class Words {
 public:
  explicit Words(const Bytes& bytes)
      : text_(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), longest)) {}

  std::string_view next() {
    if (place_ >= text_.size()) return {};
    const std::size_t begin = place_;
    while (place_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[place_])) == 0)
      ++place_;
    const std::string_view word = text_.substr(begin, place_ - begin);
    ++place_;
    return word;
  }
  [[nodiscard]] std::size_t place() const { return place_; }

 private:
  static constexpr std::size_t longest = 64;
  std::string_view text_;
  std::size_t place_ = 0;
};

template <class Number>
std::optional<Number> number(std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<PfmFile> pfm_file(const Bytes& bytes) {
  Words words(bytes);
  const std::string_view kind = words.next();
  if (kind != "PF" && kind != "Pf") return std::nullopt;
  const auto width = number<int>(words.next()), height = number<int>(words.next());
  const auto scale = number<float>(words.next());
  if (!width || !height || !scale || *width <= 0 || *height <= 0) return std::nullopt;
  if (*scale != 1 && *scale != -1) return std::nullopt;
  const PfmFile file{*width, *height, kind == "PF" ? std::size_t{3} : 1,
                     *scale < 0 ? std::endian::little : std::endian::big, words.place()};
  const double needed = 4.0 * *width * *height * static_cast<double>(file.channels);
  if (static_cast<double>(file.data) + needed > static_cast<double>(bytes.size()))
    return std::nullopt;
  return file;
}

void swap_bytes(std::byte* samples, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) std::reverse(samples + 4 * i, samples + 4 * i + 4);
}

}  // namespace

std::optional<ImageHeader> plain_pfm_header(const Bytes& bytes) {
  const auto file = pfm_file(bytes);
  if (!file) return std::nullopt;
  ImageHeader header;
  header.width = file->width;
  header.height = file->height;
  header.sample_type = SampleType::Float;
  header.channels =
      file->channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
  header.alpha_is_straight = true;
  return header;
}

Result<DecodedImage> decode_plain_pfm(const Bytes& bytes, const ImageHeader& header) {
  const auto file = pfm_file(bytes);
  if (!file) return failure("is damaged");
  DecodedImage decoded;
  decoded.header = header;
  decoded.samples = allocate_samples(header);
  const auto rows = static_cast<std::size_t>(header.height);
  const std::size_t row_bytes = header.sample_count() / rows * sizeof(float);
  for (std::size_t y = 0; y < rows; ++y)
    std::memcpy(decoded.samples.get() + y * row_bytes,
                bytes.data() + file->data + (rows - 1 - y) * row_bytes, row_bytes);
  if (file->order != std::endian::native) swap_bytes(decoded.samples.get(), header.sample_count());
  return decoded;
}

}  // namespace candela
