// The film that writes image files (LuxRender's "fleximage").
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <stdexcept>

#include "camera_response_choice.h"
#include "color_space.h"
#include "exr_encoder.h"
#include "film_accumulator.h"
#include "film_settings.h"
#include "lxs/imaging/atomic_file.h"
#include "lxs/imaging/imaging.h"
#include "png_encoder.h"

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

class FlexImage final : public FileFilm {
  public:
    FlexImage(FilmSettings settings, std::vector<std::string> group_names,
              const PixelFilter& filter)
        : settings_(std::move(settings)),
          group_names_(std::move(group_names)),
          filter_(filter),
          accumulator_(width(), height(), light_groups(), filter) {}

    std::uint32_t width() const override { return settings_.frame.width; }
    std::uint32_t height() const override { return settings_.frame.height; }
    std::uint32_t light_groups() const override {
        return static_cast<std::uint32_t>(group_names_.size());
    }
    void add_pass(const PassSamples& samples) override { accumulator_.add(samples); }
    void add_splats(const PassSplats& splats) override { accumulator_.add_splats(splats); }
    void add_layer_pass(std::string_view name, const PassSamples& samples) override;
    void clear() override;
    void set_layer(std::string_view name, std::span<const float> values) override;

    std::string base_name() const override { return settings_.base_name; }
    double halt_time_seconds() const override { return settings_.halt_time_seconds; }
    std::uint64_t halt_passes() const override { return settings_.halt_passes; }
    double write_interval_seconds() const override { return settings_.write_interval_seconds; }
    double display_interval_seconds() const override { return settings_.display_interval_seconds; }
    std::uint64_t refused_samples() const override;
    RefusalList refusals() const override;
    std::size_t memory_bytes() const override;

    void state(StateArchive& archive) override;
    void set_wavelengths(const Wavelengths& wavelengths) override;
    void set_exposure(double stops) override { settings_.tone_map.exposure_stops = stops; }
    std::vector<Rgb> image() const override;
    std::vector<std::uint8_t> tone_mapped() const override {
        return tone_map(image(), settings_.tone_map);
    }
    std::string_view tone_map_kernel() const override { return name(settings_.tone_map.kernel); }
    void write_exr(const std::string& path, const ImageMetadata& metadata) const override;
    void write_png(const std::string& path) const override;

  private:
    FilmAccumulator& color_layer(std::string_view name);
    void color_layers_state(StateArchive& archive);
    void float_layers_state(StateArchive& archive);
    /// The sums of an accumulator as the film's colours.
    template <class Resolve>
    std::vector<Rgb> film_colors(const Resolve& resolve) const {
        std::vector<Rgb> values(pixels());
        resolve(values);
        if (settings_.to_film_colors) {
            for (Rgb& c : values)
                c = (*settings_.to_film_colors)(c);
        }
        return values;
    }
    std::size_t pixels() const { return std::size_t{width()} * height(); }

    FilmSettings settings_;
    std::vector<std::string> group_names_;
    PixelFilter filter_;
    FilmAccumulator accumulator_;
    std::map<std::string, FilmAccumulator, std::less<>> color_layers_;
    std::map<std::string, std::vector<float>, std::less<>> layers_;
    std::map<std::string, std::uint64_t> refused_layer_values_;  ///< by float layer
    std::optional<Wavelengths> wavelengths_;                     ///< none: passes are RGB
};

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
}

void FlexImage::clear() {
    accumulator_.clear();
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

RefusalList FlexImage::refusals() const {
    RefusalList list;
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
    return list;
}

std::uint64_t FlexImage::refused_samples() const {
    std::uint64_t sum = 0;
    for (const Refusal& refusal : refusals())
        sum += refusal.count;
    return sum;
}

void FlexImage::state(StateArchive& archive) {
    accumulator_.state(archive);
    color_layers_state(archive);
    float_layers_state(archive);
}

void FlexImage::color_layers_state(StateArchive& archive) {
    // A layer holds four sums a pixel: no layer is made that the archive hasn't the bytes for.
    const std::size_t layer_bytes = pixels() * 4 * sizeof(double);
    const std::size_t count = archive.count(color_layers_.size(), layer_bytes);
    if (!archive.restoring()) {
        for (auto& [name, layer] : color_layers_) {
            std::string saved = name;
            archive.text(saved);
            layer.state(archive);
        }
        return;
    }
    color_layers_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        std::string name;
        archive.text(name);
        if (archive.remaining() < layer_bytes) throw StateError("a layer of the film is cut off");
        color_layer(name).state(archive);
    }
}

void FlexImage::float_layers_state(StateArchive& archive) {
    const std::size_t layer_bytes = pixels() * sizeof(float);
    const std::size_t count = archive.count(layers_.size(), layer_bytes);
    if (!archive.restoring()) {
        for (auto& [name, values] : layers_) {
            std::string saved = name;
            archive.text(saved);
            archive.values(values);
        }
        return;
    }
    layers_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        std::string name;
        std::vector<float> values;
        archive.text(name);
        archive.values(values);
        if (values.size() != pixels()) throw StateError("a layer of the film has another size");
        set_layer(name, values);
    }
}

std::size_t FlexImage::memory_bytes() const {
    std::size_t bytes = accumulator_.memory_bytes() + layers_.size() * pixels() * sizeof(float);
    for (const auto& [name, layer] : color_layers_) {
        bytes += layer.memory_bytes();
    }
    return bytes;
}

std::vector<Rgb> FlexImage::image() const {
    return film_colors([this](std::span<Rgb> values) { accumulator_.resolve_total(values); });
}

void FlexImage::write_exr(const std::string& path, const ImageMetadata& metadata) const {
    std::vector<ColorLayer> colors{{"", image()}};
    for (std::uint32_t g = 0; light_groups() > 1 && g < light_groups(); ++g) {
        colors.push_back({group_names_[g], film_colors([&](std::span<Rgb> values) {
                              accumulator_.resolve_group(g, values);
                          })});
    }
    for (const auto& [name, layer] : color_layers_) {
        colors.push_back({name, film_colors([&resolved = layer](std::span<Rgb> values) {
                              resolved.resolve_total(values);
                          })});
    }
    std::vector<FloatLayer> floats;
    for (const auto& [name, values] : layers_) {
        floats.push_back({name, values});
    }
    write_file_atomically(path, encode_for(path, [&] {
                              return encode_exr(settings_.frame, colors, floats, metadata);
                          }));
}

void FlexImage::write_png(const std::string& path) const {
    const std::vector<std::uint8_t> rgb = tone_mapped();
    write_file_atomically(path, encode_for(path, [&] {
                              return encode_png(width(), height(), settings_.tone_map.gamma, rgb);
                          }));
}

}  // namespace

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
