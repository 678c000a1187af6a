// The images that the textures of one registry share.
#include "image_cache.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

namespace lxs::shading {

CachedImages& ImageCache::images() {
    const std::lock_guard lock(mutex_);
    if (!images_) images_ = image_library().make_cache();
    return *images_;
}

ImageCache::Image ImageCache::open(const std::string& path, const StoredCurve& curve,
                                   const ParameterReader& reader, const AssetContext& assets) {
    CachedImages& cache = images();
    Texels texels;
    try {
        const std::any ahead = assets.take_ahead(std::string(reader.plugin()), path);
        const auto* known = std::any_cast<Texels>(&ahead);
        texels = known ? *known : Texels(cache.open(path));
        if (curve.changes()) texels = texels->decoded(curve);
    } catch (const std::bad_alloc&) {
        throw EndOfReading(reader.where("filename"),
                           fmt::format("not enough memory for the image in \"{}\"", path));
    } catch (const std::runtime_error& error) {
        reader.fail("filename", fmt::format("cannot read image \"{}\": {}", path, error.what()));
    }
    if (texels->refused() > 0) {
        reader.diagnostics().warning(reader.where("filename"),
                                     fmt::format("image \"{}\" has {} values that are not finite "
                                                 "or negative; 0 is used",
                                                 path, texels->refused()));
    }
    return {std::move(texels), path, reader.where("filename")};
}

}  // namespace lxs::shading
