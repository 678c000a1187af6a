// Colours of parameters.
#include "spectra.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lxs/language/statement_executor.h"
#include "lxs/spectrum/colour_matching.h"
#include "lxs/spectrum/daylight.h"
#include "lxs/spectrum/spectrum.h"

namespace lxs::pbrt {
namespace {

struct NamedGlass {
    std::string_view name;
    Glass glass;
};
// Index n_d and number of Abbe of the makers' tables (Schott). pbrt's F5, F10 and F11 are the heavy
// flints SF5, SF10 and SF11.
constexpr std::array<NamedGlass, 7> kGlasses{{{"glass-BK7", {1.5168, 64.17}},
                                              {"glass-BAF10", {1.67003, 47.11}},
                                              {"glass-FK51A", {1.48656, 84.47}},
                                              {"glass-LASF9", {1.85025, 32.17}},
                                              {"glass-F5", {1.67271, 32.25}},
                                              {"glass-F10", {1.72828, 28.53}},
                                              {"glass-F11", {1.78472, 25.76}}}};

struct NamedMetal {
    std::string_view symbol, preset;
};
constexpr std::array<NamedMetal, 4> kMetals{
    {{"Ag", "silver"}, {"Al", "aluminium"}, {"Au", "gold"}, {"Cu", "copper"}}};

/// Constants for R, G and B, where colours are asked for: at the wavelengths of our metals; brass
/// after Querry 1985 (CuZn), periclase after Stephens & Malitson 1952, rutile along its axis after
/// DeVore 1951, both transparent.
struct NamedConstants {
    std::string_view name;
    std::array<float, 3> rgb;
};
constexpr std::array<NamedConstants, 14> kConstants{{{"metal-Ag-eta", {0.155f, 0.117f, 0.138f}},
                                                     {"metal-Ag-k", {4.828f, 3.122f, 2.147f}},
                                                     {"metal-Al-eta", {1.658f, 0.880f, 0.521f}},
                                                     {"metal-Al-k", {9.224f, 6.270f, 4.837f}},
                                                     {"metal-Au-eta", {0.143f, 0.375f, 1.442f}},
                                                     {"metal-Au-k", {3.983f, 2.386f, 1.603f}},
                                                     {"metal-Cu-eta", {0.200f, 0.924f, 1.102f}},
                                                     {"metal-Cu-k", {3.913f, 2.453f, 2.142f}},
                                                     {"metal-CuZn-eta", {0.444f, 0.527f, 1.094f}},
                                                     {"metal-CuZn-k", {3.695f, 2.765f, 1.829f}},
                                                     {"metal-MgO-eta", {1.734f, 1.742f, 1.752f}},
                                                     {"metal-MgO-k", {0.0f, 0.0f, 0.0f}},
                                                     {"metal-TiO2-eta", {2.860f, 2.978f, 3.163f}},
                                                     {"metal-TiO2-k", {0.0f, 0.0f, 0.0f}}}};

/// Illuminants by the temperature of a black body of their colour, but those of daylight, whose
/// colour is 1 1 1 in the primaries' white.
struct NamedLamp {
    std::string_view name;
    double kelvin;  ///< 0: white
};
constexpr std::array<NamedLamp, 16> kLamps{{{"stdillum-A", 2856},
                                            {"stdillum-D50", 5003},
                                            {"stdillum-D65", 0},
                                            {"illum-acesD60", 5998},
                                            {"stdillum-F1", 6430},
                                            {"stdillum-F2", 4230},
                                            {"stdillum-F3", 3450},
                                            {"stdillum-F4", 2940},
                                            {"stdillum-F5", 6350},
                                            {"stdillum-F6", 4150},
                                            {"stdillum-F7", 6500},
                                            {"stdillum-F8", 5000},
                                            {"stdillum-F9", 4150},
                                            {"stdillum-F10", 5000},
                                            {"stdillum-F11", 4000},
                                            {"stdillum-F12", 3000}}};

/// `colour` with luminance 1, black if it has none.
Rgb of_luminance_one(const Rgb& colour) {
    const float y = luminance(colour);
    return y > 0 ? colour / y : Rgb(0.0f);
}

Rgb colour_of(const Spectrum& spectrum, ColourOf of) {
    return of == ColourOf::Light ? of_luminance_one(colour_of_light(spectrum))
                                 : colour_of_surface(spectrum);
}

Rgb of_black_body(double kelvin) {
    return of_luminance_one(colour_of_light(blackbody_spectrum(kelvin)));
}

/// The last component of a path without ".eta.spd" or ".k.spd", as pbrt-v3's files have it.
std::string_view file_symbol(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    std::string_view stem = slash == std::string_view::npos ? path : path.substr(slash + 1);
    return stem.ends_with(".eta.spd") || stem.ends_with(".k.spd") ? stem.substr(0, stem.find('.'))
                                                                  : std::string_view();
}

const ParameterValue& checked(const ParameterValue& value, const Numbers& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (std::isfinite(numbers[i]) && std::abs(numbers[i]) <= 1e30) continue;
        throw InputError(
            i < value.value_where.size() ? value.value_where[i] : value.where,
            fmt::format("parameter {} takes finite numbers, at most 1e30", in_quotes(value.name)));
    }
    return value;
}

/// Pairs of a wavelength and a value, sorted by wavelength.
Spectrum spectrum_of_pairs(const Numbers& pairs, const SourceLocation& where) {
    std::vector<std::array<double, 2>> points;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
        points.push_back({pairs[i], std::max(pairs[i + 1], 0.0)});
    if (points.empty())
        throw InputError(where, "a spectrum takes pairs of a wavelength and a value");
    std::sort(points.begin(), points.end());
    std::vector<double> nm, values;
    for (const auto& [at, value] : points) {
        if (!nm.empty() && nm.back() == at) continue;
        nm.push_back(at);
        values.push_back(value);
    }
    // What lies beyond the pairs is as the last of them, as in pbrt.
    constexpr double kLeast = 300, kMost = 900;
    if (nm.front() > kLeast) {
        nm.insert(nm.begin(), kLeast);
        values.insert(values.begin(), values.front());
    }
    if (nm.back() < kMost) {
        nm.push_back(kMost);
        values.push_back(values.back());
    }
    return sampled_spectrum(std::move(nm), std::move(values));
}

/// The numbers of a text file with comments after '#'. Throws InputError.
Numbers numbers_in_file(const std::string& path, const SourceLocation& where) {
    constexpr std::size_t kMostNumbers = 2'000'000;
    std::ifstream file(path);
    Numbers numbers;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        for (double number; words >> number && numbers.size() < kMostNumbers;)
            numbers.push_back(number);
    }
    if (numbers.size() < 2 || numbers.size() % 2 != 0)
        throw InputError(where,
                         fmt::format("{} holds no spectrum: pairs of a wavelength and a value",
                                     in_quotes(path)));
    return numbers;
}

}  // namespace

