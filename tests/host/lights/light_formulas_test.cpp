// Every light without geometry, and the area light, against LuxRender 1.9's formulas at ten
// settings each. Sun and skies: sky_formulas_test.cpp.
#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "colour_formulas.h"
#include "light_cases.h"
#include "temporary_folder.h"

namespace lxs::test::light_formulas_test {
namespace {

constexpr double kPi = std::numbers::pi;

struct Setting {
    Rgb l;
    double gain, power, efficacy;
};

const std::array<Setting, 10> kSettings = {{{Rgb(1), 1, 0, 0},
                                            {Rgb(1, 0, 0), 2, 0, 0},
                                            {Rgb(0, 1, 0), 1, 60, 15},
                                            {Rgb(0, 0, 1), 0.5, 100, 17},
                                            {Rgb(5, 1, 1), 1, 0, 10},
                                            {Rgb(1, 5, 2), 3, 10, 100},
                                            {Rgb(0.2f, 0.4f, 2), 1, 0, 0},
                                            {Rgb(1, 1, 0.1f), 1, 5, 80},
                                            {Rgb(0.9f, 0.1f, 0.8f), 10, 0, 0},
                                            {Rgb(30, 20, 10), 1, 40, 0}}};

std::vector<ParameterValue> values_of(const Setting& s) {
    return {numbers("color", "L", {s.l.x, s.l.y, s.l.z}), numbers("float", "gain", {s.gain}),
            numbers("float", "power", {s.power}), numbers("float", "efficacy", {s.efficacy})};
}

/// gain, and what power and efficacy make of it where L alone emits `lumens` by unit luminance.
double gain_of(const Setting& s, double lumens) {
    const double factor = s.power * s.efficacy / (lumens * light_luminance(s.l));
    return factor > 0 ? s.gain * factor : s.gain;
}

/// Within a share of the greatest channel; the gamut's border is 0.
void expect_light(const Rgb& found, const Imath::V3d& published, double tolerance = 0.004) {
    const double scale = std::max({published.x, published.y, published.z});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], std::max(published[c], 0.0), tolerance * scale) << "channel " << c;
}

Rgb irradiance_at(const Light& light, const Vec3& p) {
    DirectSample s;
    return light.sample_direct(p, Vec3(0, 0, 1), Vec2(0.5f), s) ? s.radiance / s.pdf : Rgb(0.0f);
}

TEST(LightFormulas, Point) {
    for (const Setting& s : kSettings) {
        SCOPED_TRACE(s.l);
        const auto light = make_one("point", values_of(s));
        expect_light(irradiance_at(*light, Vec3(0, 0, 2)),
                     light_colour(s.l) * gain_of(s, 4 * kPi) / 4);
    }
}

// The cone's rim counts as half lit in its power, and falls with the fourth power.
TEST(LightFormulas, Spot) {
    for (std::size_t i = 0; i < kSettings.size(); ++i) {
        const Setting& s = kSettings[i];
        SCOPED_TRACE(i);
        const double cone = 10 + 7 * double(i), delta = 2 + double(i);  // degrees
        const double total = std::cos(cone * kPi / 180),
                     start = std::cos((cone - delta) * kPi / 180);
        std::vector<ParameterValue> values = values_of(s);
        values.push_back(numbers("float", "coneangle", {cone}));
        values.push_back(numbers("float", "conedeltaangle", {delta}));
        const auto light = make_one("spot", values);
        const Imath::V3d full =
            light_colour(s.l) * gain_of(s, 2 * kPi * (1 - 0.5 * (start + total)));
        for (const double share : {0.0, 0.5, 0.9}) {  // of the rim
            const double cosine = std::lerp(start, total, share);
            const Vec3 p(float(std::sqrt(1 - cosine * cosine)), 0, float(cosine));
            expect_light(irradiance_at(*light, p), full * std::pow(1 - share, 4), 0.006);
        }
    }
}

// The irradiance is L over the solid angle; parallel light has the cone that a float's 1 less 128
// steps is the cosine of.
TEST(LightFormulas, Distant) {
    for (std::size_t i = 0; i < kSettings.size(); ++i) {
        const Setting& s = kSettings[i];
        SCOPED_TRACE(i);
        const double theta = 3.0 * double(i) * kPi / 180;
        const double cosine = i == 0 ? 1 - 128 * 0x1p-23 : std::cos(theta);
        std::vector<ParameterValue> values = values_of(s);
        values.resize(2);
        values.push_back(numbers("float", "theta", {3.0 * double(i)}));
        const auto light = make_one("distant", values);
        expect_light(irradiance_at(*light, Vec3(0.0f)),
                     light_colour(s.l) * s.gain / (2 * kPi * (1 - cosine)));
    }
}

