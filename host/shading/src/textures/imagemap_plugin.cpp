// Texture "imagemap": an image file.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "ignored_parameter.h"
#include "image_cache.h"
#include "lxs/scene/constant_texture.h"
#include "lxs/spectrum/reflectance_colour.h"
#include "lxs/spectrum/stored_curve.h"
#include "texture_parameters.h"
#include "texture_plugins.h"
#include "uv_mapping.h"
#include "wrap.h"

namespace lxs::shading {
namespace {

constexpr std::array<std::string_view, 4> kFilters{"bilinear", "nearest", "mipmap_trilinear",
                                                   "mipmap_ewa"};
constexpr std::array<std::string_view, 4> kColorSpaces{"gamma", "srgb", "gamma_texels",
                                                       "srgb_texels"};
constexpr std::array<std::string_view, 6> kChannels{"mean", "red",   "green",
                                                    "blue", "alpha", "colored_mean"};

/// What float and colour lookups have in common.
class ImageLookup {
  public:
    ImageLookup(const ParameterReader& reader, const AssetContext& assets, const Matrix& to_world,
                std::shared_ptr<ImageCache> cache);

    const ImageCache::Image& image() const { return image_; }
    float gain() const { return gain_; }
    /// `count` channels of the image from `first` on.
    void read(const TexturePoint& point, int first, int count, float* values) const;
    /// Red, green, blue; grey images give three equal values.
    Rgb color(const TexturePoint& point) const;
    /// The same, as it is to be handed to materials.
    Rgb surface_color(const TexturePoint& point) const;

  private:
    /// The same place in a coordinate that doesn't overflow OpenImageIO's texel numbers.
    float near_image(float x) const {
        return how_.outside == TexelLookup::Outside::Repeat ? x - std::floor(x)
                                                            : std::clamp(x, -1.0f, 2.0f);
    }

    std::shared_ptr<ImageCache> cache_;
    ImageCache::Image image_;
    TexelLookup how_;
    UvMapping mapping_;
    StoredCurve curve_;  ///< of what is interpolated
    float gain_;
    bool plain_colors_, times_alpha_, white_outside_;
};

ImageLookup::ImageLookup(const ParameterReader& reader, const AssetContext& assets,
                         const Matrix& to_world, std::shared_ptr<ImageCache> cache)
    : cache_(std::move(cache)), mapping_(reader, to_world) {
    if (!reader.given("filename")) reader.fail("filename", "imagemap: \"filename\" is missing");
    const std::string path =
        assets.resolve(reader.string("filename", ""), reader.where("filename"));
    const std::string space = reader.string("colorspace", "gamma");
    const StoredCurve curve{static_cast<float>(reader.number("gamma", 2.2)),
                            space.starts_with("srgb")};
    const bool of_texels = space.ends_with("_texels");
    image_ = cache_->open(path, of_texels ? curve : StoredCurve{}, reader, assets);
    if (!of_texels) curve_ = curve;
    gain_ = static_cast<float>(reader.number("gain", 1));
    plain_colors_ = reader.boolean("plaincolors", false);
    times_alpha_ = reader.boolean("timesalpha", false) && image_.texels->alpha_channel() == 3;
    const Wrap wrap = read_wrap(reader);
    white_outside_ = wrap == Wrap::White;
    how_.outside = wrap == Wrap::Repeat  ? TexelLookup::Outside::Repeat
                   : wrap == Wrap::Black ? TexelLookup::Outside::Black
                                         : TexelLookup::Outside::Clamp;
    const std::string filter = reader.string("filtertype", "bilinear");
    how_.interpolated = filter != "nearest";
    if (filter.starts_with("mipmap")) {
        reader.diagnostics().warning(
            reader.where("filtertype"),
            "filtertype \"" + filter + "\" is not rendered: \"bilinear\" is used instead");
    }
}

void ImageLookup::read(const TexturePoint& point, int first, int count, float* values) const {
    const Vec2 st = mapping_(point);
    const bool inside = st.x >= 0 && st.x <= 1 && st.y >= 0 && st.y <= 1;
    std::fill_n(values, count, 1.0f);
    if ((white_outside_ && !inside) || !std::isfinite(st.x) || !std::isfinite(st.y)) return;
    try {
        image_.texels->look_up(near_image(st.x), near_image(st.y), first, how_,
                               std::span(values, static_cast<std::size_t>(count)));
    } catch (const std::runtime_error& error) {
        throw InputError(image_.where,
                         "image \"" + image_.path + "\" can't be read any more: " + error.what());
    }
    if (times_alpha_ && count == 4) {
        for (int c = 0; c < 3; ++c)
            values[c] *= values[3];
    }
    // Texels are interpolated as they are stored, then the gamma is undone: LuxRender's image of a
    // fine pattern is darker by what that makes (5 % in the blue of texture-imagemap's squares).
    if (!curve_.changes()) return;
    for (int c = 0; c < count; ++c)
        if (first + c != image_.texels->alpha_channel()) values[c] = curve_.linear(values[c]);
}

Rgb ImageLookup::color(const TexturePoint& point) const {
    std::array<float, 4> values;
    const int count = times_alpha_ ? 4 : image_.texels->channels() >= 3 ? 3 : 1;
    read(point, 0, count, values.data());
    const Rgb value = count == 1 ? Rgb(values[0]) : Rgb(values[0], values[1], values[2]);
    return value * gain_;
}

Rgb ImageLookup::surface_color(const TexturePoint& point) const {
    const Rgb value = color(point);
    return plain_colors_ ? reflectance_of_colour(value) : value;
}

class ColorImageTexture final : public ColorTexture {
  public:
    explicit ColorImageTexture(ImageLookup lookup) : lookup_(std::move(lookup)) {}
    Rgb evaluate(const TexturePoint& point) const override { return lookup_.surface_color(point); }
    bool reads_image() const override { return true; }

