// Image files read by OpenImageIO.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "checked_input.h"
#include "lxs/images/image_library.h"
#include "texture_system.h"
#include "volume_file.h"

namespace lxs {
namespace {

class OiioLibrary final : public ImageLibrary {
  public:
    FloatImage read(const std::string& path) const override;
    VoxelGrid read_grid(const std::string& path, const std::string& name) const override {
        return read_volume_file(path, name);
    }
    std::unique_ptr<CachedImages> make_cache() const override;
};

FloatImage OiioLibrary::read(const std::string& path) const {
    const auto file = open_checked(path, OIIO::ImageSpec());
    const OIIO::ImageSpec& spec = file->spec();
    const ImageClaim claim = claim_of(spec);
    if (claim.width * claim.height * claim.channels > kMostValuesAtOnce) {
        throw std::runtime_error(fmt::format("it has {} x {} x {} values, more than {}",
                                             claim.width, claim.height, claim.channels,
                                             kMostValuesAtOnce));
    }
    FloatImage image{static_cast<std::size_t>(spec.width),
                     static_cast<std::size_t>(spec.height),
                     static_cast<std::size_t>(spec.nchannels),
                     {}};
    image.values.resize(image.width * image.height * image.channels);
    const bool read = with_reasons([&] {
        return file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                                image.values.data());
    });
    // Of a TIFF file that is cut short it says that all went well; JPEG's warnings are errors to
    // it.
    const bool tiff = file->format_name() == std::string_view("tiff");
    if (!read || (tiff && file->has_error()))
        throw std::runtime_error(first_line(file->geterror()));
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
