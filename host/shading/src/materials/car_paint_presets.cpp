// Car paints by LuxRender's names. The parameters that Guenther et al. 2005 fitted to eight
// measured paints (their table 1) could not be had under a known licence, so none of these is that
// table:
// - "ford f8" is a fit of ours of the same model to LuxRender's image of lux-conformance's
//   material-carpaint: non-negative least squares over the sphere of images of single lobes.
// - The others are guesses at a paint of that name and colour.
// A warning says so.
#include "car_paint_presets.h"

#include <fmt/format.h>

#include <string>

#include "unknown_preset.h"

namespace lxs::shading {
namespace {

struct Preset {
    std::string_view name;
    CarPaint paint;
    std::string_view stand_in = "a guess at its colour and gloss";
};

/// A coloured base, a wide and a narrower lobe of metal flakes and the clear coat's peak.
CarPaint metallic(const Rgb& kd, const Rgb& flakes, float coat) {
    return {
        kd, Rgb(0.0f), {{{flakes, 0.5f, 0.4f}, {flakes, 0.5f, 0.2f}, {Rgb(coat), 0.5f, 0.015f}}}};
}

/// A coloured base under a clear coat of index 1.5.
CarPaint solid(const Rgb& kd, float slope) {
    return {kd, Rgb(0.0f), {{{Rgb(0.0f)}, {Rgb(0.0f)}, {Rgb(1.0f), 0.04f, slope}}}};
}

/// See the file's first lines. With this the median block of that image differs by 0.8 %.
const CarPaint kFordF8{{0.00134f, 0.00179f, 0.00225f},
                       Rgb(0.0f),
                       {{{{0.00067f, 0.00100f, 0.00148f}, 1.0f, 0.35f},
                         {{0.01228f, 0.01277f, 0.01641f}, 0.195f, 0.06f},
                         {{0.00422f, 0.00353f, 0.00383f}, 1.0f, 0.02f}}}};

const std::array<Preset, 8>& presets() {
    static const std::array<Preset, 8> all{
        {{"ford f8", kFordF8, "a fit to LuxRender's picture of it"},
         {"polaris silber", metallic(Rgb(0.06f), Rgb(0.2f), 0.06f)},
         {"opel titan", metallic(Rgb(0.02f), Rgb(0.08f), 0.06f)},
         {"bmw339", metallic(Rgb(0.02f, 0.025f, 0.03f), Rgb(0.1f), 0.06f)},
         {"2k acrylack", solid(Rgb(0.4f, 0.03f, 0.02f), 0.015f)},
         {"white", solid(Rgb(0.7f), 0.015f)},
         {"blue", solid(Rgb(0.02f, 0.05f, 0.3f), 0.015f)},
         {"blue matte", solid(Rgb(0.02f, 0.05f, 0.3f), 0.3f)}}};
    return all;
}

const Preset* find_preset(std::string_view name) {
    for (const Preset& preset : presets()) {
        if (preset.name == name) return &preset;
    }
    return nullptr;
}

}  // namespace

const CarPaint& car_paint_preset(std::string_view name) {
    return find_preset(name)->paint;
}

const CarPaint* read_car_paint_preset(const ParameterReader& reader) {
    const std::string name = reader.string("name", "");
    if (name.empty() || name == "-") return nullptr;
    const Preset* preset = find_preset(name);
    if (!preset) {
        warn_of_unknown_preset(reader, "name", "car paint", presets(), kDefaultCarPaint);
        return &car_paint_preset(kDefaultCarPaint);
    }
    reader.diagnostics().warning(
        reader.where("name"),
        fmt::format("the measured parameters of car paint \"{}\" are not available; {} is used "
                    "instead",
                    name, preset->stand_in));
    return &preset->paint;
}

}  // namespace lxs::shading
