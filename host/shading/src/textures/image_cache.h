// The images that the textures of one registry share.
#pragma once

#include <any>
#include <memory>
#include <mutex>
#include <string>

#include "lxs/images/image_library.h"
#include "lxs/scene/registry.h"

namespace lxs::shading {

/// Asks for the image library with the first image texture, and never without one.
class ImageCache {
  public:
    /// An image made ready for lookups.
    struct Image {
        std::shared_ptr<const CachedImage> texels;
        std::string path;
        SourceLocation where;  ///< of the parameter that names it
    };

    /// Opens the file `path`, its texels decoded, and reads it once, unless that was done
    /// ahead; values that are not finite or negative are reported in one warning. Throws InputError
    /// at `reader`'s filename when it can't be read.
    Image open(const std::string& path, const StoredCurve& curve, const ParameterReader& reader,
               const AssetContext& assets);
    /// The same without a message, for Factory::read_file.
    std::any open_ahead(const std::string& path) { return Texels(images().open(path)); }

  private:
    using Texels = std::shared_ptr<const CachedImage>;
    CachedImages& images();

    std::mutex mutex_;
    std::unique_ptr<CachedImages> images_;
};

}  // namespace lxs::shading
