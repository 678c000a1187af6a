// Area lights: flux, units, sidedness and textured emission.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "light_cases.h"
#include "lxs/spectrum/rgb_spectra.h"

namespace lxs::test::area_light_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Mean luminance-weighted power of the light's photons.
double emitted_power(const Light& light, int count = 20000) {
    Random random(23);
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        EmissionSample s;
        if (light.sample_emission({random(), random(), random(), random()}, s))
            sum += luminance(s.power);
    }
    return sum / count;
}

/// Radiance that grows along u.
class Ramp final : public ColorTexture {
  public:
    Rgb evaluate(const TexturePoint& point) const override { return Rgb(2 * point.uv.x); }
};

TEST(AreaLight, PowerIsPiTimesAreaTimesRadiance) {
    const Rgb radiance(9, 8, 7);
    const double l = luminance(colour_of_illuminant(radiance));
    const auto mesh = make_area_light(
        emissive(parallelogram(Vec3(0.0f), Vec3(2, 0, 0), Vec3(0, 3, 0)), radiance), Matrix());
    EXPECT_NEAR(mesh->power(), kPi * 6 * l, 1e-3);
    EXPECT_NEAR(emitted_power(*mesh), kPi * 6 * l, 1e-2);
    const auto sphere = make_area_light(
        emissive(placed(Sphere{0.5f, -0.5f, 0.5f, 360}, scaling(2, 2, 2)), radiance), Matrix());
    EXPECT_NEAR(sphere->power() / (kPi * 4 * kPi * l), 1, 1e-5);
    EXPECT_NEAR(emitted_power(*sphere) / (kPi * 4 * kPi * l), 1, 1e-5);
    const auto disk =
        make_area_light(emissive(placed(Disk{0, 2, 1, 90}, Matrix()), radiance), Matrix());
    EXPECT_NEAR(disk->power() / (kPi * 0.75 * kPi * l), 1, 1e-5);
    EXPECT_NEAR(emitted_power(*disk) / (kPi * 0.75 * kPi * l), 1, 1e-5);
}

// An oblate spheroid's area has a closed form; the light integrates it numerically.
TEST(AreaLight, StretchedSphere) {
    const double a = 1, c = 0.5, e = std::sqrt(1 - c * c / (a * a));
    const double area = 2 * kPi * a * a * (1 + (1 - e * e) / e * std::atanh(e));
    const auto light = make_area_light(
        emissive(placed(Sphere{1, -1, 1, 360}, scaling(a, a, c)), Rgb(1.0f)), Matrix());
    EXPECT_NEAR(light->power() / (kPi * area), 1, 1e-3);
    EXPECT_NEAR(emitted_power(*light) / (kPi * area), 1, 1e-2);
}

// LuxRender: power * efficacy lumens, whatever L's brightness and the shape's size; gain scales.
TEST(AreaLight, PowerAndEfficacySetTheFlux) {
    Primitive primitive =
        emissive(placed(Sphere{0.4f, -0.4f, 0.4f, 360}, Matrix()), Rgb(20, 10, 5));
    primitive.emission->power = 100;
    primitive.emission->efficacy = 17;
    EXPECT_NEAR(make_area_light(primitive, Matrix())->power() / 1700, 1, 1e-4);
    EXPECT_NEAR(make_area_light(primitive, scaling(3, 3, 3))->power() / 1700, 1, 1e-4);
    primitive.emission->gain = 50;
    EXPECT_NEAR(make_area_light(primitive, Matrix())->power() / 85000, 1, 1e-4);
    primitive.emission->efficacy = 0;
    const double scaled =
        50 * luminance(colour_of_illuminant(Rgb(20, 10, 5))) * kPi * 4 * kPi * 0.16;
    EXPECT_NEAR(make_area_light(primitive, Matrix())->power() / scaled, 1, 1e-4);
}

// The radiance that LuxRender 1.9's image of this lamp implies (its default 100 W at 17 lm/W).
TEST(AreaLight, RadianceOfLuxRendersSphere) {
    Primitive primitive = emissive(placed(Sphere{0.4f, -0.4f, 0.4f, 360}, Matrix()), Rgb(20.0f));
    primitive.emission->power = 100;
    primitive.emission->efficacy = 17;
    const auto light = make_area_light(primitive, Matrix());
    const auto& area = dynamic_cast<const AreaLight&>(*light);
    const Rgb l = area.radiance(Vec3(0, 0, 0.4f), Vec3(0, 0, 1), Vec2(0.0f), Vec3(0, 0, 1));
    EXPECT_NEAR(l.y / 269.1, 1, 0.01);
}

