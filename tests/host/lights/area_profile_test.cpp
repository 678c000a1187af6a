// Protects area lights with a photometric file or an image: intensities where they are known, flux,
// sides and axes, and photons drawn with the density that their power is divided by. How they
// agree with direct light, and with their inverse, is tested beside all other lights.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "chi_square.h"
#include "light_cases.h"
#include "photometric_file.h"
#include "temporary_folder.h"

namespace lxs::test::area_profile_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadians = kPi / 180;

using Values = std::vector<ParameterValue>;

ParameterValue flag(const std::string& name) {
    return {"bool", name, std::vector<bool>{true}, {}, {}};
}

/// A photometric file of 1 cd between two vertical angles, in degrees, whatever the azimuth.
std::string even(double from, double to) {
    static const files::TemporaryFolder folder;
    const std::string angles = std::to_string(from) + " " + std::to_string(to);
    return folder.write(angles + ".ies",
                        "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 1\n" + angles + "\n0\n1 1\n");
}

/// A square around the origin that faces +z.
Primitive square(float side, const Rgb& radiance) {
    return emissive(
        parallelogram(Vec3(-side / 2, -side / 2, 0), Vec3(side, 0, 0), Vec3(0, side, 0)), radiance);
}

/// Mean irradiance on a surface at `p` that faces `n`, from a grid of light points.
double irradiance(const Light& light, const Vec3& p, const Vec3& n, std::size_t side) {
    double sum = 0;
    for (std::size_t i = 0; i < side * side; ++i) {
        const auto middle = [&](std::size_t cell) {
            return (static_cast<float>(cell) + 0.5f) / static_cast<float>(side);
        };
        DirectSample s;
        if (light.sample_direct(p, n, Vec2(middle(i % side), middle(i / side)), s))
            sum += double(s.radiance.y) * std::max(0.0f, s.wi ^ n) / s.pdf;
    }
    return sum / static_cast<double>(side * side);
}

Vec3 direction(double vertical_deg, double horizontal_deg) {
    const double theta = vertical_deg * kRadians, phi = horizontal_deg * kRadians;
    return Vec3(Imath::V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                           std::cos(theta)));
}

/// `direction` in the axes that `m` turns the shape's into.
Vec3 turned(const Vec3& direction, const Matrix& m) {
    Imath::V3d result;
    m.multDirMatrix(Imath::V3d(direction), result);
    return Vec3(result);
}

/// Integral of the file's intensities over the front half of all directions.
double front_flux(const PhotometricWeb& web) {
    constexpr int kSteps = 360;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double vertical = 90 * (i + 0.5) / kSteps;
        for (int j = 0; j < kSteps; ++j)
            sum +=
                std::sin(vertical * kRadians) * web.intensity(vertical, 360 * (j + 0.5) / kSteps);
    }
    return sum * (kPi / 2 / kSteps) * (2 * kPi / kSteps);
}

// A patch of area A sends the intensity A L pi I / F, I being the file's and F its flux in front; a
// wall across a ray of length d is lit by that over d^2. The profile's axes are those of shape and
// instance.
TEST(AreaProfile, ASmallPatchHasTheFilesIntensities) {
    constexpr float kSide = 1e-3f;
    constexpr double kRadiance = 7e6;
    const PhotometricWeb web = read_photometric_file(wall_washer(), {});
    const double scale = kPi / front_flux(web);
    const Matrix about_z = Matrix().setEulerAngles(Imath::V3d(0, 0, 0.7));
    const Matrix tilted = Matrix().setEulerAngles(Imath::V3d(0.5, 1.1, -2));
    const std::vector<std::pair<Matrix, Matrix>> placements = {
        {Matrix(), Matrix()},  // of the shape within its object, and of the object
        {about_z, Matrix()},  {Matrix(), tilted},
        {about_z, tilted},    {Matrix(), scaling(1, -1, 1) * tilted},
    };
    for (const auto& [shape, object] : placements) {
        Primitive primitive = square(kSide, Rgb(float(kRadiance)));
        primitive.to_world = shape;
        const auto light =
            make_area_light(profiled(primitive, {text("iesname", wall_washer())}), object);
        for (const double vertical : {0.0, 15.0, 45.0, 75.0, 85.0}) {
            for (const double horizontal : {20.0, 70.0, 100.0, 200.0, 330.0}) {
                const Vec3 w = turned(direction(vertical, horizontal), shape * object);
                const double expected =
                    kSide * kSide * kRadiance * scale * web.intensity(vertical, horizontal) / 4;
                EXPECT_NEAR(irradiance(*light, w * 2.0f, -w, 4) / expected, 1, 0.01)
                    << vertical << " " << horizontal;
            }
        }
    }
}

/// What gives even intensities the flux of a diffuse surface: pi over the integral of
/// min(1, cosine / 0.01) over the half sphere.
constexpr double kEvenScale = 0.5 / 0.995;

