// Car paints by LuxRender's names: what Guenther, Chen, Goesele, Wald & Seidel 2005, "Efficient
// Acquisition and Realistic Rendering of Car Paint", fitted to eight measured paints, in the
// figures that LuxRender has of it. They belong to this model's facets as LuxRender's do, not to
// Cook & Torrance's, which they were fitted with.
#include "car_paint_presets.h"

#include <fmt/format.h>

#include <string>

#include "unknown_preset.h"

namespace lxs::shading {
namespace {

struct Preset {
    std::string_view name;
    CarPaint paint;
};

const std::array<Preset, 8>& presets() {
    // Kd; then Ks, R and M of each lobe.
    const Rgb none(0.0f);
    static const std::array<Preset, 8> all{{{"ford f8",
                                             {{0.0012f, 0.0015f, 0.0018f},
                                              none,
                                              {{{{0.0049f, 0.0076f, 0.0120f}, 0.15f, 0.32f},
                                                {{0.0100f, 0.0130f, 0.0180f}, 0.087f, 0.11f},
                                                {{0.0070f, 0.0065f, 0.0077f}, 0.9f, 0.013f}}}}},
                                            {"polaris silber",
                                             {{0.0550f, 0.0630f, 0.0710f},
                                              none,
                                              {{{{0.0650f, 0.0820f, 0.0880f}, 1.0f, 0.38f},
                                                {{0.1100f, 0.1100f, 0.1300f}, 0.92f, 0.17f},
                                                {{0.0080f, 0.0130f, 0.0150f}, 0.9f, 0.013f}}}}},
                                            {"opel titan",
                                             {{0.0110f, 0.0130f, 0.0150f},
                                              none,
                                              {{{{0.0570f, 0.0660f, 0.0780f}, 0.85f, 0.38f},
                                                {{0.1100f, 0.1200f, 0.1300f}, 0.86f, 0.17f},
                                                {{0.0095f, 0.0140f, 0.0160f}, 0.9f, 0.014f}}}}},
                                            {"bmw339",
                                             {{0.0120f, 0.0150f, 0.0160f},
                                              none,
                                              {{{{0.0620f, 0.0760f, 0.0800f}, 0.92f, 0.39f},
                                                {{0.1100f, 0.1200f, 0.1200f}, 0.87f, 0.17f},
                                                {{0.0083f, 0.0150f, 0.0160f}, 0.9f, 0.013f}}}}},
                                            {"2k acrylack",
                                             {{0.4200f, 0.3200f, 0.1000f},
                                              none,
                                              {{{none, 1.0f, 0.88f},
                                                {{0.0280f, 0.0260f, 0.0060f}, 0.9f, 0.8f},
                                                {{0.0170f, 0.0075f, 0.0041f}, 0.17f, 0.015f}}}}},
                                            {"white",
                                             {{0.6100f, 0.6300f, 0.5500f},
                                              none,
                                              {{{{2.6e-6f, 3.1e-4f, 3.1e-8f}, 0.049f, 1.0f},
                                                {{0.0130f, 0.0110f, 0.0083f}, 0.45f, 0.15f},
                                                {{0.0490f, 0.0420f, 0.0370f}, 0.17f, 0.015f}}}}},
                                            {"blue",
                                             {{0.0079f, 0.0230f, 0.1000f},
                                              none,
                                              {{{{0.0011f, 0.0015f, 0.0019f}, 1.0f, 0.15f},
                                                {{0.0250f, 0.0300f, 0.0430f}, 0.094f, 0.043f},
                                                {{0.0590f, 0.0740f, 0.0820f}, 0.17f, 0.02f}}}}},
                                            {"blue matte",
                                             {{0.0099f, 0.0360f, 0.1200f},
                                              none,
                                              {{{{0.0032f, 0.0045f, 0.0059f}, 1.0f, 0.16f},
                                                {{0.1800f, 0.2300f, 0.2800f}, 0.046f, 0.075f},
                                                {{0.0400f, 0.0490f, 0.0510f}, 0.17f, 0.034f}}}}}}};
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
    return &preset->paint;
}

}  // namespace lxs::shading
