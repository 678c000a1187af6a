// Sun and skies against the formulas that LuxRender 1.9 evaluates, at ten settings each.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "colour_formulas.h"
#include "hosek_wilkie_data.h"
#include "light_cases.h"

namespace lxs::test::sky_formulas_test {
namespace {

constexpr double kPi = std::numbers::pi;

struct SkySetting {
    Imath::V3d sun;
    double turbidity, gain;
    std::array<double, 5> factors;  ///< of the coefficients A to E
};

const std::array<SkySetting, 10> kSkies = {{
    {{0, 0, 1}, 2, 1, {1, 1, 1, 1, 1}},
    {{0.6, 0, 0.8}, 2.2, 1, {1, 1, 1, 1, 1}},
    {{0.5, -0.6, 0.7}, 2.2, 0.5, {1, 1, 1, 1, 1}},
    {{0, 0.8, 0.6}, 3, 1, {1.5, 1, 1, 1, 1}},
    {{-0.9, 0.1, 0.4}, 4, 1, {1, 1.4, 1, 1, 1}},
    {{0.3, -0.4, 0.866}, 3, 2, {1, 1, 2, 1, 1}},
    {{0.3, -0.4, 0.866}, 5, 1, {1, 1, 1, 0.5, 1}},
    {{0.8, 0.5, 0.3}, 2.5, 1, {1, 1, 1, 1, 3}},
    {{0.1, 0.2, 0.3}, 6, 1, {0.8, 1.2, 0.7, 1.3, 0.6}},
    {{0.9, 0, 0.1}, 9, 1, {1, 1, 1, 1, 1}},
}};

const std::array<Vec3, 6> kDirections = {Vec3(0, 0, 1),           Vec3(0.6f, 0, 0.8f),
                                         Vec3(-0.8f, 0, 0.6f),    Vec3(0.48f, -0.64f, 0.6f),
                                         Vec3(0.1f, 0.9f, 0.05f), Vec3(0, -1, -0.3f)};

/// Preetham et al. 1999; `theta` of the sun is that of its unit vector, `gamma` that of the given
/// one, and the factors scale the coefficients of luminance and chromaticities alike.
Imath::V3d preetham(const SkySetting& s, const Vec3& w) {
    const double t = s.turbidity;
    const double sun = std::acos(s.sun.normalized().z), sun2 = sun * sun, sun3 = sun2 * sun;
    const auto value = [&](std::array<double, 5> c, double zenith) {
        for (std::size_t i = 0; i < 5; ++i)
            c[i] *= s.factors[i];
        const auto perez = [&c](double theta, double gamma) {
            const double cosine = std::cos(gamma);
            return (1 + c[0] * std::exp(c[1] / std::cos(theta))) *
                   (1 + c[2] * std::exp(c[3] * gamma) + c[4] * cosine * cosine);
        };
        const double theta = std::min(std::acos(double(w.z)), kPi / 2 - 0.001);
        const double gamma = std::acos(std::clamp(Imath::V3d(w) ^ s.sun, -1.0, 1.0));
        return zenith * perez(theta, gamma) / perez(0, sun);
    };
    const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * sun);
    const double luminance =
        value({0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
               -0.0670 * t + 0.3703},
              1000 * ((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192));
    const double x = value({-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                            -0.0641 * t - 0.8989, -0.0033 * t + 0.0452},
                           (0.00166 * sun3 - 0.00375 * sun2 + 0.00209 * sun) * t * t +
                               (-0.02903 * sun3 + 0.06377 * sun2 - 0.03202 * sun + 0.00394) * t +
                               0.11693 * sun3 - 0.21196 * sun2 + 0.06052 * sun + 0.25886);
    const double y = value({-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                            -0.0441 * t - 1.6537, -0.0109 * t + 0.0529},
                           (0.00275 * sun3 - 0.00610 * sun2 + 0.00317 * sun) * t * t +
                               (-0.04214 * sun3 + 0.08970 * sun2 - 0.04153 * sun + 0.00516) * t +
                               0.15346 * sun3 - 0.26756 * sun2 + 0.06670 * sun + 0.26688);
    // Daylight of that chromaticity, whose spectrum comes back as it.
    return scene_rgb({luminance * x / y, luminance, luminance * (1 - x - y) / y}) * s.gain;
}

TEST(SkyFormulas, Sky) {
    const std::array<const char*, 5> names = {"horizonbrightness", "horizonsize",
                                              "sunhalobrightness", "sunhalosize", "backscattering"};
    for (std::size_t i = 0; i < kSkies.size(); ++i) {
        const SkySetting& s = kSkies[i];
        std::vector<ParameterValue> values = {
            numbers("vector", "sundir", {s.sun.x, s.sun.y, s.sun.z}),
            numbers("float", "turbidity", {s.turbidity}), numbers("float", "gain", {s.gain})};
        for (std::size_t k = 0; k < names.size(); ++k)
            values.push_back(numbers("float", names[k], {s.factors[k]}));
        const auto light = make_one("sky", values);
        for (const Vec3& given : kDirections) {
            SCOPED_TRACE(testing::Message() << "setting " << i << ", towards " << given);
            const Vec3 w = given.normalized();
            const Rgb found = light->escaped(w);
            const Imath::V3d published = preetham(s, w);
            const double scale = std::max({published.x, published.y, published.z});
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c], std::max(published[c], 0.0), 0.003 * scale) << c;
        }
    }
}