// An even file: each piece of the disk shines alike into all directions, unlike a diffuse one, so
// that a wall before it sees 2 pi L s (1 - h / sqrt(R^2 + h^2)).
TEST(AreaProfile, EvenIntensitiesOfADisk) {
    const auto light =
        make_area_light(profiled(emissive(placed(Disk{0, 2, 0, 360}, Matrix()), Rgb(3.0f)),
                                 {text("iesname", even(0, 180))}),
                        Matrix());
    for (const float h : {0.5f, 1.0f, 3.0f}) {
        const double expected =
            2 * kPi * 3 * kEvenScale * (1 - double(h) / std::hypot(2.0, double(h)));
        EXPECT_NEAR(irradiance(*light, Vec3(0, 0, h), Vec3(0, 0, -1), 128) / expected, 1, 1e-3);
    }
    EXPECT_NEAR(light->power() / luminance(Rgb(3.0f)) / (kPi * kPi * 4), 1, 1e-3)
        << "as a diffuse disk's";
}

TEST(AreaProfile, ShinesFromTheFrontAndFlips) {
    const auto shines = [](const Values& values, float z) {
        const auto light = make_area_light(profiled(square(1, Rgb(1.0f)), values), Matrix());
        return irradiance(*light, Vec3(0.1f, 0.2f, z), Vec3(0, 0, -z), 8) > 0;
    };
    for (const Values& both : {Values{text("iesname", even(0, 180))},
                               Values{text("iesname", even(0, 180)), flag("flipz")}}) {
        EXPECT_TRUE(shines(both, 1));
        EXPECT_FALSE(shines(both, -1));
    }
    EXPECT_TRUE(shines({text("iesname", even(0, 80))}, 1));
    EXPECT_FALSE(shines({text("iesname", even(0, 80)), flag("flipz")}, 1));
    EXPECT_FALSE(shines({text("iesname", even(100, 180))}, 1));
    EXPECT_TRUE(shines({text("iesname", even(100, 180)), flag("flipz")}, 1));
}

// Nothing of what a file has just behind the horizon may shine in front: with power and efficacy
// that would be all of the light.
TEST(AreaProfile, OneThatIsDarkInFrontIsSaid) {
    for (const Values& behind :
         {Values{text("iesname", even(90.1, 180))},
          Values{text("iesname", wall_washer()), flag("flipz")},
          Values{text("iesname", wall_washer()), text("mapname", probe_image()), flag("flipz")}}) {
        RecordedDiagnostics diagnostics;
        const auto light =
            make_area_light(profiled(square(1, Rgb(1.0f)), behind, diagnostics), Matrix());
        EXPECT_EQ(diagnostics.warnings.size(), 1u);
        EXPECT_EQ(light->power(), 0);
        EmissionSample s;
        EXPECT_FALSE(light->sample_emission({0.3f, 0.4f, 0.5f, 0.6f}, s));
    }
    EXPECT_THROW(profiled(square(1, Rgb(1.0f)), {text("iesname", "/no/such/file.ies")}),
                 InputError);
}

// The radiance grows as the surface is seen edge-on, and ends at 100 times that of the normal.
TEST(AreaProfile, GrazingRadianceIsBounded) {
    const auto light =
        make_area_light(profiled(square(1, Rgb(1.0f)), {text("iesname", even(0, 180))}), Matrix());
    const auto& area = dynamic_cast<const AreaLight&>(*light);
    const auto seen = [&](double vertical) {
        return area.radiance(Vec3(0.0f), Vec3(0, 0, 1), Vec2(0.0f), direction(vertical, 50)).y;
    };
    EXPECT_NEAR(seen(0), kEvenScale, 1e-4);
    EXPECT_NEAR(seen(80) * std::cos(80 * kRadians) / kEvenScale, 1, 1e-3);
    EXPECT_NEAR(seen(89.9) / kEvenScale, 100, 0.1);
    EXPECT_LE(seen(89.9999) / kEvenScale, 100.02);
}

/// Radiance that grows along u.
class Ramp final : public ColorTexture {
  public:
    Rgb evaluate(const TexturePoint& point) const override { return Rgb(2 * point.uv.x, 1, 1); }
};

std::vector<Primitive> shapes() {
    TriangleMesh mesh = parallelogram(Vec3(0.0f), Vec3(2, 0, 0), Vec3(0.5f, 1, 0.3f));
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    std::vector<Primitive> all = {
        emissive(mesh, Rgb(3, 2, 1)), emissive(placed(Sphere{1, -1, 1, 360}, Matrix()), Rgb(1.0f)),
        emissive(placed(Sphere{1, -0.3f, 1, 200}, scaling(1, 2, 1)), Rgb(1.0f)),
        emissive(placed(Disk{0, 1, 0.2f, 300}, translation(1, 2, 3)), Rgb(1.0f)),
        emissive(placed(RevolvedSegment{Vec3(1, 0, 0), Vec3(1, 0, 1), 360}, Matrix()), Rgb(1.0f))};
    all.push_back(all.front());
    all.back().emission->radiance = std::make_shared<Ramp>();
    return all;
}

