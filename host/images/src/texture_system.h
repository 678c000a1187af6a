// OpenImageIO's texture system as a cache of images.
#pragma once

#include <OpenImageIO/Imath.h>
#include <OpenImageIO/texture.h>

#include <mutex>

#include "lxs/images/image_library.h"

namespace lxs {

/// The texture system, created with it: the process-wide one, as OpenImageIO 2.4 frees a private
/// one with the wrong size.
class TextureSystemImages final : public CachedImages {
  public:
    TextureSystemImages();
    ~TextureSystemImages() override;
    TextureSystemImages(const TextureSystemImages&) = delete;
    TextureSystemImages& operator=(const TextureSystemImages&) = delete;

    std::unique_ptr<const CachedImage> open(const std::string& path) override;

    /// What the texture system knows the file `path` by, decoded. Throws std::runtime_error
    /// with the reason if it can't be read.
    OIIO::TextureSystem::TextureHandle* handle_of(const std::string& path,
                                                  const StoredCurve& curve);
    OIIO::TextureSystem& system() { return *system_; }

  private:
    /// Names the reader of `path` that is this cache's alone: scenes of one process share the
    /// texture system, and one that ends or starts must not take the files of another away.
    std::string own_name(const std::string& path, const StoredCurve& curve) const;

    std::mutex mutex_;
    /// A pointer, which OpenImageIO 3 counts.
    decltype(OIIO::TextureSystem::create(true)) system_;
    std::vector<OIIO::ustring> names_;  ///< of the virtual files opened, given back at the end
};

}  // namespace lxs
