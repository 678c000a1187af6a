// Texture "lampspectrum": the light of a kind of lamp.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "lamp_spectra.h"
#include "spectral_texture.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

const std::vector<std::string_view>& lamp_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const Lamp& lamp : lamps())
            all.push_back(lamp.name);
        return all;
    }();
    return names;
}

std::shared_ptr<const ColorTexture> create(const ParameterReader& reader, const AssetContext&,
                                           const Matrix&) {
    const std::string name = reader.string("name", "Incandescent2");
    const auto lamp =
        std::find_if(lamps().begin(), lamps().end(), [&](const Lamp& l) { return l.name == name; });
    if (lamp->source == LampSource::StandIn) {
        reader.diagnostics().warning(
            reader.where("name"),
            fmt::format("lampspectrum \"{}\": no measured spectrum is at hand; a black body of {} "
                        "K is used instead ({})",
                        name, lamp->kelvin, lamp->note));
    }
    if (lamp->source == LampSource::RoughLines) {
        reader.diagnostics().warning(
            reader.where("name"),
            fmt::format("lampspectrum \"{}\": the strengths of its lines are rough figures, not "
                        "measured ones ({})",
                        name, lamp->note));
    }
    return std::make_shared<SpectralTexture>(lamp_spectrum(*lamp),
                                             fmt::format("lampspectrum \"{}\"", name));
}

}  // namespace

ColorTextureFactory lampspectrum_plugin() {
    return {{choice("name", "Incandescent2",
                    "kind of lamp; black bodies, spectral lines, or with a warning a stand-in by "
                    "colour temperature; the spectrum's largest value is 1",
                    lamp_names())},
            &create};
}

}  // namespace lxs::shading