double Glass::cauchy_b() const {
    constexpr double kF = 0.48613, kC = 0.65627;  // Fraunhofer's lines, micrometres
    return abbe > 0 ? (index - 1) / abbe / (1 / (kF * kF) - 1 / (kC * kC)) : 0;
}

double Glass::cauchy_a() const {
    constexpr double kD = 0.58756;
    return index - cauchy_b() / (kD * kD);
}

std::optional<Glass> glass_by_name(std::string_view spectrum) {
    for (const NamedGlass& known : kGlasses)
        if (known.name == spectrum) return known.glass;
    return std::nullopt;
}

std::optional<std::string> metal_preset(std::string_view spectrum) {
    for (const NamedMetal& known : kMetals) {
        if (spectrum == fmt::format("metal-{}-eta", known.symbol) ||
            spectrum == fmt::format("metal-{}-k", known.symbol) ||
            file_symbol(spectrum) == known.symbol)
            return std::string(known.preset);
    }
    return std::nullopt;
}

bool SpectrumReader::is_rgb(const Parameters& parameters, std::string_view name) {
    const ParameterValue* const value = parameters.value(name);
    return value != nullptr &&
           (value->type == "rgb" || value->type == "color" || value->type == "xyz");
}

Rgb SpectrumReader::colour(const Parameters& parameters, std::string_view name, ColourOf of,
                           const Rgb& fallback) const {
    const ParameterValue* const value = parameters.value(name);
    if (value == nullptr) return fallback;
    const std::string& type = value->type;
    const auto* numbers = std::get_if<Numbers>(&value->values);
    if (numbers != nullptr) checked(*value, *numbers);
    const bool rgb = type == "rgb" || type == "color";
    if (numbers != nullptr && !numbers->empty() && (rgb || type == "xyz" || type == "float")) {
        if (type == "float" || (numbers->size() == 1 && rgb))
            return Rgb(static_cast<float>(numbers->front()));
        if (numbers->size() < 3)
            parameters.fail(name,
                            fmt::format("a colour takes three numbers, found {}", numbers->size()));
        if (type == "xyz") return clipped_rgb_of_xyz({(*numbers)[0], (*numbers)[1], (*numbers)[2]});
        const Rgb given(static_cast<float>((*numbers)[0]), static_cast<float>((*numbers)[1]),
                        static_cast<float>((*numbers)[2]));
        if (std::min({given.x, given.y, given.z}) < 0)
            parameters.fail(name, "a colour's numbers must not be negative");
        return of == ColourOf::Light ? light_in(parameters.space(), given)
                                     : surface_in(parameters.space(), given);
    }
    if (numbers != nullptr && !numbers->empty() && type == "blackbody") {
        // Version 3 gives a temperature and a factor.
        const double kelvin = numbers->front();
        if (!(kelvin >= 100 && kelvin <= 1e6))
            parameters.fail(name, "a black body takes a temperature of 100 to 1e6 K");
        const auto factor = static_cast<float>(numbers->size() > 1 ? (*numbers)[1] : 1.0);
        return of_black_body(kelvin) * std::max(factor, 0.0f);
    }
    if (type == "spectrum") return spectrum_colour(parameters, *value, of);
    throw InputError(value->where, fmt::format("parameter {} takes a colour: rgb, blackbody or "
                                               "spectrum, found type {}",
                                               in_quotes(name), in_quotes(type)));
}

