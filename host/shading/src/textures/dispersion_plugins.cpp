// Fresnel textures from formulas and files: "cauchy", "sellmeier", "abbe", "sopra", "luxpop".
#include <algorithm>
#include <array>
#include <cmath>

#include "materials/metal_colour.h"
#include "materials/metal_presets.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

using FresnelPointer = std::shared_ptr<const FresnelTexture>;

/// A dielectric whose index for red, green and blue is `index(micrometres)`; fails at `parameter`
/// if that isn't above 0.
template <class Index>
FresnelPointer dielectric(const ParameterReader& reader, std::string_view parameter,
                          const Index& index) {
    FresnelValue value;
    for (int i = 0; i < 3; ++i) {
        const double n = index(1e-3 * double{kRgbWavelengths[i]});
        if (!(n > 0) || !std::isfinite(n)) {
            reader.fail(parameter, reader.plugin() +
                                       ": the index of refraction is not above 0 "
                                       "for visible light");
        }
        value.eta[i] = static_cast<float>(n);
    }
    return std::make_shared<ConstantTexture<FresnelValue>>(value);
}

FresnelPointer create_cauchy(const ParameterReader& reader, const AssetContext&, const Matrix&) {
    const double b = reader.number("cauchyb", 0.00354);
    const double index = reader.number("index", -1);
    constexpr double kSodiumD = 0.5893;  // micrometres; indices of glass are given there
    const double a =
        index > 0 ? index - b / (kSodiumD * kSodiumD) : reader.number("cauchya", 1.458);
    return dielectric(reader, "cauchyb", [&](double l) { return a + b / (l * l); });
}

/// Three terms; the defaults are those of fused silica (Malitson 1965, J. Opt. Soc. Am. 55,
/// 1205-1209), whose form of the equation this is: C are wavelengths.
struct SellmeierTerms {
    std::array<double, 3> b{0.6961663, 0.4079426, 0.8974794};
    std::array<double, 3> c{0.0684043, 0.1162414, 9.896161};
};

void read_terms(const ParameterReader& reader, std::string_view name, std::array<double, 3>& out) {
    const auto values = reader.numbers(name);
    if (values.empty()) return;
    if (values.size() > out.size())
        reader.fail(name, "sellmeier: \"" + std::string(name) + "\" takes at most 3 numbers");
    out.fill(0);
    std::copy(values.begin(), values.end(), out.begin());
}

FresnelPointer create_sellmeier(const ParameterReader& reader, const AssetContext&, const Matrix&) {
    SellmeierTerms terms;
    read_terms(reader, "B", terms.b);
    read_terms(reader, "C", terms.c);
    const double a = reader.number("A", 1);
    return dielectric(reader, "B", [&](double l) {
        double n2 = a;
        for (std::size_t i = 0; i < terms.b.size(); ++i)
            n2 += terms.b[i] * l * l / (l * l - terms.c[i] * terms.c[i]);
        return std::sqrt(n2);
    });
}

constexpr std::array<std::string_view, 4> kAbbeModes{"d", "D", "e", "custom"};

/// Wavelengths of an Abbe number, nanometres: index, then the two of its dispersion.
struct AbbeLines {
    double middle, blue, red;
};

AbbeLines abbe_lines(const ParameterReader& reader) {
    const std::string mode = reader.string("mode", "d");
    AbbeLines lines{587.5618, 486.1327, 656.2725};  // helium d, hydrogen F and C
    if (mode == "D") lines.middle = 589.2938;       // sodium D
    if (mode == "e") lines = {546.0740, 479.9914, 643.8469};
    lines.middle = reader.number("lambda_D", lines.middle);
    lines.blue = reader.number("lambda_F", lines.blue);
    lines.red = reader.number("lambda_C", lines.red);
    return lines;
}

// An Abbe number V = (n_D - 1) / (n_F - n_C) and an index fix the two terms of Cauchy's formula.
FresnelPointer create_abbe(const ParameterReader& reader, const AssetContext&, const Matrix&) {
    const double v = reader.number("V", 64.17), n = reader.number("n", 1.5168);
    const AbbeLines lines = abbe_lines(reader);
    const auto inverse_square = [](double nm) { return 1e6 / (nm * nm); };  // um^-2
    const double spread = inverse_square(lines.blue) - inverse_square(lines.red);
    if (spread == 0) reader.fail("lambda_F", "abbe: lambda_F and lambda_C are the same");
    const double b = (n - 1) / (v * spread);
    const double a = n - b * inverse_square(lines.middle);
    return dielectric(reader, "n", [&](double l) { return a + b / (l * l); });
}

FresnelTextureFactory table_plugin(OpticalFormat format) {
    return {{{"filename", ParameterType::String, "", "file of measured n and k"}},
            [format](const ParameterReader& reader, const AssetContext& assets,
                     const Matrix&) -> FresnelPointer {
                if (!reader.given("filename"))
                    reader.fail("filename", reader.plugin() + ": \"filename\" is missing");
                const SourceLocation& where = reader.where("filename");
                const std::string path = assets.resolve(reader.string("filename", ""), where);
                return std::make_shared<ConstantTexture<FresnelValue>>(
                    constants_of_colour(read_optical_table(path, format, where)));
            }};
}

}  // namespace

FresnelTextureFactory cauchy_plugin() {
    return {
        {{"cauchya", ParameterType::Float, "1.458", "Cauchy's A: index for long waves"},
         {"cauchyb", ParameterType::Float, "0.00354", "Cauchy's B, square micrometres"},
         {"index", ParameterType::Float, "-1", "index at 589 nm; when above 0, A follows from it"}},
        &create_cauchy};
}

FresnelTextureFactory sellmeier_plugin() {
    ParameterDeclaration b{"B", ParameterType::Float, "0.6961663 0.4079426 0.8974794",
                           "strengths of the resonances, up to 3"};
    ParameterDeclaration c{"C", ParameterType::Float, "0.0684043 0.1162414 9.896161",
                           "wavelengths of the resonances, micrometres"};
    b.array = c.array = true;
    return {{{.name = "A",
              .type = ParameterType::Float,
              .default_text = "1",
              .doc = "constant term of the squared index",
              .older_name = "a"},
             b,
             c},
            &create_sellmeier};
}

FresnelTextureFactory abbe_plugin() {
    using enum ParameterType;
    ParameterDeclaration mode{"mode", String, "d", "spectral lines that V and n refer to"};
    mode.choices = kAbbeModes;
    return {{mode,
             {"V", Float, "64.17", "Abbe number", 1e-3},
             {"n", Float, "1.5168", "index at lambda_D", 1e-3},
             {"lambda_D", Float, "587.5618", "wavelength of the index, nanometres", 1},
             {"lambda_F", Float, "486.1327", "shorter wavelength of V, nanometres", 1},
             {"lambda_C", Float, "656.2725", "longer wavelength of V, nanometres", 1}},
            &create_abbe};
}

FresnelTextureFactory sopra_plugin() {
    return table_plugin(OpticalFormat::Sopra);
}
FresnelTextureFactory luxpop_plugin() {
    return table_plugin(OpticalFormat::LuxPop);
}

}  // namespace lxs::shading
