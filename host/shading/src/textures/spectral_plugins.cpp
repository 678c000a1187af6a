// Colours given as spectra by formula: "blackbody", "equalenergy", "gaussian" and "frequency".
#include <cmath>

#include "spectral_texture.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

ParameterDeclaration energy_parameter() {
    return {"energy", ParameterType::Float, "1", "largest value of the spectrum", 0};
}

ColorTextureFactory blackbody_plugin() {
    return {{{"temperature", ParameterType::Float, "6500",
              "temperature in kelvin; the largest value of the visible spectrum is 1", 1}},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                return std::make_shared<SpectralTexture>(
                    blackbody_spectrum(reader.number("temperature", 6500)), reader.plugin());
            }};
}

ColorTextureFactory equalenergy_plugin() {
    return {{energy_parameter()},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                const double energy = reader.number("energy", 1);
                return std::make_shared<SpectralTexture>([energy](double) { return energy; },
                                                         reader.plugin());
            }};
}

ColorTextureFactory gaussian_plugin() {
    return {{energy_parameter(),
             {"wavelength", ParameterType::Float, "550", "centre in nanometres"},
             {"width", ParameterType::Float, "50", "standard deviation in nanometres", 1e-3}},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                const double energy = reader.number("energy", 1);
                const double centre = reader.number("wavelength", 550);
                const double width = reader.number("width", 50);
                const auto bell = [=](double nm) {
                    const double t = (nm - centre) / width;
                    return energy * std::exp(-0.5 * t * t);
                };
                return std::make_shared<SpectralTexture>(bell, reader.plugin());
            }};
}

ColorTextureFactory frequency_plugin() {
    return {{energy_parameter(),
             {"freq", ParameterType::Float, "0.01", "radians per nanometre"},
             {"phase", ParameterType::Float, "0.5", "radians at wavelength 0"}},
            [](const ParameterReader& reader, const AssetContext&, const Matrix&) {
                const double energy = reader.number("energy", 1);
                const double frequency = reader.number("freq", 0.01);
                const double phase = reader.number("phase", 0.5);
                const auto wave = [=](double nm) {
                    return energy * 0.5 * (1 + std::sin(nm * frequency + phase));
                };
                return std::make_shared<SpectralTexture>(wave, reader.plugin());
            }};
}

}  // namespace

void register_spectral_textures(Registry& registry) {
    registry.color_textures["blackbody"] = blackbody_plugin();
    registry.color_textures["equalenergy"] = equalenergy_plugin();
    registry.color_textures["gaussian"] = gaussian_plugin();
    registry.color_textures["frequency"] = frequency_plugin();
}

}  // namespace lxs::shading
