// Colour of sunlight: solar spectrum, attenuated by the atmosphere, as linear RGB.
#include "solar_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lxs/spectrum/colour_matching.h"

namespace lxs {
namespace {

struct SolarSample {
    double radiance;  ///< of the sun's disk outside of the atmosphere, 100 W m^-2 nm^-1 sr^-1
    double ozone;     ///< absorption coefficient k_o, 1/cm
    double water;     ///< absorption coefficient k_wa, 1/cm
};

constexpr double kFirstWavelength = 380;  // nm
constexpr double kStep = 10;              // nm

// Preetham et al. 1999, table 2 (after Iqbal 1983), 380 to 750 nm; k_g is zero there.
constexpr std::array<SolarSample, 38> kSolar = {{
    {165.5, 0.000, 0},     {162.3, 0.000, 0},      {211.2, 0.000, 0},   {258.8, 0.000, 0},
    {258.2, 0.000, 0},     {242.3, 0.000, 0},      {267.6, 0.000, 0},   {296.6, 0.003, 0},
    {305.4, 0.006, 0},     {300.6, 0.009, 0},      {306.6, 0.014, 0},   {288.3, 0.021, 0},
    {287.1, 0.030, 0},     {278.2, 0.040, 0},      {271.0, 0.048, 0},   {272.3, 0.063, 0},
    {263.6, 0.075, 0},     {255.0, 0.085, 0},      {250.6, 0.103, 0},   {253.1, 0.120, 0},
    {253.5, 0.120, 0},     {251.3, 0.115, 0},      {246.3, 0.125, 0},   {241.7, 0.120, 0},
    {236.8, 0.105, 0},     {232.1, 0.090, 0},      {228.2, 0.079, 0},   {223.4, 0.067, 0},
    {219.7, 0.057, 0},     {215.3, 0.048, 0},      {211.0, 0.036, 0},   {207.3, 0.028, 0.016},
    {202.4, 0.023, 0.024}, {198.7, 0.018, 0.0125}, {194.3, 0.014, 1.0}, {190.7, 0.011, 0.87},
    {186.3, 0.010, 0.061}, {182.6, 0.009, 0.001},
}};

/// Linear between the rows of kSolar.
SolarSample solar_sample(double nm) {
    const double place = (nm - kFirstWavelength) / kStep;
    const auto below = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(below);
    const SolarSample &a = kSolar.at(below), &b = kSolar.at(below + 1);
    return {std::lerp(a.radiance, b.radiance, share), std::lerp(a.ozone, b.ozone, share),
            std::lerp(a.water, b.water, share)};
}

/// Share of sunlight of `wavelength` nm that `mass` = relative optical mass of air lets through
/// (Preetham et al. 1999, appendix A.2, equations for tau_r, tau_a, tau_o, tau_wa).
double transmittance(const SolarSample& s, double wavelength, double mass, double turbidity) {
    const double micron = wavelength / 1000;
    const double beta = std::max(0.0, 0.04608365822050 * turbidity - 0.04586025928522);
    constexpr double kOzone = 0.35;  // amount, cm
    constexpr double kWater = 2.0;   // precipitable, cm
    const double rayleigh = 0.008735 * std::pow(micron, -4.08);
    const double angstrom = beta * std::pow(micron, -1.3);
    const double water =
        0.2385 * s.water * kWater * mass / std::pow(1 + 20.07 * s.water * kWater * mass, 0.45);
    return std::exp(-mass * (rayleigh + angstrom + s.ozone * kOzone) - water);
}

}  // namespace

Rgb sun_radiance(double cos_zenith, double turbidity) {
    constexpr double kRounding = 1e-6;  // of a sun turned to the horizon
    if (!(cos_zenith > -kRounding)) return Rgb(0.0f);
    const double zenith = std::acos(std::clamp(cos_zenith, 0.0, 1.0));
    const double degrees = zenith * 180 / std::numbers::pi;
    const double mass = 1 / (std::cos(zenith) + 0.15 * std::pow(93.885 - degrees, -1.253));
    constexpr double kUnit = 100;           // of SolarSample::radiance
    constexpr double kLumensPerWatt = 683;  // maximum luminous efficacy of radiation
    constexpr double kLastNm = 720;         // LuxRender samples no longer waves
    // Tabulated at half the data's step, as LuxRender does, and linear in between.
    const auto node = [&](double nm) {
        const SolarSample s = solar_sample(nm);
        return kUnit * s.radiance * transmittance(s, nm, mass, turbidity);
    };
    constexpr double kNodes = kStep / 2;
    Imath::V3d xyz(0.0);
    for (double left = kFirstWavelength; left < kLastNm; left += kNodes) {
        const double at_left = node(left), at_right = node(left + kNodes);
        for (double nm = 0; nm < kNodes; ++nm) {
            xyz += colour_matching(left + nm) *
                   (kLumensPerWatt * std::lerp(at_left, at_right, nm / kNodes));
        }
    }
    return clipped_rgb_of_xyz(xyz);
}

}  // namespace lxs