Rgb SpectrumReader::spectrum_colour(const Parameters& parameters, const ParameterValue& value,
                                    ColourOf of) const {
    if (const auto* pairs = std::get_if<Numbers>(&value.values)) {
        if (pairs->size() % 2 != 0)
            parameters.fail(value.name, "a spectrum takes pairs of a wavelength and a value");
        return colour_of(spectrum_of_pairs(*pairs, value.where), of);
    }
    const std::string name = parameters.text(value.name, "");
    if (const auto glass = glass_by_name(name)) return Rgb(static_cast<float>(glass->index));
    for (const NamedConstants& known : kConstants)
        if (known.name == name) return Rgb(known.rgb[0], known.rgb[1], known.rgb[2]);
    for (const NamedLamp& lamp : kLamps) {
        if (lamp.name != name) continue;
        return lamp.kelvin > 0 ? of_black_body(lamp.kelvin) : Rgb(1.0f);
    }
    const SourceLocation& where =
        value.value_where.empty() ? value.where : value.value_where.front();
    if (name.starts_with("metal-") || name.starts_with("glass-") || name.starts_with("stdillum-")) {
        throw InputError(where, unknown_name("spectrum", name));
    }
    return colour_of(
        spectrum_of_pairs(numbers_in_file(executor_.find({name, where}), where), where), of);
}

}  // namespace lxs::pbrt
