// Protects lights at a point that follow an image or a photometric file: intensities where they are
// known, flux, and densities that match what is drawn.
#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <numbers>

#include "emission_profile.h"
#include "environment_layout.h"
#include "latlong_coordinates.h"
#include "light_cases.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "photometric_file.h"
#include "temporary_folder.h"

namespace lxs::test::profile_light_test {
namespace {

constexpr double kPiD = std::numbers::pi;

const files::TemporaryFolder& folder() {
    static const files::TemporaryFolder made;
    return made;
}

std::string photometric_file(const std::string& name, const std::string& content) {
    return folder().write(name, content);
}

/// Axially symmetric, cosine-like: 100 cd straight down, 50 at 60 degrees, 0 from 90 on.
std::string downlight() {
    return photometric_file("down.ies",
                            "IESNA:LM-63-1995\r\n[TEST] one\r\nTILT=NONE\r\n"
                            "1 1000 2.0 4 1 1 2 0 0 0\r\n1.0 1.0 60\r\n"
                            "0 30, 60 90\r\n0\r\n50 43.301 25\r\n0\r\n");
}

Rgb direct(const Light& light, const Vec3& p) {
    DirectSample s;
    if (!light.sample_direct(p, Vec3(0, 0, 1), Vec2(0.5f), s)) return Rgb(0.0f);
    return s.radiance;
}

PhotometricWeb web_of(const std::string& content) {
    return parse_photometric_text(content, "test", {});
}

std::string error_of(const std::string& content) {
    try {
        web_of(content);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(PhotometricFile, IsReadAsTheStandardLaysIt) {
    const PhotometricWeb web = read_photometric_file(downlight(), {});
    EXPECT_EQ(web.largest(), 100);
    EXPECT_DOUBLE_EQ(web.intensity(60, 123), 50);
    EXPECT_NEAR(web.intensity(45, 0), (86.602 + 50) / 2, 1e-9);
    EXPECT_EQ(web.intensity(120, 0), 0);
}

TEST(PhotometricFile, HorizontalAnglesAreMirroredAsTheirRangeSays) {
    const std::string head = "TILT=INCLUDE\n1\n2\n0 90\n1 1\n1 -1 1 2 ";
    const std::string middle = " 1 1 0 0 0 1 1 0\n0 90\n";
    const PhotometricWeb quadrant = web_of(head + "2" + middle + "0 90\n10 10 20 20");
    for (const double h : {30.0, 150.0, 210.0, 330.0, -30.0})
        EXPECT_NEAR(quadrant.intensity(45, h), 10 + 10.0 / 3, 1e-9) << h;
    const PhotometricWeb half = web_of(head + "2" + middle + "0 180\n10 10 20 20");
    EXPECT_NEAR(half.intensity(45, 270), 15, 1e-9);
    EXPECT_NEAR(half.intensity(45, 180), 20, 1e-9);
    const PhotometricWeb full = web_of(head + "3" + middle + "0 180 360\n10 10 20 20 10 10");
    EXPECT_NEAR(full.intensity(45, 270), 15, 1e-9);
    const PhotometricWeb sides = web_of(head + "2" + middle + "90 270\n10 10 20 20");
    EXPECT_NEAR(sides.intensity(45, 0), sides.intensity(45, 180), 1e-9);
    EXPECT_NEAR(sides.intensity(45, 300), sides.intensity(45, 240), 1e-9);
}

TEST(PhotometricFile, WhatIsBrokenIsSaid) {
    EXPECT_NE(error_of("no tilt").find("no line TILT="), std::string::npos);
    EXPECT_NE(error_of("TILT=NONE\n1 1 1 0 1 1").find("number of vertical angles is 0"),
              std::string::npos);
    EXPECT_NE(error_of("TILT=NONE\n1 1 1 1 1 2").find("only type C"), std::string::npos);
    EXPECT_NE(error_of("TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 0\n0 90\n0\n5")
                  .find("a candela value is missing"),
              std::string::npos);
    EXPECT_NE(
        error_of("TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 0\n90 0\n0\n5 5").find("angles don't rise"),
        std::string::npos);
    EXPECT_THROW(make_one("point", {text("iesname", "/no/such/file.ies")}), InputError);
}

TEST(ProfileLight, PhotometricFileShapesAPointLight) {
    const auto light =
        make_one("point", {text("iesname", downlight()), numbers("color", "L", {40, 40, 40})});
    EXPECT_EQ(light->kind(), "goniometric");
    // As many lumens as L everywhere: about a cosine, of pi for 4 pi; half of it at 60 degrees.
    EXPECT_NEAR(light->power() / (40 * 4 * kPiD), 1, 1e-3);
    const float ahead = direct(*light, Vec3(0, 0, 2)).y * 4;
    EXPECT_NEAR(ahead / 160, 1 / 0.97, 0.03);  // less what straight lines between angles lose
    const Vec3 aside(float(std::sin(kPiD / 3)), 0, 0.5f);
    EXPECT_NEAR(direct(*light, aside).y / ahead, 0.5, 0.005);
    EXPECT_TRUE(is_black(direct(*light, Vec3(0, 0.1f, -1))));
    const auto flipped =
        make_one("point", {text("iesname", downlight()),
                           ParameterValue{"bool", "flipz", std::vector<bool>{true}, {}, {}},
                           numbers("color", "L", {40, 40, 40})});
    EXPECT_TRUE(is_black(direct(*flipped, Vec3(0, 0.1f, 1))));
    EXPECT_FLOAT_EQ(direct(*flipped, Vec3(0, 0, -2)).y * 4, ahead);
}

TEST(ProfileLight, PowerAndEfficacySetTheFlux) {
    for (const char* plugin : {"goniometric", "projection"}) {
        const auto light = make_one(
            plugin, {text("mapname", probe_image()), numbers("float", "power", {50}),
                     numbers("float", "efficacy", {12}), numbers("color", "L", {3, 2, 1})});
        EXPECT_NEAR(light->power(), 600, 0.6) << plugin;
    }
}

/// The flux of photons is the integral of the intensity, however it is drawn.
TEST(ProfileLight, PhotonsCarryTheFlux) {
    for (const char* plugin : {"goniometric", "projection"}) {
        const auto light =
            make_one(plugin, {text("mapname", probe_image()), numbers("point", "from", {1, 2, 3}),
                              numbers("point", "to", {0, 1, 2})});
        Random random(5);
        double sum = 0;
        constexpr int kPhotons = 200000;
        for (int i = 0; i < kPhotons; ++i) {
            EmissionSample s;
            if (light->sample_emission({0.5f, 0.5f, random(), random()}, s))
                sum += luminance(s.power) / kPhotons;
        }
        EXPECT_NEAR(sum / light->power(), 1, 0.02) << plugin;
    }
}

std::string quadrants() {
    constexpr int kSide = 8;
    std::vector<float> pixels;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            pixels.push_back(x < kSide / 2 ? 1.0f : 2.0f);
            pixels.push_back(y < kSide / 2 ? 3.0f : 5.0f);
            pixels.push_back(0.5f);
        }
    }
    std::string path = folder() / "quadrants.exr";
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file && file->open(path, OIIO::ImageSpec(kSide, kSide, 3, OIIO::TypeDesc::FLOAT)) &&
                file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && file->close());
    return path;
}

TEST(ProjectionLight, ThrowsItsImageWithinItsAngle) {
    const auto light =
        make_one("projection", {text("mapname", quadrants()), numbers("float", "fov", {90})});
    // From the origin along +z: rows along +y, columns along -x.
    // On a screen at distance 1, of area 4: the image over the area, whatever the angle.
    const auto at = [&](float row, float column) {
        const Vec3 p(-column, row, 1);
        return direct(*light, p) / p.length();
    };
    const auto expect_near = [](const Rgb& found, const Rgb& pixel) {
        const Rgb expected = colour_of_filtered_illuminant(pixel, Rgb(1.0f)) / 4;
        EXPECT_NEAR((found - expected).length(), 0, 1e-3) << found;
    };
    // The cosine from the axis once for the screen, which arriving light lacks: hence p.length().
    expect_near(at(-0.5f, -0.5f), Rgb(1, 3, 0.5f));
    expect_near(at(0.5f, -0.5f), Rgb(2, 3, 0.5f));
    expect_near(at(-0.5f, 0.5f), Rgb(1, 5, 0.5f));
    EXPECT_TRUE(is_black(at(1.01f, 0)));
    EXPECT_TRUE(is_black(at(0, -1.01f)));
    EXPECT_TRUE(is_black(direct(*light, Vec3(0, 0, -1))));
}

/// Directions are drawn with the density that they claim: its integral over what is drawn is 1, and
/// the inverse leads back.
TEST(EmissionProfile, DensitiesAndInverses) {
    RecordedDiagnostics diagnostics;
    LatLongMap image = LatLongMap::read(probe_image(), StoredCurve{}, {}, diagnostics);
    const SphereProfile sphere(Rotation(translation(0, 0, 0), {}), image);
    const ScreenProfile screen(Frame(Vec3(0.6f, 0, 0.8f)), image, 1.2f, false);
    const ScreenProfile plain(Frame(Vec3(0.6f, 0, 0.8f)), image, 1.2f, true);
    for (const EmissionProfile* profile : {static_cast<const EmissionProfile*>(&sphere),
                                           static_cast<const EmissionProfile*>(&screen),
                                           static_cast<const EmissionProfile*>(&plain)}) {
        Random random(7);
        double integral = 0;
        constexpr int kDraws = 100000;
        for (int i = 0; i < kDraws; ++i) {
            Vec3 w;
            const Vec2 u(random(), random());
            const float density = profile->sample(u, w);
            ASSERT_GT(density, 0);
            integral += luminance(profile->at(w)) / density / kDraws;
            Vec2 back;
            if (i > 1000 || !profile->coordinates(w, back)) continue;
            EXPECT_NEAR(back.x, u.x, 2e-3);
            EXPECT_NEAR(back.y, u.y, 2e-3);
        }
        EXPECT_NEAR(integral / luminance(profile->integral()), 1, 0.01);
    }
}

/// An image whose colour at a pixel is the direction that the layout says it shows.
LatLongMap directions_as(const std::string& mapping, std::size_t width, std::size_t height) {
    return LatLongMap::of(width, height, [&](const Vec2& st) {
        Vec3 w(0, 0, 1);
        const float x = 2 * st.x - 1, y = 2 * st.y - 1;
        if (mapping == "angular") {
            const float r = std::hypot(x, y), angle = kPi * r;
            if (r > 1) return Rgb(0.5f);
            w = Vec3(-std::cos(angle), -x / r * std::sin(angle), -y / r * std::sin(angle));
        } else if (mapping == "equalarea") {
            // Clarberg 2008, equations 7 and 8.
            const float u = std::abs(x), v = std::abs(y), upper = 1 - (u + v);
            const float r = 1 - std::abs(upper);
            const float phi = (r > 0 ? (v - u) / r + 1 : 1) * kPi / 4;
            const float sine = r * std::sqrt(std::max(0.0f, 2 - r * r));
            w = Vec3(std::copysign(std::cos(phi) * sine, x), std::copysign(std::sin(phi) * sine, y),
                     std::copysign(1 - r * r, upper));
        } else {
            const int column = std::min(int(st.x * 3), 2), row = std::min(int(st.y * 4), 3);
            const float a = 2 * (st.x * 3 - float(column)) - 1, b = 2 * (st.y * 4 - float(row)) - 1;
            if (column == 0 && row == 1) w = Vec3(-a, 1, -b);
            if (column == 2 && row == 1) w = Vec3(a, -1, -b);
            if (column == 1 && row == 0) w = Vec3(-b, -a, 1);
            if (column == 1 && row == 1) w = Vec3(-1, -a, -b);
            if (column == 1 && row == 2) w = Vec3(b, -a, -1);
            if (column == 1 && row == 3) w = Vec3(1, -a, b);
        }
        return Rgb((w.normalized() + Vec3(1.0f)) / 2.0f);
    });
}

class Layout : public testing::TestWithParam<std::string> {};

TEST_P(Layout, EveryDirectionIsFoundWhereTheLayoutShowsIt) {
    const bool cross = GetParam() == "vcross";
    const LatLongMap map =
        as_latlong(directions_as(GetParam(), cross ? 192 : 256, 256), GetParam());
    Random random(11);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 w = latlong_direction(Vec2(random(), random()));
        if (!cross && w.x > 0.99f) continue;  // one point of an angular map's rim
        const Vec3 found = Vec3(map.lookup(latlong_coordinates(w))) * 2.0f - Vec3(1.0f);
        EXPECT_LT((found - w).length(), 0.06f) << w;
    }
}

INSTANTIATE_TEST_SUITE_P(Mappings, Layout, testing::Values("angular", "vcross", "equalarea"));

}  // namespace
}  // namespace lxs::test::profile_light_test
