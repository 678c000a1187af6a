// The film that writes image files (LuxRender's "fleximage").
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <stdexcept>

#include "camera_response_choice.h"
#include "exr_encoder.h"
#include "film_settings.h"
#include "flex_image.h"
#include "lxs/imaging/atomic_file.h"
#include "png_encoder.h"
#include "sum_to_image.h"

namespace lxs {
namespace {

/// What `encode` gives; its exceptions then name the file that isn't written.
template <class Encode>
std::vector<std::byte> encode_for(const std::string& path, const Encode& encode) {
    try {
        return encode();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("cannot write '{}': {}", path, error.what()));
    }
}

/// An image that no file could hold would be found out when all has been rendered.
void check_layer_name(std::string_view name) {
    constexpr std::size_t kLongest = 200;  // bytes; OpenEXR's names of channels have 255
    const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    });
    if (!name.empty() && name.size() <= kLongest && printable) return;
    throw std::invalid_argument(
        fmt::format("film: a layer's name must have 1 to {} printable "
                    "bytes, found {}",
                    kLongest, in_quotes(name)));
}

void copy_to(std::span<Rgb> values, const std::vector<Rgb>& from) {
    std::copy(from.begin(), from.end(), values.begin());
}

/// Colours of what covers a pixel alone. Where so little does that 8 bits call it nothing, black.
void divide_by_alpha(std::span<Rgb> colors, std::span<const float> alpha) {
    constexpr float kLeast = 0.5f / 255;
    for (std::size_t i = 0; i < colors.size(); ++i)
        colors[i] = alpha[i] < kLeast ? Rgb(0.0f) : colors[i] / alpha[i];
}

}  // namespace

void FlexImage::add_layer_pass(std::string_view name, const PassSamples& samples) {
    check_layer_name(name);
    const bool is_group = light_groups() > 1 && std::find(group_names_.begin(), group_names_.end(),
                                                          name) != group_names_.end();
    if (is_group) {
        throw std::runtime_error(
            fmt::format("film: no layer can be named '{}', which is a light group", name));
    }
    color_layer(name).add(samples);
}

FilmAccumulator& FlexImage::color_layer(std::string_view name) {
    const auto known = color_layers_.find(name);
    if (known != color_layers_.end()) return known->second;
    FilmAccumulator layer(width(), height(), 1, filter_);
    if (wavelengths_) layer.set_conversion(wavelengths_->to_rgb, wavelengths_->white);
    return color_layers_.emplace(std::string(name), std::move(layer)).first->second;
}

void FlexImage::set_wavelengths(const Wavelengths& wavelengths) {
    wavelengths_ = wavelengths;
    accumulator_.set_conversion(wavelengths.to_rgb, wavelengths.white);
    for (auto& [name, layer] : color_layers_)
        layer.set_conversion(wavelengths.to_rgb, wavelengths.white);
    if (bias_) bias_->set_conversion(wavelengths.to_rgb, wavelengths.white);
    if (asked_) asked_->set_wavelengths(wavelengths);
    if (denoise_) denoise_->set_wavelengths(wavelengths);
    if (display_) display_->set_conversion(wavelengths.to_rgb);
}

void FlexImage::add_pass(const PassSamples& samples) {
    accumulator_.add(samples);
    if (display_) display_->add(samples, accumulator_);
    if (error_) error_->add(samples);
}

void FlexImage::add_splats(const PassSplats& splats) {
    accumulator_.add_splats(splats);
    if (display_) display_->add_splats(splats, accumulator_);
    if (error_) error_->add(splats);
}

void FlexImage::estimate_errors(bool wanted) {
    error_.reset();
    if (wanted) error_.emplace(width(), height());
}

void FlexImage::keep_for_denoising(bool wanted) {
    denoise_.reset();
    if (wanted) denoise_.emplace(width(), height(), filter_);
    if (wanted && wavelengths_) denoise_->set_wavelengths(*wavelengths_);
}

LayersWanted FlexImage::layers_wanted() const {
    LayersWanted wanted = settings_.layers;
    if (denoise_) wanted.albedo = wanted.normal = wanted.depth = true;
    return wanted;
}

void FlexImage::end_pass() {
    if (bias_) bias_->end_pass();
    if (error_) error_->end_pass(accumulator_);
    if (denoise_) denoise_->end_pass(accumulator_);
}

std::optional<ErrorEstimate> FlexImage::error() const {
    if (!error_) return std::nullopt;
    return error_->estimate(accumulator_, bias_ ? &*bias_ : nullptr);
}