/// Hosek & Wilkie 2012 at one wavelength, its coefficients linear between those of the data.
double hosek_wilkie(const SkySetting& s, const Vec3& w, double nm) {
    const double elevation = kPi / 2 - std::acos(std::clamp(s.sun.z, -1.0, 1.0));
    const double x = std::cbrt(elevation * 2 / kPi), y = 1 - x;
    const std::array<double, 6> bezier = {std::pow(y, 5),         5 * std::pow(y, 4) * x,
                                          10 * y * y * y * x * x, 10 * y * y * x * x * x,
                                          5 * y * std::pow(x, 4), std::pow(x, 5)};
    const auto low = std::min(static_cast<std::size_t>(s.turbidity - 1), std::size_t{9});
    const std::size_t high = std::min(low + 1, std::size_t{9});
    const std::size_t band = std::min(static_cast<std::size_t>((nm - 360) / 40), std::size_t{8});
    const auto coefficient = [&](const auto& at) {
        double sum = 0;
        for (const std::size_t b : {band, band + 1}) {
            const double share = 1 - std::abs((nm - 360) / 40 - double(b));
            for (std::size_t p = 0; p < 6; ++p) {
                sum += share * bezier[p] *
                       std::lerp(double(at(kHosekWilkieData[b], low, p)),
                                 double(at(kHosekWilkieData[b], high, p)),
                                 std::clamp(s.turbidity - double(high), 0.0, 1.0));
            }
        }
        return sum;
    };
    std::array<double, 9> c{};
    for (std::size_t i = 0; i < 9; ++i) {
        c[i] = coefficient([i](const HosekWilkieBand& data, std::size_t t, std::size_t p) {
            return data.coefficients[t][p][i];
        });
    }
    const double mean = coefficient([](const HosekWilkieBand& data, std::size_t t, std::size_t p) {
        return data.radiance[t][p];
    });
    const double cosine = std::clamp(Imath::V3d(w) ^ s.sun, -1.0, 1.0), gamma = std::acos(cosine);
    const double height = std::max(0.0, double(w.z));
    const double mie = (1 + cosine * cosine) / std::pow(1 + c[8] * c[8] - 2 * c[8] * cosine, 1.5);
    return mean * (1 + c[0] * std::exp(c[1] / (height + 0.01))) *
           (c[2] + c[3] * std::exp(c[4] * gamma) + c[5] * cosine * cosine + c[6] * mie +
            c[7] * std::sqrt(height));
}

TEST(SkyFormulas, Sky2) {
    double flat = 0;
    for (double nm = 360; nm <= 830; ++nm)
        flat += colour_matching(nm).y;
    for (std::size_t i = 0; i < kSkies.size(); ++i) {
        const SkySetting& s = kSkies[i];
        const auto light =
            make_one("sky2", {numbers("vector", "sundir", {s.sun.x, s.sun.y, s.sun.z}),
                              numbers("float", "turbidity", {s.turbidity}),
                              numbers("float", "gain", {s.gain})});
        for (const Vec3& given : kDirections) {
            SCOPED_TRACE(testing::Message() << "setting " << i << ", towards " << given);
            const Vec3 w = given.normalized();
            const Rgb found = light->escaped(w);
            const Imath::V3d published =
                scene_rgb(film_xyz([&](double nm) { return hosek_wilkie(s, w, nm); })) *
                (683 * flat * s.gain);
            const double scale = std::max({published.x, published.y, published.z});
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c], std::max(published[c], 0.0), 0.005 * scale) << c;
        }
    }
}

