// Colours given as sampled spectra: "regulardata", "irregulardata" and "tabulateddata".
#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <string>

#include "spectral_texture.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

ParameterDeclaration numbers(std::string_view name, std::string_view doc) {
    ParameterDeclaration declaration{name, ParameterType::Float, "", doc};
    declaration.array = true;
    return declaration;
}

/// The texture of samples, which parameter `name` gave. Needs rising wavelengths; values below 0
/// become 0 with a warning.
std::shared_ptr<const ColorTexture> sampled_texture(const ParameterReader& reader,
                                                    std::string_view name, std::vector<double> nm,
                                                    std::vector<double> values) {
    const auto not_rising = [](double a, double b) { return !(a < b); };
    if (std::adjacent_find(nm.begin(), nm.end(), not_rising) != nm.end())
        reader.fail(name, reader.plugin() + ": wavelengths must rise");
    const auto negative = [](double value) { return !(value >= 0); };
    if (std::any_of(values.begin(), values.end(), negative)) {
        reader.diagnostics().warning(reader.where(name),
                                     reader.plugin() + ": negative values are taken as 0");
        std::replace_if(values.begin(), values.end(), negative, 0.0);
    }
    return std::make_shared<SpectralTexture>(sampled_spectrum(std::move(nm), std::move(values)),
                                             reader.plugin());
}

std::shared_ptr<const ColorTexture> create_regular(const ParameterReader& reader,
                                                   const AssetContext&, const Matrix&) {
    const auto data = reader.numbers("data");
    if (data.size() < 2) reader.fail("data", "regulardata: \"data\" needs at least 2 values");
    const double start = reader.number("start", 380), end = reader.number("end", 720);
    std::vector<double> nm(data.size());
    for (std::size_t i = 0; i < nm.size(); ++i)
        nm[i] = start + (end - start) * static_cast<double>(i) / static_cast<double>(nm.size() - 1);
    return sampled_texture(reader, "end", std::move(nm), {data.begin(), data.end()});
}

std::shared_ptr<const ColorTexture> create_irregular(const ParameterReader& reader,
                                                     const AssetContext&, const Matrix&) {
    const auto nm = reader.numbers("wavelengths"), data = reader.numbers("data");
    if (data.size() < 2 || nm.size() != data.size()) {
        reader.fail("data",
                    "irregulardata: \"wavelengths\" and \"data\" need the same number of "
                    "values, at least 2");
    }
    return sampled_texture(reader, "wavelengths", {nm.begin(), nm.end()},
                           {data.begin(), data.end()});
}

/// Two numbers a line, a wavelength and a value; empty lines and what follows a # are left out.
std::shared_ptr<const ColorTexture> create_tabulated(const ParameterReader& reader,
                                                     const AssetContext& assets, const Matrix&) {
    if (!reader.given("filename"))
        reader.fail("filename", "tabulateddata: \"filename\" is missing");
    const std::string path =
        assets.resolve(reader.string("filename", ""), reader.where("filename"));
    std::ifstream file(path);
    std::vector<double> nm, values;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        std::istringstream columns(line.substr(0, line.find('#')));
        columns.imbue(std::locale::classic());
        double wavelength = 0, value = 0;
        if (!(columns >> std::ws) || columns.eof()) continue;
        if (!(columns >> wavelength >> value)) {
            reader.fail("filename", "tabulateddata: line " + std::to_string(number) + " of \"" +
                                        path + "\" is not a wavelength and a value");
        }
        nm.push_back(wavelength);
        values.push_back(value);
    }
    if (nm.size() < 2) {
        reader.fail("filename", "tabulateddata: \"" + path +
                                    "\" cannot be read or has fewer than 2 lines of data");
    }
    return sampled_texture(reader, "filename", std::move(nm), std::move(values));
}

}  // namespace

void register_sampled_spectra(Registry& registry) {
    registry.color_textures["regulardata"] = {
        {{"start", ParameterType::Float, "380", "wavelength of the first value, nanometres"},
         {"end", ParameterType::Float, "720", "wavelength of the last value, nanometres"},
         numbers("data", "values at equal steps, linear in between, 0 outside")},
        &create_regular};
    registry.color_textures["irregulardata"] = {
        {numbers("wavelengths", "rising wavelengths in nanometres"),
         numbers("data", "value at each wavelength, linear in between, 0 outside")},
        &create_irregular};
    registry.color_textures["tabulateddata"] = {
        {{"filename", ParameterType::String, "",
          "text file with a wavelength in nanometres and a value in each line"}},
        &create_tabulated};
}

}  // namespace lxs::shading
