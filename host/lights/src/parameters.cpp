// Declared parameters of all light sources.
#include <array>

#include "lxs/lights/lights.h"

namespace lxs {
namespace {

using Type = ParameterType;

constexpr ParameterDeclaration kGain{
    .name = "gain", .default_text = "1", .doc = "Factor on the light's emission.", .minimum = 0};
constexpr ParameterDeclaration kColor{
    .name = "L",
    .type = Type::ColorTexture,
    .default_text = "1 1 1",
    .doc =
        "Emission: cd of point and spot, cd/m^2 of infinite, 1/10430 lx of distant; of a spectrum "
        "683 times the watts. A texture counts with its colour at the origin."};
constexpr ParameterDeclaration power(std::string_view default_text) {
    return {
        .name = "power",
        .default_text = default_text,
        .doc =
            "Electrical power in watts; with efficacy it sets the emitted flux, 0 leaves L alone.",
        .minimum = 0};
}
constexpr ParameterDeclaration efficacy(std::string_view default_text) {
    return {.name = "efficacy",
            .default_text = default_text,
            .doc = "Lumens emitted per watt of power, 0 leaves L alone.",
            .minimum = 0};
}
constexpr ParameterDeclaration kFrom{.name = "from",
                                     .type = Type::Point,
                                     .default_text = "0 0 0",
                                     .doc = "Position, in the light's space."};
constexpr ParameterDeclaration kTo{.name = "to",
                                   .type = Type::Point,
                                   .default_text = "0 0 1",
                                   .doc = "Point that the light aims at."};
constexpr ParameterDeclaration kSunDirection{.name = "sundir",
                                             .type = Type::Vector,
                                             .default_text = "0 0 1",
                                             .doc = "Direction towards the sun."};
constexpr ParameterDeclaration kTurbidity{
    .name = "turbidity",
    .default_text = "2",
    .doc = "Haze: 2 is a very clear sky, 10 a hazy one; the model holds up to about 10.",
    .minimum = 1,
    .maximum = 64};
constexpr ParameterDeclaration kRelativeSize{
    .name = "relsize",
    .default_text = "1",
    .doc = "Radius of the sun's disk, relative to the real one; its light stays as much.",
    .minimum = 0.001,
    .maximum = 215};
/// Exporters write it; LuxRender's sun and sky do not read it.
constexpr ParameterDeclaration kUnreadColor{.name = "L",
                                            .type = Type::ColorTexture,
                                            .default_text = "1 1 1",
                                            .doc = "Sun and sky have the colours of their models.",
                                            .no_effect = true};
constexpr ParameterDeclaration kImportance{.name = "importance",
                                           .default_text = "1",
                                           .doc = "Share of samples spent on the light.",
                                           .no_effect = true};
/// Not LuxRender's, which warns of it and shows the light.
constexpr ParameterDeclaration kHidden{
    .name = "hidden",
    .type = Type::Bool,
    .default_text = "false",
    .doc = "The camera does not see the light itself; mirrors and glass show it. Not LuxRender's."};
constexpr ParameterDeclaration kSamples{.name = "nsamples",
                                        .type = Type::Integer,
                                        .default_text = "1",
                                        .doc = "Shadow rays a point.",
                                        .no_effect = true};
constexpr ParameterDeclaration kIes{
    .name = "iesname",
    .type = Type::String,
    .default_text = "",
    .doc =
        "Photometric file (IESNA LM-63, type C) of the emission by direction, not of how much "
        "there is; vertical angle 0 along +z."};
constexpr ParameterDeclaration kProfileMap{
    .name = "mapname",
    .type = Type::String,
    .default_text = "",
    .doc =
        "Image of the emission by direction, not of how much there is, latitude-longitude, its top "
        "row along +z."};
constexpr ParameterDeclaration kMapGamma{.name = "gamma",
                                         .default_text = "1",
                                         .doc =
                                             "Exponent on the image's values, 1 for linear "
                                             "images.",
                                         .minimum = 0.01,
                                         .maximum = 10};
constexpr std::array<std::string_view, 2> kCurves = {"gamma", "srgb"};
constexpr ParameterDeclaration kMapCurve{
    .name = "colorspace",
    .type = Type::String,
    .default_text = "gamma",
    .doc = "How the image's values become linear: by gamma, or by sRGB's curve. Not LuxRender's.",
    .choices = kCurves};
constexpr ParameterDeclaration kFlip{.name = "flipz",
                                     .type = Type::Bool,
                                     .default_text = "false",
                                     .doc = "Turns image and photometric file upside down."};

constexpr ParameterDeclaration coefficient(std::string_view name, std::string_view older_name,
                                           std::string_view doc) {
    return {.name = name, .default_text = "1", .doc = doc, .older_name = older_name};
}
constexpr std::array kSkyCoefficients = {
    coefficient("horizonbrightness", "aconst",
                "Factor on coefficient A of the sky's brightness and colours."),
    coefficient("horizonsize", "bconst",
                "Factor on coefficient B of the sky's brightness and colours."),
    coefficient("sunhalobrightness", "cconst",
                "Factor on coefficient C of the sky's brightness and colours."),
    coefficient("sunhalosize", "dconst",
                "Factor on coefficient D of the sky's brightness and colours."),
    coefficient("backscattering", "econst",
                "Factor on coefficient E of the sky's brightness and colours."),
};

constexpr std::array<std::string_view, 4> kMappings = {"latlong", "angular", "vcross", "equalarea"};

constexpr std::array<std::string_view, 2> kFalloffs = {"fourthpower", "smoothstep"};

constexpr std::array<std::string_view, 2> kProfileMappings = {"latlong", "equalarea"};
constexpr ParameterDeclaration kProfileMapping{
    .name = "mapping",
    .type = Type::String,
    .default_text = "latlong",
    .doc =
        "Layout of the image: latitude-longitude, or (not LuxRender's) pbrt's equal-area "
        "octahedral square.",
    .choices = kProfileMappings};
constexpr ParameterDeclaration kPlainValues{
    .name = "plainvalues",
    .type = Type::Bool,
    .default_text = "false",
    .doc = "The intensity is L times the image's values as they are. Not LuxRender's."};

using Declarations = std::vector<ParameterDeclaration>;

constexpr ParameterDeclaration kMapResolution{.name = "imapmaxresolution",
                                              .type = Type::Integer,
                                              .default_text = "500",
                                              .doc = "Resolution of the map that steers sampling.",
                                              .no_effect = true};

Declarations infinite_parameters() {
    return {kColor,
            kGain,
            {.name = "mapname",
             .type = Type::String,
             .default_text = "",
             .doc = "Image of the radiance by direction; without it the light is constant."},
            {.name = "mapping",
             .type = Type::String,
             .default_text = "latlong",
             .doc = "Layout of the image: latitude-longitude, angular map, vertical cross, or (not "
                    "LuxRender's) pbrt's equal-area octahedral square.",
             .choices = kMappings},
            {.name = "plaincolors",
             .type = Type::Bool,
             .default_text = "false",
             .doc = "The image's colours shine as they are, where LuxRender turns saturated ones a "
                    "little. Not LuxRender's."},
            {.name = "illuminance",
             .default_text = "0",
             .doc = "Of a patch that looks along +z of the image, which is scaled to give as much; "
                    "gain and L are factors on it. 0: the image's values count. Not LuxRender's.",
             .minimum = 0},
            kMapGamma,
            kMapCurve,
            kMapResolution,
            kHidden,
            kSamples,
            kImportance};
}

/// Of the Hosek-Wilkie sky.
Declarations sky2_parameters() {
    return {kSunDirection, kTurbidity, kGain, kUnreadColor, kHidden, kSamples, kImportance};
}

/// Of the Preetham sky.
Declarations sky_parameters() {
    Declarations all = sky2_parameters();
    all.insert(all.end(), kSkyCoefficients.begin(), kSkyCoefficients.end());
    return all;
}

Declarations with_sun(Declarations sky) {
    sky.push_back(kRelativeSize);
    return sky;
}

Declarations spot_parameters() {
    return {kColor,
            kGain,
            power("0"),
            efficacy("0"),
            kFrom,
            kTo,
            {.name = "coneangle",
             .default_text = "30",
             .doc = "Half angle of the cone, degrees.",
             .minimum = 0,
             .maximum = 180},
            {.name = "conedeltaangle",
             .default_text = "5",
             .doc = "Width of the falloff at the cone's rim, degrees.",
             .minimum = 0,
             .maximum = 180},
            {.name = "falloff",
             .type = Type::String,
             .default_text = "fourthpower",
             .doc = "Law of the falloff by the cosine's share: LuxRender's, or (not LuxRender's) "
                    "pbrt-v4's smoothstep.",
             .choices = kFalloffs},
            kSamples,
            kImportance};
}

Declarations point_parameters() {
    return {kColor,          kGain,        power("0"), efficacy("0"), kFrom, kIes,     kProfileMap,
            kProfileMapping, kPlainValues, kMapGamma,  kMapCurve,     kFlip, kSamples, kImportance};
}

Declarations distant_parameters() {
    return {kColor,
            kGain,
            kFrom,
            kTo,
            {.name = "theta",
             .default_text = "0",
             .doc = "Half angle that the light subtends, degrees; 0 is parallel light.",
             .minimum = 0,
             .maximum = 90},
            kHidden,
            kSamples,
            kImportance};
}

/// Lights whose colour is an intensity by direction; it was called so.
Declarations with_older_intensity(Declarations all) {
    for (ParameterDeclaration& declaration : all) {
        if (declaration.name == kColor.name) declaration.older_name = "I";
    }
    return all;
}

Declarations projection_parameters() {
    return {kColor,
            kGain,
            power("0"),
            efficacy("0"),
            kFrom,
            kTo,
            {.name = "mapname",
             .type = Type::String,
             .default_text = "",
             .doc = "Projected image; without it a square of light."},
            kPlainValues,
            kMapGamma,
            kMapCurve,
            {.name = "fov",
             .default_text = "45",
             .doc = "Angle of the projected image along its shorter side, degrees.",
             .minimum = 0.01,
             .maximum = 179},
            kSamples,
            kImportance};
}

}  // namespace

const std::vector<LightPlugin>& light_plugins() {
    static const std::vector<LightPlugin> plugins = {
        {"distant", distant_parameters()},
        {"goniometric", with_older_intensity(point_parameters())},
        {"infinite", infinite_parameters()},
        {"infinitesample", infinite_parameters()},
        {"point", point_parameters()},
        {"projection", with_older_intensity(projection_parameters())},
        {"sky", sky_parameters()},
        {"sky2", sky2_parameters()},
        {"spot", spot_parameters()},
        {"sun",
         {kSunDirection, kTurbidity, kRelativeSize, kGain, kUnreadColor, kHidden, kSamples,
          kImportance}},
        {"sunsky", with_sun(sky_parameters())},
        {"sunsky2", with_sun(sky2_parameters())},
    };
    return plugins;
}

std::span<const ParameterDeclaration> area_light_parameters() {
    static constexpr std::array kParameters = {
        ParameterDeclaration{
            .name = "L",
            .type = Type::ColorTexture,
            .default_text = "1 1 1",
            .doc =
                "Luminance, cd/m^2; only its colour counts where power and efficacy are above 0."},
        kGain,
        // LuxRender's area lights, unlike its point and spot lights, have a power unless told not
        // to.
        power("100"),
        efficacy("17"),
        ParameterDeclaration{
            .name = "iesname",
            .type = Type::String,
            .default_text = "",
            .doc = "Photometric file (IESNA LM-63, type C) of the intensity by direction, relative "
                   "to its largest; vertical angle 0 along the normal, one-sided."},
        ParameterDeclaration{.name = "mapname",
                             .type = Type::String,
                             .default_text = "",
                             .doc = "Image of the intensity by direction, latitude-longitude, its "
                                    "top row along the normal; one-sided."},
        kMapGamma,
        kMapCurve,
        kFlip,
        kHidden,
        kSamples,
        kImportance,
    };
    return kParameters;
}

}  // namespace lxs
