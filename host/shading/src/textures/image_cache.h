// OpenImageIO's texture system as the image textures of one registry share it.
#pragma once

#include <OpenImageIO/Imath.h>
#include <OpenImageIO/texture.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lxs/sdk/parameters.h"

namespace lxs::shading {

/// The texture system, created with the first image texture and never without one.
class ImageCache {
  public:
    ImageCache() = default;
    ~ImageCache();
    ImageCache(const ImageCache&) = delete;
    ImageCache& operator=(const ImageCache&) = delete;

    /// An image made ready for lookups.
    struct Image {
        OIIO::TextureSystem* system = nullptr;
        OIIO::TextureSystem::TextureHandle* handle = nullptr;
        int channels = 0;
        int alpha_channel = -1;
        std::string path;
        SourceLocation where;  ///< of the parameter that names it
    };

    /// Opens the file `path` and reads it once; values that are not finite or negative are
    /// reported in one warning. Throws InputError at `reader`'s filename when it can't be read.
    Image open(const std::string& path, const ParameterReader& reader);
    /// For a lookup that failed: throws InputError at the image's parameter.
    [[noreturn]] static void fail_lookup(const Image& image);

  private:
    void create();
    /// Names the reader of `path` that is this cache's alone: scenes of one process share the
    /// texture system, and one that ends or starts must not take the files of another away.
    std::string own_name(const std::string& path) const;

    std::mutex mutex_;
    OIIO::TextureSystem* system_ = nullptr;
    std::vector<OIIO::ustring> names_;  ///< of the virtual files opened, given back at the end
};

}  // namespace lxs::shading
