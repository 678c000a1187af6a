// Measured optical constants of metals. Sources, as collected by refractiveindex.info (CC0):
// silver, gold, copper: Johnson & Christy 1972, Phys. Rev. B 6, 4370-4379;
// aluminium: Rakic 1995, Appl. Opt. 34, 4755-4767;
// amorphous carbon: Arakawa, Williams & Inagaki 1977, J. Appl. Phys. 48, 3176-3177.
#include "metal_presets.h"

#include <fmt/format.h>

#include <span>
#include <string>

#include "optical_table.h"
#include "unknown_preset.h"

namespace lxs::shading {
namespace {

struct Measurement {
    float wavelength;  ///< nanometres
    float n, k;
};

constexpr std::array kSilver{
    Measurement{430.5f, 0.04f, 2.462f}, Measurement{450.9f, 0.04f, 2.657f},
    Measurement{520.9f, 0.05f, 3.324f}, Measurement{548.6f, 0.06f, 3.586f},
    Measurement{616.8f, 0.06f, 4.152f}, Measurement{659.5f, 0.05f, 4.483f}};
constexpr std::array kGold{Measurement{430.5f, 1.45f, 1.948f}, Measurement{450.9f, 1.38f, 1.914f},
                           Measurement{520.9f, 0.62f, 2.081f}, Measurement{548.6f, 0.43f, 2.455f},
                           Measurement{616.8f, 0.21f, 3.272f}, Measurement{659.5f, 0.14f, 3.697f}};
constexpr std::array kCopper{
    Measurement{430.5f, 1.25f, 2.305f}, Measurement{450.9f, 1.24f, 2.397f},
    Measurement{520.9f, 1.18f, 2.608f}, Measurement{548.6f, 1.02f, 2.577f},
    Measurement{616.8f, 0.30f, 3.205f}, Measurement{659.5f, 0.22f, 3.747f}};
constexpr std::array kAluminium{
    Measurement{442.80f, 0.60790f, 5.3676f}, Measurement{476.87f, 0.72780f, 5.7781f},
    Measurement{516.60f, 0.87340f, 6.2418f}, Measurement{563.57f, 1.0728f, 6.7839f},
    Measurement{619.93f, 1.3660f, 7.4052f},  Measurement{652.25f, 1.5724f, 7.7354f}};
constexpr std::array kAmorphousCarbon{
    Measurement{442.8f, 2.17f, 0.89f}, Measurement{476.9f, 2.24f, 0.88f},
    Measurement{516.6f, 2.30f, 0.87f}, Measurement{563.6f, 2.38f, 0.82f},
    Measurement{619.9f, 2.43f, 0.75f}, Measurement{688.8f, 2.43f, 0.70f}};

struct Preset {
    std::string_view name;
    std::span<const Measurement> measurements;  ///< by ascending wavelength
};

constexpr std::string_view kDefaultMetal = "aluminium";
constexpr std::array<Preset, 5> kPresets{{{"amorphous carbon", kAmorphousCarbon},
                                          {"silver", kSilver},
                                          {"gold", kGold},
                                          {"copper", kCopper},
                                          {kDefaultMetal, kAluminium}}};

FresnelValue preset_constants(const Preset& preset) {
    OpticalTable table;
    for (const Measurement& m : preset.measurements)
        table.push_back({m.wavelength, m.n, m.k});
    return rgb_constants(table);
}

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
            return rgb_constants(read_optical_table(path, OpticalFormat::Any, where));
        } catch (const InputError& error) {
            reader.diagnostics().fallback(error.where(), error.message(),
                                          fmt::format("\"{}\" is used", kDefaultMetal));
            return preset_constants(*find_preset(kDefaultMetal));
        }
    }
    const Preset* preset = find_preset(name);
    if (!preset) warn_of_unknown_preset(reader, "name", "metal", kPresets, kDefaultMetal);
    return preset_constants(preset ? *preset : *find_preset(kDefaultMetal));
}

}  // namespace lxs::shading