  private:
    ImageLookup lookup_;
};

class FloatImageTexture final : public FloatTexture {
  public:
    enum class Channel : std::uint8_t { Mean, Luminance, Single };

    FloatImageTexture(ImageLookup lookup, Channel channel, int index)
        : lookup_(std::move(lookup)), channel_(channel), index_(index) {}
    float evaluate(const TexturePoint& point) const override {
        if (channel_ == Channel::Single) {
            float value = 1;
            lookup_.read(point, index_, 1, &value);
            return value * lookup_.gain();
        }
        const Rgb color = lookup_.color(point);
        return channel_ == Channel::Luminance ? luminance(color)
                                              : (color.x + color.y + color.z) / 3;
    }
    bool reads_image() const override { return true; }

  private:
    ImageLookup lookup_;
    Channel channel_;
    int index_;
};

/// LuxRender takes an image that it can't read for one of a single 1.
template <class Product>
std::shared_ptr<const Product> or_ones(const ParameterReader& reader, const auto& create,
                                       std::shared_ptr<const Product> ones) {
    try {
        return create();
    } catch (const EndOfReading&) {
        throw;
    } catch (const InputError& error) {
        reader.diagnostics().fallback(error.where(), error.message(), "1 is used everywhere");
        return ones;
    }
}

std::shared_ptr<const FloatTexture> create_float(const ParameterReader& reader,
                                                 const AssetContext& assets, const Matrix& to_world,
                                                 const std::shared_ptr<ImageCache>& cache) {
    using Channel = FloatImageTexture::Channel;
    ImageLookup lookup(reader, assets, to_world, cache);
    const std::string name = reader.string("channel", "mean");
    if (name == "mean" || name == "colored_mean") {
        const Channel channel = name == "mean" ? Channel::Mean : Channel::Luminance;
        return std::make_shared<FloatImageTexture>(std::move(lookup), channel, 0);
    }
    const CachedImage& image = *lookup.image().texels;
    const int colored = name == "green" ? 1 : name == "blue" ? 2 : 0;
    int index = image.channels() >= 3 ? colored : 0;
    if (name == "alpha") {
        if (image.alpha_channel() < 0) return std::make_shared<ConstantTexture<float>>(1.0f);
        index = image.alpha_channel();
    }
    return std::make_shared<FloatImageTexture>(std::move(lookup), Channel::Single, index);
}

std::vector<ParameterDeclaration> imagemap_parameters() {
    std::vector<ParameterDeclaration> parameters{
        {"filename", ParameterType::String, "", "image file"},
        {"gamma", ParameterType::Float, "2.2", "values are raised to this power", 1e-3},
        {"gain", ParameterType::Float, "1", "factor on the linear values", 0},
        choice("colorspace", "gamma",
               "how stored values become linear: by gamma, or (not LuxRender's) by sRGB's curve; "
               "after texels are interpolated, or (not LuxRender's) before",
               kColorSpaces),
        {"timesalpha", ParameterType::Bool, "false",
         "stored colours are multiplied by the image's alpha. Not LuxRender's."},
        {"plaincolors", ParameterType::Bool, "false",
         "surfaces show the image's colours as they are, where LuxRender turns saturated ones a "
         "little. Not LuxRender's."},
        wrap_parameter("what lies outside the image"),
        choice("filtertype", "bilinear", "texels are interpolated unless \"nearest\"", kFilters),
        ignored("maxanisotropy", ParameterType::Float, "8", "limit of the mip-map filter"),
        ignored("discardmipmaps", ParameterType::Integer, "0", "finest levels left out"),
        ignored("trilinear", ParameterType::Bool, "false", "old form of filtertype")};
    return declarations({std::move(parameters), uv_mapping_parameters()});
}

}  // namespace

void register_imagemaps(Registry& registry) {
    auto cache = std::make_shared<ImageCache>();
    const auto read_file = [cache](const std::string& path) { return cache->open_ahead(path); };
    const ParameterDeclaration channel =
        choice("channel", "mean", "channel of the image that is read", kChannels);
    std::vector<ParameterDeclaration> float_parameters = imagemap_parameters();
    float_parameters.push_back(channel);
    registry.float_textures["imagemap"] = {
        float_parameters,
        [cache](const ParameterReader& reader, const AssetContext& assets, const Matrix& to_world) {
            return or_ones<FloatTexture>(
                reader, [&] { return create_float(reader, assets, to_world, cache); },
                std::make_shared<ConstantTexture<float>>(1.0f));
        },
        read_file};
    registry.color_textures["imagemap"] = {
        imagemap_parameters(),
        [cache](const ParameterReader& reader, const AssetContext& assets,
                const Matrix& to_world) -> std::shared_ptr<const ColorTexture> {
            return or_ones<ColorTexture>(
                reader,
                [&] {
                    return std::make_shared<ColorImageTexture>(
                        ImageLookup(reader, assets, to_world, cache));
                },
                std::make_shared<ConstantTexture<Rgb>>(Rgb(1.0f)));
        },
        read_file};
}

}  // namespace lxs::shading
