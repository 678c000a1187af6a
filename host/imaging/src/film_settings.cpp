// What the Film statement asks for.
#include "film_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "color_space.h"
#include "film_layers.h"
#include "film_parameters.h"
#include "lxs/imaging/layer_names.h"
#include "no_effect.h"
#include "option_choice.h"

namespace lxs {
namespace {

class SilentDiagnostics : public Diagnostics {
  public:
    void warning(const SourceLocation&, const std::string&) override {}
    void unknown_parameter(const SourceLocation&, const std::string&) override {}
    void fallback(const SourceLocation&, const std::string&, const std::string&) override {}
};

std::uint32_t read_resolution(const ParameterReader& reader, std::string_view name,
                              std::int64_t fallback) {
    const std::int64_t value = reader.integer(name, fallback);
    if (value < 1 || static_cast<std::uint64_t>(value) > kMaxFilmPixels) {
        reader.fail(name,
                    fmt::format("{} is {}, but must be from 1 to {}", name, value, kMaxFilmPixels));
    }
    return static_cast<std::uint32_t>(value);
}

/// A crop window's bounds along one axis, put in order.
std::array<double, 2> ordered(const ParameterReader& reader, double low, double high) {
    if (low <= high) return {low, high};
    reader.diagnostics().warning(
        reader.where("cropwindow"),
        fmt::format("cropwindow has its bounds {} and {} reversed; they are swapped", low, high));
    return {high, low};
}

/// First pixel and number of pixels: those whose left edge lies in the window, at least one.
std::array<std::uint32_t, 2> pixel_range(const std::array<double, 2>& bounds,
                                         std::uint32_t resolution) {
    const auto edge = [&](double t) {
        return static_cast<std::uint32_t>(std::ceil(t * resolution - 1e-6));
    };
    const std::uint32_t first = std::min(edge(bounds[0]), resolution - 1);
    const std::uint32_t end = std::max(edge(bounds[1]), first + 1);
    return {first, end - first};
}

FilmFrame read_frame(const ParameterReader& reader) {
    FilmFrame frame;
    frame.x_resolution = read_resolution(reader, "xresolution", frame.x_resolution);
    frame.y_resolution = read_resolution(reader, "yresolution", frame.y_resolution);
    const std::uint64_t pixels = std::uint64_t{frame.x_resolution} * frame.y_resolution;
    if (pixels > kMaxFilmPixels) {
        reader.fail("xresolution",
                    fmt::format("{} x {} pixels are {}, more than the limit of {}",
                                frame.x_resolution, frame.y_resolution, pixels, kMaxFilmPixels));
    }
    std::array<double, 4> crop{0, 1, 0, 1};
    if (reader.given("cropwindow")) {
        const auto values = reader.numbers("cropwindow");
        if (values.size() == crop.size()) {
            std::copy(values.begin(), values.end(), crop.begin());
        } else {
            reader.diagnostics().fallback(
                reader.where("cropwindow"),
                fmt::format("cropwindow takes 4 numbers, found {}", values.size()),
                "its default is used");
        }
    }
    const auto columns = pixel_range(ordered(reader, crop[0], crop[1]), frame.x_resolution);
    const auto rows = pixel_range(ordered(reader, crop[2], crop[3]), frame.y_resolution);
    frame.x = columns[0];
    frame.width = columns[1];
    frame.y = rows[0];
    frame.height = rows[1];
    return frame;
}

/// Drops the suffix of an image file; other dots ("cornell.Scene.00001") belong to the name.
std::string without_image_suffix(const std::string& name) {
    constexpr std::array<std::string_view, 6> kSuffixes{".exr", ".png", ".tga",
                                                        ".flm", ".igi", ".hdr"};
    const std::filesystem::path path(name);
    const std::string suffix = path.extension().string();
    const bool image = std::find(kSuffixes.begin(), kSuffixes.end(), suffix) != kSuffixes.end();
    return image ? name.substr(0, name.size() - suffix.size()) : name;
}

/// An error of more than 100 % would end any render at once.
double read_halt_error(const ParameterReader& reader) {
    constexpr std::string_view kName = "haltthreshold";
    const double error = reader.number(kName, -1);
    if (error <= 1) return std::max(0.0, error);
    reader.diagnostics().warning(
        reader.where(kName), fmt::format("\"{}\" is {}, an error of {:.0f} %, and ends nothing: "
                                         "0.05 is 5 %",
                                         kName, error, 100 * error));
    return 0;
}

/// As LuxRender's premultiplyalpha forces alpha into all files, whoever asks for it in one gets it
/// in all: the colours of a pixel are the same in each.
void read_alpha(const ParameterReader& reader, FilmSettings& settings) {
    const bool premultiplied = reader.boolean("premultiplyalpha", false);
    settings.layers.alpha = premultiplied;
    for (const std::string_view name : {"write_exr_channels", "write_png_channels"}) {
        const std::string channels = reader.string(name, "RGB");
        const bool alpha = channels.ends_with('A');
        settings.layers.alpha |= alpha;
        if (channels.starts_with('Y'))
            warn_of_no_effect(reader, name, alpha ? "the file holds RGBA" : "the file holds RGB");
    }
    settings.hides_background =
        settings.layers.alpha &&
        (premultiplied || !reader.boolean("write_exr_straightcolors", false));
}

ToneMapSettings::Kernel read_kernel(const ParameterReader& reader) {
    using Kernel = ToneMapSettings::Kernel;
    constexpr std::string_view kKernel = "tonemapkernel";
    const std::string name = reader.string(kKernel, "autolinear");
    if (name == "linear") return Kernel::Linear;
    if (name == "reinhard") return Kernel::Reinhard;
    if (name == "contrast") return Kernel::Contrast;
    if (name == "maxwhite") return Kernel::MaxWhite;
    if (name == "nonlinear") return Kernel::NonLinear;
    if (name == "falsecolors") {
        reader.diagnostics().warning(
            reader.where(kKernel), fmt::format("{} \"falsecolors\" is not available; autolinear is "
                                               "used",
                                               reader.spelling(kKernel)));
    }
    return Kernel::AutoLinear;
}

ToneMapSettings read_tone_map(const ParameterReader& reader) {
    ToneMapSettings s;
    s.kernel = read_kernel(reader);
    const std::string clamp = reader.string("ldr_clamp_method", "cut");
    using Clamp = ToneMapSettings::Clamp;
    s.clamp = clamp == "lum"      ? Clamp::Luminance
              : clamp == "hue"    ? Clamp::Hue
              : clamp == "darken" ? Clamp::Darken
                                  : Clamp::Cut;
    s.gamma = reader.number("gamma", s.gamma);
    s.linear_sensitivity = reader.number("linear_sensitivity", s.linear_sensitivity);
    s.linear_exposure = reader.number("linear_exposure", s.linear_exposure);
    s.linear_fstop = reader.number("linear_fstop", s.linear_fstop);
    s.linear_gamma = reader.number("linear_gamma", s.linear_gamma);
    s.reinhard_prescale = reader.number("reinhard_prescale", s.reinhard_prescale);
    s.reinhard_postscale = reader.number("reinhard_postscale", s.reinhard_postscale);
    s.reinhard_burn = reader.number("reinhard_burn", s.reinhard_burn);
    s.contrast_ywa = reader.number("contrast_ywa", s.contrast_ywa);
    return s;
}

std::string read_base_name(const ParameterReader& reader) {
    std::string name = without_image_suffix(reader.string("filename", "luxout"));
    if (name.empty())
        reader.fail("filename", fmt::format("{} is empty", reader.spelling("filename")));
    return name;
}

std::optional<ColorConversion> read_color_space(const ParameterReader& reader) {
    ColorSpace space;
    std::string_view last = "colorspace_red";
    const auto read_one = [&](std::string_view name, std::array<double, 2>& value) {
        const auto given = reader.numbers(name);
        if (given.empty()) return;
        if (given.size() != value.size())
            reader.fail(name, fmt::format("{} takes 2 numbers, found {}", name, given.size()));
        std::copy(given.begin(), given.end(), value.begin());
        last = name;
    };
    read_one("colorspace_red", space.red);
    read_one("colorspace_green", space.green);
    read_one("colorspace_blue", space.blue);
    read_one("colorspace_white", space.white);
    if (space == kSceneColors) return std::nullopt;
    try {
        return ColorConversion(kSceneColors, space);
    } catch (const std::invalid_argument& error) {
        reader.fail(last, fmt::format("the film's colour space: {}", error.what()));
    }
}

/// A light group of the name would hide the layer, or the layer it.
LayersWanted read_layers(const ParameterReader& reader, const SceneContents& contents) {
    const std::vector<std::string> names = reader.strings("layers");
    try {
        const LayersWanted wanted = layers_named(names);
        const auto& groups = contents.light_groups;
        for (const std::string& name : FilmLayers::names(wanted)) {
            if (groups.size() > 1 && std::find(groups.begin(), groups.end(), name) != groups.end())
                reader.fail("layers",
                            fmt::format("the layer \"{}\" has the name of a light group", name));
        }
        return wanted;
    } catch (const std::invalid_argument& error) {
        reader.fail("layers", error.what());
    }
}

FilmSettings read(const SceneContents& contents, Diagnostics& diagnostics) {
    const OptionChoice choice =
        choose_option(contents, "Film", "fleximage", {"fleximage", "multiimage"});
    const ParameterSet& set = choice.statement.parameters;
    const std::vector<ParameterDeclaration> declared = film_parameters(set.plugin);
    const ParameterReader reader(set, declared, diagnostics);
    if (set.plugin == "multiimage") {
        diagnostics.warning(set.where, "Film \"multiimage\" is treated as \"fleximage\"");
    }
    FilmSettings settings;
    settings.frame = read_frame(reader);
    settings.base_name = read_base_name(reader);
    settings.halt_time_seconds = std::max(0.0, reader.number("halttime", 0));
    settings.halt_passes =
        static_cast<std::uint64_t>(std::max<std::int64_t>(0, reader.integer("haltspp", 0)));
    settings.halt_error = read_halt_error(reader);
    settings.outlier_neighbours =
        static_cast<std::uint32_t>(reader.integer("outlierrejection_k", 0));
    settings.write_interval_seconds =
        std::max(0.0, reader.number("writeinterval", settings.write_interval_seconds));
    settings.display_interval_seconds =
        std::max(0.0, reader.number("displayinterval", settings.display_interval_seconds));
    settings.tone_map = read_tone_map(reader);
    settings.layers = read_layers(reader, contents);
    read_alpha(reader, settings);
    settings.response_file = reader.string("cameraresponse", "");
    settings.response_where = reader.where("cameraresponse");
    settings.to_film_colors = read_color_space(reader);
    if (settings.to_film_colors)
        settings.tone_map.luminance_weights = settings.to_film_colors->luminance_weights();
    warn_of_ignored_film_parameters(reader);
    return settings;
}

}  // namespace

FilmSettings read_film_settings(const SceneContents& contents, Diagnostics& diagnostics) {
    return read(contents, diagnostics);
}

FilmFrame read_film_frame(const SceneContents& contents) {
    SilentDiagnostics silent;
    return read(contents, silent).frame;
}

}  // namespace lxs
