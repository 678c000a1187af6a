// OpenImageIO's texture system as the image textures of one registry share it.
#include "image_cache.h"

#include <OpenImageIO/imagecache.h>
#include <fmt/format.h>

#include "cleaned_input.h"

namespace lxs::shading {
namespace {

constexpr float kCacheMegabytes = 512;
constexpr int kTileSize = 64;

/// First line of an OpenImageIO message without its full stop.
std::string first_line(const std::string& text) {
    std::string line = text.substr(0, text.find('\n'));
    while (!line.empty() && (line.back() == '.' || line.back() == ' '))
        line.pop_back();
    return line.empty() ? "unknown reason" : line;
}

void check(CleanedInput& input, const std::string& path, const ParameterReader& reader) {
    OIIO::ImageSpec spec;
    const OIIO::ImageSpec configuration = CleanedInput::configuration(path);
    if (!input.open(path, spec, configuration) || !input.read_through()) {
        reader.fail("filename", fmt::format("cannot read image \"{}\": {}", path,
                                            first_line(input.geterror())));
    }
    if (input.refused() > 0) {
        reader.diagnostics().warning(reader.where("filename"),
                                     fmt::format("image \"{}\" has {} values that are not finite "
                                                 "or negative; 0 is used",
                                                 path, input.refused()));
    }
}

}  // namespace

ImageCache::~ImageCache() {
    for (const OIIO::ustring& name : names_)
        system_->invalidate(name, true);
    if (system_) OIIO::TextureSystem::destroy(system_);
}

void ImageCache::create() {
    // The process-wide one: OpenImageIO 2.4 frees a private one with the wrong size.
    system_ = OIIO::TextureSystem::create(true);
    system_->attribute("gray_to_rgb", 1);
    OIIO::ImageCache* cache = system_->imagecache();
    cache->attribute("max_memory_MB", kCacheMegabytes);
    cache->attribute("autotile", kTileSize);
    cache->attribute("automip", 0);
    cache->attribute("accept_untiled", 1);
    cache->attribute("accept_unmipped", 1);
    cache->attribute("forcefloat", 1);
}

std::string ImageCache::own_name(const std::string& path) const {
    return fmt::format("{}?cleaned-{}", path, fmt::ptr(this));
}

void ImageCache::fail_lookup(const Image& image) {
    const std::string reason = image.system->has_error() ? image.system->geterror() : "";
    throw InputError(image.where, fmt::format("image \"{}\" can't be read any more: {}", image.path,
                                              first_line(reason)));
}

ImageCache::Image ImageCache::open(const std::string& path, const ParameterReader& reader) {
    CleanedInput input;
    check(input, path, reader);
    const std::lock_guard lock(mutex_);
    if (!system_) create();
    const OIIO::ustring name(own_name(path));
    const OIIO::ImageSpec configuration = CleanedInput::configuration(path);
    system_->imagecache()->add_file(name, &CleanedInput::create, &configuration);
    system_->invalidate(name, true);  // another scene may have read an older version of the file
    names_.push_back(name);
    auto* handle = system_->get_texture_handle(name);
    if (!handle || !system_->good(handle)) {
        reader.fail("filename", fmt::format("cannot read image \"{}\": {}", path,
                                            first_line(system_->geterror())));
    }
    return {system_,
            handle,
            input.spec().nchannels,
            input.spec().alpha_channel,
            path,
            reader.where("filename")};
}

}  // namespace lxs::shading