bool FlexImage::is_asked(std::string_view name) const {
    const auto names = FilmLayers::names(settings_.layers);
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a layer of the scene's or of the integrator's has this name.
bool FlexImage::names_layer(std::string_view name) const {
    const auto& groups = group_names_;
    return (groups.size() > 1 && std::find(groups.begin(), groups.end(), name) != groups.end()) ||
           color_layers_.contains(name) || layers_.contains(name) || is_asked(name);
}

bool FlexImage::has_error_layer() const {
    return error_ && error_->known() && !names_layer(kErrorLayer);
}

void FlexImage::clear() {
    accumulator_.clear();
    if (error_) error_->clear();
    if (bias_) bias_->clear();
    if (denoise_) denoise_->clear();
    if (asked_) asked_->clear();
    if (display_) display_->clear();
    for (auto& [name, layer] : color_layers_) {
        layer.clear();
    }
}

void FlexImage::set_layer(std::string_view name, std::span<const float> values) {
    check_layer_name(name);
    if (values.size() != pixels()) {
        throw std::invalid_argument(
            fmt::format("film: layer '{}' has {} values, not {}", name, values.size(), pixels()));
    }
    std::vector<float>& layer = layers_[std::string(name)];
    layer.assign(values.begin(), values.end());
    for (float& value : layer) {
        if (std::isfinite(value)) continue;
        value = 0;
        ++refused_layer_values_[std::string(name)];
    }
}

InvalidSampleList FlexImage::invalid_samples() const {
    InvalidSampleList list;
    const auto add = [&](const std::string& origin, std::uint64_t count) {
        if (count > 0) list.push_back({origin, count});
    };
    const auto refused = accumulator_.refused_by_group();
    for (std::uint32_t g = 0; g < light_groups(); ++g)
        add(fmt::format("light group \"{}\"", group_names_[g]), refused[g]);
    add("positions on the film", refused.back());
    for (const auto& [name, layer] : color_layers_)
        add(fmt::format("layer \"{}\"", name), layer.refused_samples());
    for (const auto& [name, count] : refused_layer_values_)
        add(fmt::format("layer \"{}\"", name), count);
    if (bias_) add(fmt::format("layer \"{}\"", kBiasLayer), bias_->refused_samples());
    if (asked_) {
        const InvalidSampleList asked = asked_->invalid_samples();
        list.insert(list.end(), asked.begin(), asked.end());
    }
    return list;
}

std::uint64_t FlexImage::refused_samples() const {
    std::uint64_t sum = 0;
    for (const InvalidSamples& invalid : invalid_samples())
        sum += invalid.count;
    return sum;
}

std::size_t FlexImage::memory_bytes() const {
    std::size_t bytes = accumulator_.memory_bytes() + layers_.size() * pixels() * sizeof(float);
    for (const auto& [name, layer] : color_layers_) {
        bytes += layer.memory_bytes();
    }
    if (error_) bytes += error_->memory_bytes();
    if (denoise_) bytes += denoise_->memory_bytes();
    if (bias_) bytes += bias_->memory_bytes();
    if (asked_) bytes += asked_->memory_bytes();
    if (display_) bytes += display_->memory_bytes();
    return bytes;
}

std::vector<Rgb> FlexImage::image() const {
    return film_colors([this](std::span<Rgb> values) { accumulator_.resolve_total(values); });
}

std::vector<Rgb> FlexImage::shown() const {
    return shown({});
}

/// Of the image, or of `denoised` if there is one. `with_outliers`, unless null: the same before
/// they are left out.
std::vector<Rgb> FlexImage::shown(std::span<const Rgb> denoised,
                                  std::vector<Rgb>* with_outliers) const {
    std::vector<Rgb> values(denoised.begin(), denoised.end());
    if (!display_) return values.empty() ? image() : values;
    const std::vector<Rgb> measured = image();
    if (values.empty()) values = measured;
    const std::vector<Rgb> all =
        film_colors([this](std::span<Rgb> v) { copy_to(v, display_->image(accumulator_)); });
    if (filter_.has_negative_weights()) show_without_lobes(values, measured, all);
    if (with_outliers) *with_outliers = values;
    // Denoising has a way of its own with them.
    if (!display_->rejects() || !denoised.empty()) return values;
    const std::vector<Rgb> kept = film_colors(
        [this](std::span<Rgb> v) { copy_to(v, display_->image_without_outliers(accumulator_)); });
    const float radius = std::max(filter_.radius_x(), filter_.radius_y());
    show_without_outliers(values,
                          {all, kept, width(), static_cast<std::uint32_t>(std::ceil(radius))});
    return values;
}

std::optional<double> FlexImage::outliers_left_out() const {
    if (!display_ || !display_->rejects()) return std::nullopt;
    std::vector<Rgb> all;
    const std::vector<Rgb> kept = shown({}, &all);
    return share_left_out(all, kept);
}

std::vector<Rgb> FlexImage::denoised() const {
    if (!denoise_ || !denoise_->known()) return {};
    std::vector<Rgb> values = denoise_->image(accumulator_);
    accumulator_.settle_denoised(values);
    to_film_colors(values);
    return values;
}

FileLayers FlexImage::file_layers(const ImageMetadata& metadata,
                                  std::span<const Rgb> denoised) const {
    FileLayers layers{
        .frame = settings_.frame, .colors = {{"", image()}}, .floats = {}, .metadata = metadata};
    std::vector<ColorLayer>& colors = layers.colors;
    for (std::uint32_t g = 0; light_groups() > 1 && g < light_groups(); ++g) {
        colors.push_back({group_names_[g], film_colors([&](std::span<Rgb> values) {
                              accumulator_.resolve_group(g, values);
                          })});
    }
    sum_to_image(std::span(colors).subspan(1), colors.front().values);
    for (const auto& [name, layer] : color_layers_) {
        colors.push_back({name, film_colors([&resolved = layer](std::span<Rgb> values) {
                              resolved.resolve_total(values);
                          })});
    }
    if (has_error_layer()) {
        colors.push_back({std::string(kErrorLayer), film_colors([this](std::span<Rgb> values) {
                              error_->standard_errors(accumulator_, values);
                          })});
    }
    if (bias_) colors.push_back({std::string(kBiasLayer), bias_colors()});
    constexpr std::string_view kDenoised = "denoised";
    if (!denoised.empty() && !names_layer(kDenoised))
        colors.push_back({std::string(kDenoised), {denoised.begin(), denoised.end()}});
    for (const auto& [name, values] : layers_) {
        layers.floats.push_back({name, values});
    }
    if (asked_) asked_->append_to(layers, [this](std::span<Rgb> c) { to_film_colors(c); });
    return layers;
}

/// The film's colours are none below zero: too bright and too dark are converted apart.
std::vector<Rgb> FlexImage::bias_colors() const {
    std::vector<Rgb> bias(pixels());
    bias_->values(bias);
    const auto part = [&](float sign) {
        return film_colors([&](std::span<Rgb> values) {
            std::transform(bias.begin(), bias.end(), values.begin(), [sign](const Rgb& b) {
                const Rgb c = b * sign;
                return Rgb(std::max(c.x, 0.0f), std::max(c.y, 0.0f), std::max(c.z, 0.0f));
            });
        });
    };
    std::vector<Rgb> colors = part(1);
    const std::vector<Rgb> dark = part(-1);
    for (std::size_t i = 0; i < colors.size(); ++i)
        colors[i] -= dark[i];
    return colors;
}

void FlexImage::write_png(const std::string& path, std::span<const Rgb> denoised) const {
    std::vector<Rgb> colors = shown(denoised);
    const std::vector<float> alpha = asked_ ? asked_->alpha() : std::vector<float>();
    if (hides_background()) divide_by_alpha(colors, alpha);
    const std::vector<std::uint8_t> rgb = tone_map(colors, settings_.tone_map);
    write_file_atomically(path, encode_for(path, [&] {
                              return encode_png(width(), height(), settings_.tone_map.gamma, rgb,
                                                alpha);
                          }));
}

void write_exr(const std::string& path, const FileLayers& layers) {
    write_file_atomically(path, encode_for(path, [&] { return encode_exr(layers); }));
}

void FileFilm::write_exr(const std::string& path, const ImageMetadata& metadata,
                         std::span<const Rgb> denoised) const {
    lxs::write_exr(path, file_layers(metadata, denoised));
}

std::unique_ptr<FileFilm> make_film(const SceneContents& contents, Diagnostics& diagnostics,
                                    const FileResolver& resolve) {
    FilmSettings settings = read_film_settings(contents, diagnostics);
    settings.tone_map.response = choose_camera_response(settings, diagnostics, resolve);
    const PixelFilter filter = make_pixel_filter(contents, diagnostics);
    std::vector<std::string> groups = contents.light_groups;
    if (groups.empty()) groups.emplace_back("default");
    const FilmFrame frame = settings.frame;
    const std::size_t group_count = groups.size();
    const double values = double(frame.width) * frame.height * (1 + 3 * double(group_count));
    try {
        if (values > kMaxFilmValues) throw std::bad_alloc();
        return std::make_unique<FlexImage>(std::move(settings), std::move(groups), filter);
    } catch (const std::bad_alloc&) {
        const auto film = contents.options.find("Film");
        throw InputError(
            film == contents.options.end() ? contents.end : film->second.parameters.where,
            fmt::format("not enough memory for a film of {} x {} pixels and {} light groups",
                        frame.width, frame.height, group_count));
    }
}

}  // namespace lxs
