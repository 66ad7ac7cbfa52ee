#include "renderer/image/openimageio/encode_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/openimageio/sample_type.h"

namespace candela {
namespace {

using OIIO::ImageSpec;
using OIIO::TypeDesc;

void add_attribute(ImageSpec& spec, const EncodableAttribute& attribute) {
  const auto& [name, value] = attribute;
  if (const auto* text = std::get_if<std::string>(&value))
    spec.attribute(name, *text);
  else if (const auto* number = std::get_if<double>(&value))
    spec.attribute(name, TypeDesc::DOUBLE, number);
  else
    spec.attribute(name, std::get<int>(value));
}

ImageSpec spec_of(const Encodable& image) {
  const ImageHeader& header = image.header;
  ImageSpec spec(header.width, header.height, static_cast<int>(header.channels.size()),
                 type_desc_of(header.sample_type));
  spec.channelnames = header.channels;
  spec.alpha_channel = header.alpha_channel;
  spec.attribute("oiio:UnassociatedAlpha", header.alpha_is_straight ? 1 : 0);
  for (const EncodableAttribute& attribute : image.attributes) add_attribute(spec, attribute);
  return spec;
}

}  // namespace

Result<std::string> encode_file(ImageFormat format, const Encodable& image) {
  const FloatingPointTraps traps(Traps::Off);
  const std::string name(name_of(format));
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) return failure(OIIO::geterror());
  std::vector<unsigned char> buffer;
  OIIO::Filesystem::IOVecOutput memory(buffer);
  if (!output->supports("ioproxy") || !output->set_ioproxy(&memory))
    return failure("cannot encode in memory");
  const ImageSpec spec = spec_of(image);
  const bool is_done = output->open("memory." + name, spec) &&
                       output->write_image(spec.format, image.samples) && output->close();
  if (!is_done || output->has_error()) return failure(output->geterror());
  return std::string(buffer.begin(), buffer.end());
}

}  // namespace candela