TEST(AreaLight, EmitsFromTheFrontOnly) {
    const auto mesh = parallelogram(Vec3(-1, -1, 0.3f), Vec3(2, 0, 0), Vec3(0, 2, 0));
    for (const bool reversed : {false, true}) {
        for (const bool mirrored : {false, true}) {
            Primitive primitive = emissive(mesh, Rgb(1.0f));
            primitive.reverse_orientation = reversed;
            // A mirroring in x leaves the plane and its front where they are.
            const auto light = make_area_light(primitive, mirrored ? scaling(-1, 1, 1) : Matrix());
            const float front = reversed ? -1.0f : 1.0f;
            DirectSample d;
            EXPECT_TRUE(light->sample_direct(Vec3(0, 0, 2 * front), {}, Vec2(0.3f, 0.4f), d));
            EXPECT_FALSE(light->sample_direct(Vec3(0, 0, -2 * front), {}, Vec2(0.3f, 0.4f), d));
            EmissionSample e;
            ASSERT_TRUE(light->sample_emission({0.3f, 0.4f, 0.2f, 0.6f}, e));
            EXPECT_GT(e.ray.direction.z * front, 0);
            EXPECT_GT((e.ray.origin.z - 0.3f) * front, 0) << "must start off the surface";
            EXPECT_EQ(e.normal, Vec3(0, 0, front));
            const auto& area = dynamic_cast<const AreaLight&>(*light);
            const Vec3 n(0, 0, front);
            EXPECT_FALSE(is_black(area.radiance(Vec3(0.0f), n, Vec2(0.0f), n)));
            EXPECT_TRUE(is_black(area.radiance(Vec3(0.0f), n, Vec2(0.0f), -n)));
        }
    }
}

TEST(AreaLight, TexturedRadiance) {
    TriangleMesh mesh = parallelogram(Vec3(0.0f), Vec3(1, 0, 0), Vec3(0, 1, 0));
    mesh.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    Primitive primitive = emissive(mesh, Rgb(1.0f));
    primitive.emission->radiance = std::make_shared<Ramp>();
    const auto light = make_area_light(primitive, Matrix());
    EXPECT_NEAR(light->power(), kPi, 0.05);
    EXPECT_NEAR(emitted_power(*light), kPi, 0.05);
    EmissionSample e;
    ASSERT_TRUE(light->sample_emission({0.9f, 0.3f, 0.5f, 0.5f}, e));
    EXPECT_NEAR(e.power.x, 2 * e.ray.origin.x * kPi, 1e-4);
}

/// Radiance that grows along x of the shape's own space.
class LocalRamp final : public ColorTexture {
  public:
    Rgb evaluate(const TexturePoint& point) const override {
        Vec3 local = point.p;
        if (point.object_to_shape) local = local * *point.object_to_shape;
        return Rgb(local.x);
    }
};

TEST(AreaLight, TexturesLieInTheSpaceOfTheShape) {
    Primitive primitive = emissive(placed(Disk{0, 2, 0, 360}, scaling(3, 3, 3)), Rgb(1.0f));
    primitive.to_world = scaling(3, 3, 3);
    primitive.emission->radiance = std::make_shared<LocalRamp>();
    const auto light = make_area_light(primitive, Matrix());
    EXPECT_NEAR(luminance(light->radiance({4.5f, 0, 0}, {0, 0, 1}, {0, 0}, {0, 0, 1})), 1.5, 1e-5);
}

TEST(AreaLight, ManyTrianglesAreChosenByArea) {
    TriangleMesh mesh = parallelogram(Vec3(0.0f), Vec3(1, 0, 0), Vec3(0, 1, 0));
    const TriangleMesh wide = parallelogram(Vec3(5, 0, 0), Vec3(3, 0, 0), Vec3(0, 1, 0));
    mesh.positions.insert(mesh.positions.end(), wide.positions.begin(), wide.positions.end());
    for (const std::uint32_t i : wide.indices)
        mesh.indices.push_back(i + 4);
    mesh.indices.insert(mesh.indices.end(), {0, 0, 0});  // a needle of no area
    const auto light = make_area_light(emissive(mesh, Rgb(1.0f)), Matrix());
    Random random(29);
    int on_wide = 0;
    constexpr int kCount = 40000;
    for (int i = 0; i < kCount; ++i) {
        EmissionSample e;
        ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, e));
        if (e.ray.origin.x > 4) ++on_wide;
    }
    EXPECT_NEAR(on_wide, 0.75 * kCount, 4 * std::sqrt(0.75 * 0.25 * kCount));
}

TEST(AreaLight, IsDarkWithoutAnArea) {
    const std::vector<Geometry> shapes = {parallelogram(Vec3(0.0f), Vec3(1, 0, 0), Vec3(2, 0, 0)),
                                          TriangleMesh{},
                                          placed(Disk{0, 0, 0, 360}, Matrix()),
                                          placed(Disk{0, 1, 1, 360}, Matrix()),
                                          placed(Sphere{1, -1, 1, 360}, scaling(0, 0, 0)),
                                          placed(Sphere{1, 0, 0, 360}, Matrix())};
    for (const Geometry& shape : shapes) {
        const auto light = make_area_light(emissive(shape, Rgb(1.0f)), Matrix());
        EXPECT_FALSE(dynamic_cast<const AreaLight&>(*light).has_area());
        EXPECT_EQ(light->power(), 0);
        EmissionSample photon;
        EXPECT_FALSE(light->sample_emission({0.4f, 0.3f, 0.5f, 0.5f}, photon));
        DirectSample direct;
        EXPECT_FALSE(light->sample_direct(Vec3(0, 0, 5), Vec3(0, 0, 1), Vec2(0.4f, 0.3f), direct) &&
                     !is_black(direct.radiance));
    }
}

}  // namespace
}  // namespace lxs::test::area_light_test