// W m^-2 nm^-1 sr^-1 from 380 nm on at steps of 10 nm, and ozone's absorption, 1/cm (Preetham et
// al. 1999, table 2).
constexpr std::array<double, 36> kSolarRadiance = {
    16559,   16233.7, 21127.5, 25888.2, 25829.1, 24232.3, 26760.5, 29658.3, 30545.4,
    30057.5, 30663.7, 28830.4, 28712.1, 27825,   27100.6, 27233.6, 26361.3, 25503.8,
    25060.2, 25311.6, 25355.9, 25134.2, 24631.5, 24173.2, 23685.3, 23212.1, 22827.7,
    22339.8, 21970.2, 21526.7, 21097.9, 20728.3, 20240.4, 19870.8, 19427.2, 19072.4};
constexpr std::array<double, 36> kOzone = {
    0,     0,     0,     0,     0,     0,     0.001, 0.003, 0.006, 0.009, 0.014, 0.021,
    0.030, 0.040, 0.048, 0.063, 0.075, 0.085, 0.103, 0.120, 0.120, 0.115, 0.125, 0.120,
    0.105, 0.090, 0.079, 0.067, 0.057, 0.048, 0.036, 0.028, 0.023, 0.018, 0.014, 0.011};

double at(const std::array<double, 36>& table, double nm) {
    const auto below = std::min(static_cast<std::size_t>((nm - 380) / 10), table.size() - 2);
    return std::lerp(table[below], table[below + 1], (nm - 380) / 10 - double(below));
}

/// Of water vapour, 1/cm.
double water(double nm) {
    const std::array<double, 5> k = {0.016, 0.024, 0.0125, 1.0, 0.87};
    if (nm < 690) return std::max(0.0, nm - 689) * 0.016;
    const auto below = std::min(static_cast<std::size_t>((nm - 690) / 10), k.size() - 2);
    return std::lerp(k[below], k[below + 1], (nm - 690) / 10 - double(below));
}

/// The disk's light through the air, tabulated at 5 nm.
Imath::V3d solar(double zenith, double turbidity) {
    const double m = 1 / (std::cos(zenith) + 0.00094 * std::pow(1.6386 - zenith, -1.253));
    const double beta = 0.04608365822050 * turbidity - 0.04586025928522;
    const auto node = [&](double nm) {
        const double um = nm / 1000, wet = water(nm) * 2;
        return at(kSolarRadiance, nm) *
               std::exp(-m * (0.008735 * std::pow(um, -4.08) + beta * std::pow(um, -1.3) +
                              at(kOzone, nm) * 0.35)) *
               std::exp(-0.2385 * wet * m / std::pow(1 + 20.07 * wet * m, 0.45));
    };
    const auto spectrum = [&](double nm) {
        const double left = 5 * std::floor(nm / 5);
        return std::lerp(node(left), node(left + 5), (nm - left) / 5);
    };
    double flat = 0;
    for (double nm = 360; nm <= 830; ++nm)
        flat += colour_matching(nm).y;
    return scene_rgb(film_xyz(spectrum)) * (683 * flat);
}

TEST(SkyFormulas, Sun) {
    for (std::size_t i = 0; i < kSkies.size(); ++i) {
        const SkySetting& s = kSkies[i];
        SCOPED_TRACE(i);
        const double size = 0.5 + 0.5 * double(i);
        const auto light = make_one(
            "sun", {numbers("vector", "sundir", {s.sun.x, s.sun.y, s.sun.z}),
                    numbers("float", "turbidity", {s.turbidity}),
                    numbers("float", "gain", {s.gain}), numbers("float", "relsize", {size})});
        const Vec3 w(s.sun.normalized());
        const Imath::V3d published =
            solar(std::acos(double(w.z)), s.turbidity) * (s.gain / (size * size));
        const Rgb found = light->escaped(w);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], std::max(published[c], 0.0), 0.01 * published.x) << c;
    }
}

/// The sun's height that dims it is that in the world.
TEST(SkyFormulas, ATurnedSunShinesThroughTheAirOfTheWorld) {
    Matrix tilted;
    tilted.setAxisAngle(Imath::V3d(1, 0, 0), kPi / 3);
    const auto light = make_one("sun", {numbers("vector", "sundir", {0, 0, 1})}, tilted);
    const Vec3 w(0, float(-std::sin(kPi / 3)), 0.5f);
    EXPECT_NEAR(light->escaped(w).y / solar(kPi / 3, 2).y, 1, 0.01);
}

}  // namespace
}  // namespace lxs::test::sky_formulas_test