TEST(LightFormulas, InfiniteWithoutAMap) {
    for (const Setting& s : kSettings) {
        SCOPED_TRACE(s.l);
        std::vector<ParameterValue> values = values_of(s);
        values.resize(2);
        const auto light = make_one("infinite", values);
        expect_light(light->escaped(Vec3(0, 0, 1)), light_colour(s.l) * s.gain);
    }
}

/// An image of one colour.
std::string image_of(const Rgb& colour, int width, int height) {
    static const files::TemporaryFolder folder;
    static int count = 0;
    std::string path = folder / (std::to_string(++count) + ".exr");
    const std::vector<Rgb> pixels(std::size_t(width) * height, colour);
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file &&
                file->open(path, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)) &&
                file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && file->close());
    return path;
}

// A pixel is a reflectance under the light of L.
TEST(LightFormulas, InfiniteWithAMap) {
    const std::array<Rgb, 10> pixels = {
        Rgb(0.5f),          Rgb(1, 0, 0),         Rgb(0, 1, 0),       Rgb(0, 0, 1),
        Rgb(1, 0.2f, 0.2f), Rgb(0.2f, 1, 0.1f),   Rgb(0.1f, 0.4f, 2), Rgb(1, 0.9f, 0.2f),
        Rgb(3, 0.5f, 2),    Rgb(0.1f, 0.8f, 0.7f)};
    const std::array<const char*, 3> mappings = {"latlong", "angular", "vcross"};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        SCOPED_TRACE(i);
        const Rgb l = i % 2 == 0 ? Rgb(1.0f) : kSettings[i].l;
        const auto light = make_one(
            "infinite",
            {text("mapname", image_of(pixels[i], 12, 16)), text("mapping", mappings[i % 3]),
             numbers("color", "L", {l.x, l.y, l.z}), numbers("float", "gain", {1 + double(i)})});
        const Curve under = illuminant(l), through = filter(pixels[i]);
        const Imath::V3d published =
            scene_rgb(film_xyz([&](double nm) { return under(nm) * through(nm); }));
        expect_light(light->escaped(Vec3(-0.5f, 0.3f, 0.4f).normalized()),
                     published * (1 + double(i)));
    }
}

// The map tells where light goes, L how much there is.
TEST(LightFormulas, Goniometric) {
    for (const Setting& s : kSettings) {
        SCOPED_TRACE(s.l);
        std::vector<ParameterValue> values = values_of(s);
        values.push_back(text("iesname", wall_washer()));
        const auto light = make_one("goniometric", values);
        const double flux = s.power * s.efficacy > 0 ? s.gain * s.power * s.efficacy
                                                     : 4 * kPi * s.gain * light_luminance(s.l);
        EXPECT_NEAR(light->power() / flux, 1, 0.01);
    }
}

// L * gain lumens over the image's area at distance 1, evenly: by the cosine's cube per steradian.
TEST(LightFormulas, Projection) {
    for (std::size_t i = 0; i < kSettings.size(); ++i) {
        const Setting& s = kSettings[i];
        SCOPED_TRACE(i);
        const int width = 4 + 2 * int(i % 3), height = 8 - 2 * int(i % 3);
        const double fov = 20 + 10 * double(i), aspect = double(width) / height;
        std::vector<ParameterValue> values = values_of(s);
        values.resize(2);
        values.push_back(numbers("float", "fov", {fov}));
        values.push_back(text("mapname", image_of(Rgb(0.5f), width, height)));
        const auto light = make_one("projection", values);
        const double opposite = std::tan(fov * kPi / 360);
        const double area = 4 * opposite * opposite / aspect;
        const double aside = 0.7 * opposite;
        const double distance2 = 1 + aside * aside, cosine = 1 / std::sqrt(distance2);
        expect_light(
            irradiance_at(*light, Vec3(0, float(aside), 1)),
            light_colour(s.l) * (s.gain * 0.5 / (area * cosine * cosine * cosine) / distance2));
    }
}

TEST(LightFormulas, Area) {
    for (const Setting& s : kSettings) {
        SCOPED_TRACE(s.l);
        Primitive lamp = emissive(parallelogram(Vec3(0.0f), Vec3(2, 0, 0), Vec3(0, 3, 0)), s.l);
        lamp.emission->gain = float(s.gain);
        lamp.emission->power = float(s.power);
        lamp.emission->efficacy = float(s.efficacy);
        const auto light = make_area_light(lamp, Matrix());
        const auto& area = dynamic_cast<const AreaLight&>(*light);
        expect_light(area.radiance(Vec3(1, 1, 0), Vec3(0, 0, 1), Vec2(0.5f), Vec3(0, 0, 1)),
                     light_colour(s.l) * gain_of(s, kPi * 6));
    }
}

}  // namespace
}  // namespace lxs::test::light_formulas_test
