// Measured optical constants of metals, as LuxRender has them. Sources: the nk database of SOPRA
// S.A. (silver, gold, copper, aluminium); Arakawa, Williams & Inagaki 1977, J. Appl. Phys. 48,
// 3176-3177 (amorphous carbon).
#include "metal_presets.h"

#include <fmt/format.h>

#include <string>

#include "metal_colour.h"
#include "unknown_preset.h"

namespace lxs::shading {
namespace {

constexpr std::size_t kSamples = 34;
using Curve = std::array<float, kSamples>;

// Evenly spaced in photon energy, as Sopra tabulates; nanometres.
constexpr Curve kWavelengths{370.1f, 375.7f, 381.5f, 387.5f, 393.6f, 399.9f, 406.5f, 413.3f, 420.3f,
                             427.5f, 435.0f, 442.8f, 450.9f, 459.2f, 467.9f, 476.9f, 486.2f, 495.9f,
                             506.1f, 516.6f, 527.6f, 539.1f, 551.0f, 563.6f, 576.7f, 590.4f, 604.8f,
                             619.9f, 635.8f, 652.5f, 670.2f, 688.8f, 708.5f, 729.3f};

constexpr Curve kSilverN{0.1921f, 0.2f,    0.1981f, 0.192f,  0.182f,  0.173f,  0.1726f,
                         0.173f,  0.1667f, 0.16f,   0.1585f, 0.157f,  0.1511f, 0.144f,
                         0.1373f, 0.132f,  0.1303f, 0.13f,   0.1299f, 0.13f,   0.1301f,
                         0.129f,  0.1244f, 0.12f,   0.1193f, 0.121f,  0.1255f, 0.131f,
                         0.1361f, 0.14f,   0.1401f, 0.14f,   0.1443f, 0.148f};
constexpr Curve kSilverK{
    1.6419f, 1.67f, 1.735f,  1.81f, 1.8787f, 1.95f, 2.0294f, 2.11f, 2.1862f, 2.26f, 2.3294f, 2.4f,
    2.4787f, 2.56f, 2.64f,   2.72f, 2.7981f, 2.88f, 2.9737f, 3.07f, 3.1594f, 3.25f, 3.3481f, 3.45f,
    3.5537f, 3.66f, 3.7662f, 3.88f, 4.0106f, 4.15f, 4.2931f, 4.44f, 4.5862f, 4.74f};
constexpr Curve kGoldN{1.7059f, 1.696f,  1.6847f, 1.674f,  1.666f,  1.658f,  1.6473f,
                       1.636f,  1.628f,  1.616f,  1.5962f, 1.562f,  1.5021f, 1.426f,
                       1.3459f, 1.242f,  1.0868f, 0.916f,  0.7545f, 0.608f,  0.4918f,
                       0.402f,  0.3455f, 0.306f,  0.2676f, 0.236f,  0.2124f, 0.194f,
                       0.1777f, 0.166f,  0.161f,  0.16f,   0.1609f, 0.164f};
constexpr Curve kGoldK{1.883f,  1.906f,  1.9225f, 1.936f,  1.9478f, 1.956f,  1.9594f,
                       1.958f,  1.9514f, 1.94f,   1.9245f, 1.904f,  1.8759f, 1.846f,
                       1.8146f, 1.796f,  1.7974f, 1.84f,   1.9565f, 2.12f,   2.3262f,
                       2.54f,   2.7306f, 2.88f,   2.9406f, 2.97f,   3.015f,  3.06f,
                       3.07f,   3.15f,   3.4458f, 3.8f,    4.0877f, 4.357f};
constexpr Curve kCopperN{1.2491f, 1.225f,  1.2f,    1.18f,   1.1744f, 1.175f,  1.1775f,
                         1.18f,   1.1781f, 1.175f,  1.1728f, 1.17f,   1.1653f, 1.16f,
                         1.1553f, 1.15f,   1.1428f, 1.135f,  1.1316f, 1.12f,   1.0924f,
                         1.04f,   0.9504f, 0.826f,  0.6459f, 0.468f,  0.3513f, 0.272f,
                         0.2308f, 0.214f,  0.2092f, 0.213f,  0.2162f, 0.223f};
constexpr Curve kCopperK{1.9724f, 2.015f,  2.1216f, 2.21f,   2.1772f, 2.13f,   2.1601f,
                         2.21f,   2.2499f, 2.289f,  2.326f,  2.362f,  2.3976f, 2.433f,
                         2.4692f, 2.504f,  2.5359f, 2.564f,  2.5896f, 2.605f,  2.5956f,
                         2.583f,  2.5765f, 2.599f,  2.6781f, 2.809f,  3.0107f, 3.24f,
                         3.4582f, 3.67f,   3.8631f, 4.05f,   4.2396f, 4.43f};
constexpr Curve kAluminiumN{0.4191f, 0.432f,  0.4457f, 0.46f,   0.4747f, 0.49f,   0.5062f,
                            0.523f,  0.5401f, 0.558f,  0.5773f, 0.598f,  0.6203f, 0.644f,
                            0.6686f, 0.695f,  0.7238f, 0.755f,  0.789f,  0.826f,  0.867f,
                            0.912f,  0.963f,  1.02f,   1.08f,   1.15f,   1.22f,   1.3f,
                            1.39f,   1.49f,   1.6f,    1.74f,   1.91f,   2.14f};
constexpr Curve kAluminiumK{
    4.4938f, 4.56f, 4.6338f, 4.71f, 4.7844f, 4.86f, 4.9381f, 5.02f, 5.1087f, 5.2f,  5.29f, 5.38f,
    5.48f,   5.58f, 5.69f,   5.8f,  5.915f,  6.03f, 6.15f,   6.28f, 6.42f,   6.55f, 6.7f,  6.85f,
    7.0f,    7.15f, 7.31f,   7.48f, 7.65f,   7.82f, 8.01f,   8.21f, 8.39f,   8.57f};

struct Measurement {
    float wavelength;  ///< nanometres
    float n, k;
};
constexpr std::array kAmorphousCarbon{
    Measurement{364.647f, 2.0f, 0.92f},  Measurement{387.438f, 2.06f, 0.91f},
    Measurement{413.267f, 2.11f, 0.9f},  Measurement{442.786f, 2.17f, 0.89f},
    Measurement{476.846f, 2.24f, 0.88f}, Measurement{516.583f, 2.3f, 0.87f},
    Measurement{563.545f, 2.38f, 0.82f}, Measurement{619.9f, 2.43f, 0.75f},
    Measurement{688.778f, 2.43f, 0.7f},  Measurement{774.875f, 2.33f, 0.71f}};

struct Preset {
    std::string_view name;
    OpticalTable (*table)();
};

OpticalTable sopra_table(const Curve& n, const Curve& k) {
    OpticalTable table;
    for (std::size_t i = 0; i < kSamples; ++i)
        table.push_back({kWavelengths[i], n[i], k[i]});
    return table;
}

OpticalTable carbon_table() {
    OpticalTable table;
    for (const Measurement& m : kAmorphousCarbon)
        table.push_back({m.wavelength, m.n, m.k});
    return table;
}

constexpr std::string_view kDefaultMetal = "aluminium";
constexpr std::array<Preset, 5> kPresets{
    {{"amorphous carbon", &carbon_table},
     {"silver", [] { return sopra_table(kSilverN, kSilverK); }},
     {"gold", [] { return sopra_table(kGoldN, kGoldK); }},
     {"copper", [] { return sopra_table(kCopperN, kCopperK); }},
     {kDefaultMetal, [] { return sopra_table(kAluminiumN, kAluminiumK); }}}};

const Preset* find_preset(std::string_view name) {
    for (const Preset& preset : kPresets) {
        if (preset.name == name) return &preset;
    }
    return nullptr;
}

}  // namespace

std::vector<ParameterDeclaration> metal_preset_parameters() {
    return {{"name", ParameterType::String, kDefaultMetal,
             "amorphous carbon, silver, gold, copper or aluminium"},
            {"filename", ParameterType::String, "",
             "file of measured n and k (Sopra, LuxPop or columns); overrides the name"}};
}

FresnelValue read_metal_preset(const ParameterReader& reader, const AssetContext& assets) {
    const std::string name = reader.string("name", kDefaultMetal);
    if (reader.given("filename") && reader.given("name")) {
        reader.diagnostics().warning(reader.where("name"),
                                     "\"name\" has no effect beside \"filename\"");
    }
    // LuxRender takes a name that it doesn't know for a file.
    const bool name_is_file = name.find('.') != std::string::npos;
    if (reader.given("filename") || name_is_file) {
        const std::string_view parameter = reader.given("filename") ? "filename" : "name";
        const SourceLocation& where = reader.where(parameter);
        try {
            const std::string path = assets.resolve(reader.string(parameter, ""), where);
            return constants_of_colour(read_optical_table(path, OpticalFormat::Any, where));
        } catch (const InputError& error) {
            reader.diagnostics().fallback(error.where(), error.message(),
                                          fmt::format("\"{}\" is used", kDefaultMetal));
            return constants_of_colour(find_preset(kDefaultMetal)->table());
        }
    }
    const Preset* preset = find_preset(name);
    if (!preset) warn_of_unknown_preset(reader, "name", "metal", kPresets, kDefaultMetal);
    return constants_of_colour((preset ? preset : find_preset(kDefaultMetal))->table());
}

}  // namespace lxs::shading