std::vector<Values> profiles() {
    return {{text("iesname", wall_washer())},
            {text("mapname", probe_image()), flag("flipz")},
            {text("mapname", probe_image()), text("iesname", wall_washer())}};
}

/// An image whose middle row the horizon cuts.
std::string odd_image() {
    static const files::TemporaryFolder folder;
    return folder.write("odd.ppm",
                        "P3 2 3 255\n9 99 9 200 50 20\n80 20 60 250 9 0\n0 0 255 0 255 0\n");
}

double emitted_power(const Light& light) {
    Random random(23);
    double sum = 0;
    constexpr int kPhotons = 20000;
    for (int i = 0; i < kPhotons; ++i) {
        EmissionSample s;
        if (light.sample_emission({random(), random(), random(), random()}, s))
            sum += luminance(s.power) / kPhotons;
    }
    return sum;
}

// power() is what the photons carry, and power times efficacy where the scene gives both.
TEST(AreaProfile, PhotonsCarryThePower) {
    std::vector<Values> all = profiles();
    all.push_back({text("mapname", odd_image())});
    for (const Values& values : all) {
        const auto profile = profiled(square(1, Rgb(1.0f)), values).emission->profile;
        for (Primitive primitive : shapes()) {
            primitive.emission->profile = profile;
            const auto by_radiance = make_area_light(primitive, Matrix());
            EXPECT_NEAR(emitted_power(*by_radiance) / by_radiance->power(), 1, 0.015);
            primitive.emission->power = 100;
            primitive.emission->efficacy = 17;
            const auto by_flux = make_area_light(primitive, Matrix());
            EXPECT_NEAR(by_flux->power() / 1700, 1, 1e-4);
            EXPECT_NEAR(emitted_power(*by_flux) / 1700, 1, 0.015);
        }
    }
}

constexpr std::size_t kCosines = 10, kAzimuths = 12;
constexpr int kSamples = 40000;

std::size_t cell_of(const Vec3& w) {
    const double turns = std::atan2(w.y, w.x) / (2 * kPi);
    const auto column =
        std::min(kAzimuths - 1, std::size_t((turns < 0 ? turns + 1 : turns) * kAzimuths));
    return std::min(kCosines - 1, std::size_t(w.z * kCosines)) * kAzimuths + column;
}

/// Directions a steradian that a photon is drawn with, by its power: L cos / (power * area).
double stated_density(const Light& light, const Vec3& w) {
    DirectSample at_origin;
    at_origin.wi = -w;
    PrimaryPoint u{};
    EmissionSample photon;
    if (!light.emission_coordinates(w, at_origin, u) || !light.sample_emission(u, photon)) return 0;
    const auto& area = dynamic_cast<const AreaLight&>(light);
    const Vec3 drawn = photon.ray.direction;
    const Rgb seen = area.radiance(Vec3(0.0f), Vec3(0, 0, 1), Vec2(0.0f), drawn);
    return luminance(seen) * drawn.z / luminance(photon.power);
}

std::vector<double> stated_shares(const Light& light) {
    constexpr int kSub = 4000;
    std::vector<double> shares(kCosines * kAzimuths + 1, 0.0);
    Random random(7);
    for (std::size_t cell = 0; cell < kCosines * kAzimuths; ++cell) {
        const std::size_t column = cell % kAzimuths, row = cell / kAzimuths;
        for (int i = 0; i < kSub; ++i) {
            const double z = (double(row) + (i + random()) / kSub) / kCosines;
            const double phi = (double(column) + random()) / kAzimuths * 2 * kPi;
            const double sine = std::sqrt(1 - z * z);
            const Vec3 w(Imath::V3d(sine * std::cos(phi), sine * std::sin(phi), z));
            shares[cell] += stated_density(light, w) * 2 * kPi / (kCosines * kAzimuths * kSub);
        }
    }
    return shares;
}

// What a photon's power is divided by is what its direction is drawn with; the inverse leads there,
// and no number is lost on directions behind the surface.
// Family-wise significance 1 %, fixed seeds.
TEST(AreaProfile, DirectionsFollowTheStatedDensity) {
    for (const Values& profile : profiles()) {
        const auto light = make_area_light(profiled(square(1, Rgb(1.0f)), profile), Matrix());
        std::vector<double> counts(kCosines * kAzimuths + 1, 0.0);
        Random random(11);
        for (int i = 0; i < kSamples; ++i) {
            EmissionSample s;
            const bool drawn = light->sample_emission({0.5f, 0.5f, random(), random()}, s);
            ++counts[drawn ? cell_of(s.ray.direction) : counts.size() - 1];
        }
        EXPECT_GT(chi_square_p(counts, stated_shares(*light), kSamples), one_of(profiles().size()));
    }
}

}  // namespace
}  // namespace lxs::test::area_profile_test
