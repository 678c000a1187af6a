// OpenImageIO's texture system as a cache of images.
#include "texture_system.h"

#include <OpenImageIO/imagecache.h>
#include <fmt/format.h>

#include <stdexcept>

#include "checked_input.h"
#include "cleaned_input.h"

namespace lxs {
namespace {

constexpr float kCacheMegabytes = 512;
constexpr int kTileSize = 64;

[[noreturn]] void fail(const std::string& text) {
    throw std::runtime_error(first_line(text));
}

OIIO::TextureOpt::Wrap wrap_of(TexelLookup::Outside outside) {
    switch (outside) {
        case TexelLookup::Outside::Repeat:
            return OIIO::TextureOpt::WrapPeriodic;
        case TexelLookup::Outside::Black:
            return OIIO::TextureOpt::WrapBlack;
        case TexelLookup::Outside::Clamp:
            break;
    }
    return OIIO::TextureOpt::WrapClamp;
}

class SystemImage final : public CachedImage {
  public:
    struct Facts {
        int channels, alpha_channel;
        std::uint64_t refused;
    };

    SystemImage(TextureSystemImages& images, std::string path, const Facts& facts,
                const StoredCurve& curve)
        : images_(images),
          handle_(images.handle_of(path, curve)),
          path_(std::move(path)),
          facts_(facts) {}

    int channels() const override { return facts_.channels; }
    int alpha_channel() const override { return facts_.alpha_channel; }
    std::uint64_t refused() const override { return facts_.refused; }
    void look_up(float s, float t, int first, const TexelLookup& how,
                 std::span<float> values) const override {
        OIIO::TextureOpt options;
        options.swrap = options.twrap = wrap_of(how.outside);
        options.mipmode = OIIO::TextureOpt::MipModeNoMIP;
        options.interpmode =
            how.interpolated ? OIIO::TextureOpt::InterpBilinear : OIIO::TextureOpt::InterpClosest;
        options.firstchannel = first;
        OIIO::TextureSystem& system = images_.system();
        const bool read = system.texture(handle_, nullptr, options, s, t, 0, 0, 0, 0,
                                         static_cast<int>(values.size()), values.data());
        if (!read) fail(system.has_error() ? system.geterror() : "");
    }
    std::unique_ptr<const CachedImage> decoded(const StoredCurve& curve) const override {
        return std::make_unique<SystemImage>(images_, path_, facts_, curve);
    }

  private:
    TextureSystemImages& images_;
    OIIO::TextureSystem::TextureHandle* handle_;
    std::string path_;
    Facts facts_;
};

}  // namespace

TextureSystemImages::TextureSystemImages() : system_(OIIO::TextureSystem::create(true)) {
    system_->attribute("gray_to_rgb", 1);
    const auto cache = system_->imagecache();
    cache->attribute("max_memory_MB", kCacheMegabytes);
    cache->attribute("autotile", kTileSize);
    cache->attribute("automip", 0);
    cache->attribute("accept_untiled", 1);
    cache->attribute("accept_unmipped", 1);
    cache->attribute("forcefloat", 1);
}

TextureSystemImages::~TextureSystemImages() {
    for (const OIIO::ustring& name : names_)
        system_->invalidate(name, true);
    OIIO::TextureSystem::destroy(system_);
}

std::string TextureSystemImages::own_name(const std::string& path, const StoredCurve& curve) const {
    return fmt::format("{}?cleaned-{}-{}", path, fmt::ptr(this),
                       curve.srgb ? std::string("srgb") : fmt::format("{}", curve.gamma));
}

OIIO::TextureSystem::TextureHandle* TextureSystemImages::handle_of(const std::string& path,
                                                                   const StoredCurve& curve) {
    const OIIO::ImageSpec configuration = CleanedInput::configuration(path, curve);
    const std::lock_guard lock(mutex_);
    const OIIO::ustring name(own_name(path, curve));
    system_->imagecache()->add_file(name, &CleanedInput::create, &configuration);
    system_->invalidate(name, true);  // another scene may have read an older version of the file
    names_.push_back(name);
    auto* handle = system_->get_texture_handle(name);
    if (!handle || !system_->good(handle)) fail(system_->geterror());
    return handle;
}

std::unique_ptr<const CachedImage> TextureSystemImages::open(const std::string& path) {
    CleanedInput input;
    OIIO::ImageSpec spec;
    const OIIO::ImageSpec configuration = CleanedInput::configuration(path, {});
    const bool good =
        with_reasons([&] { return input.open(path, spec, configuration) && input.read_through(); });
    if (!good) fail(input.geterror());
    return std::make_unique<SystemImage>(
        *this, path,
        SystemImage::Facts{input.spec().nchannels, input.spec().alpha_channel, input.refused()},
        StoredCurve{});
}

}  // namespace lxs
