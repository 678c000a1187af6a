// Image files read by OpenImageIO.
#include <OpenImageIO/imageio.h>

#include <stdexcept>

#include "lxs/images/image_library.h"
#include "texture_system.h"

namespace lxs {
namespace {

class OiioLibrary final : public ImageLibrary {
  public:
    FloatImage read(const std::string& path) const override;
    std::unique_ptr<CachedImages> make_cache() const override;
};

FloatImage OiioLibrary::read(const std::string& path) const {
    const auto file = OIIO::ImageInput::open(path);
    if (!file) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = file->spec();
    FloatImage image{static_cast<std::size_t>(spec.width),
                     static_cast<std::size_t>(spec.height),
                     static_cast<std::size_t>(spec.nchannels),
                     {}};
    image.values.resize(image.width * image.height * image.channels);
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
        throw std::runtime_error(file->geterror());
    return image;
}

std::unique_ptr<CachedImages> OiioLibrary::make_cache() const {
    return std::make_unique<TextureSystemImages>();
}

}  // namespace

const ImageLibrary& image_library() {
    static const OiioLibrary library;
    return library;
}

std::filesystem::path image_library_file() {
    return {};
}

}  // namespace lxs
