// OpenImageIO's texture system as the image textures of one registry share it.
#include "image_cache.h"

#include <OpenImageIO/imagecache.h>
#include <fmt/format.h>

#include "linearized_input.h"

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

void check(LinearizedInput& input, const std::string& path, float gamma,
           const ParameterReader& reader) {
    OIIO::ImageSpec spec;
    const OIIO::ImageSpec configuration = LinearizedInput::configuration(path, gamma);
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
    if (system_) OIIO::TextureSystem::destroy(system_);
    if (cache_) OIIO::ImageCache::destroy(cache_);
}

void ImageCache::create() {
    cache_ = OIIO::ImageCache::create(false);
    cache_->attribute("max_memory_MB", kCacheMegabytes);
    cache_->attribute("autotile", kTileSize);
    cache_->attribute("automip", 0);
    cache_->attribute("accept_untiled", 1);
    cache_->attribute("accept_unmipped", 1);
    cache_->attribute("forcefloat", 1);
    system_ = OIIO::TextureSystem::create(false, cache_);
    system_->attribute("gray_to_rgb", 1);
}

ImageCache::Image ImageCache::open(const std::string& path, float gamma,
                                   const ParameterReader& reader) {
    LinearizedInput input;
    check(input, path, gamma, reader);
    const std::lock_guard lock(mutex_);
    if (!system_) create();
    const OIIO::ustring name(fmt::format("{}?gamma={}", path, gamma));
    const OIIO::ImageSpec configuration = LinearizedInput::configuration(path, gamma);
    cache_->add_file(name, &LinearizedInput::create, &configuration);
    auto* handle = system_->get_texture_handle(name);
    if (!handle || !system_->good(handle)) {
        reader.fail("filename", fmt::format("cannot read image \"{}\": {}", path,
                                            first_line(system_->geterror())));
    }
    return {system_, handle, input.spec().nchannels, input.spec().alpha_channel};
}

}  // namespace lxs::shading
