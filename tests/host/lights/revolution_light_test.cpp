// Lights of cylinders, cones, hyperboloids, paraboloids and tori: flux against closed forms of the
// area, densities against the points drawn, and the way back from a point to its random numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "light_cases.h"
#include "lxs/scene/surface_of_revolution.h"

namespace lxs::test::revolution_light_test {
namespace {

using Imath::V3d;

constexpr double kPi = std::numbers::pi;

struct Emitter {
    const char* name;
    decltype(Quadric::shape) shape;
    double area;
};

double paraboloid_area(double radius, double height) {
    const double k = radius * radius / height;
    return kPi / 6 * std::sqrt(k) * (std::pow(k + 4 * height, 1.5) - std::pow(k, 1.5));
}

/// Of the hyperboloid radius^2 = a^2 + m^2 z^2 for |z| < half.
double hyperboloid_area(double a, double m, double half) {
    const double k = m * std::sqrt(1 + m * m) / a;
    return 2 * kPi * a * (half * std::sqrt(1 + k * k * half * half) + std::asinh(k * half) / k);
}

std::vector<Emitter> emitters() {
    return {{"cylinder", RevolvedSegment{Vec3(0.5f, 0, -1), Vec3(0.5f, 0, 1), 360}, 2 * kPi},
            {"half cylinder", RevolvedSegment{Vec3(0.5f, 0, -1), Vec3(0.5f, 0, 1), 180}, kPi},
            {"cone", RevolvedSegment{Vec3(0.6f, 0, 0), Vec3(0, 0, 0.8f), 360}, 0.6 * kPi},
            {"frustum", RevolvedSegment{Vec3(0.6f, 0, 0), Vec3(0.3f, 0, 0.4f), 360}, 0.45 * kPi},
            {"hyperboloid", RevolvedSegment{Vec3(0.5f, -0.5f, -0.5f), Vec3(0.5f, 0.5f, 0.5f), 360},
             hyperboloid_area(0.5, 1, 0.5)},
            {"paraboloid", Paraboloid{0.8f, 0, 1.2f, 360}, paraboloid_area(0.8, 1.2)},
            {"torus", Torus{0.7f, 0.2f, 0, 360, 360}, 4 * kPi * kPi * 0.7 * 0.2},
            {"outer half of a torus", Torus{0.7f, 0.2f, -90, 90, 360},
             2 * kPi * 0.2 * (0.7 * kPi + 0.4)}};
}

TEST(RevolutionLight, FluxIsPiTimesAreaTimesRadiance) {
    for (const Emitter& e : emitters()) {
        const auto light =
            make_area_light(emissive(placed(e.shape, scaling(2, 2, 2)), Rgb(3.0f)), Matrix());
        const double expected = 3 * kPi * 4 * e.area;
        EXPECT_NEAR(light->power() / expected, 1, 2e-4) << e.name;
        Random random(23);
        double sum = 0, squares = 0;
        constexpr int kCount = 20000;
        for (int i = 0; i < kCount; ++i) {
            EmissionSample s;
            ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, s));
            const double power = luminance(s.power);
            sum += power;
            squares += power * power;
        }
        const double mean = sum / kCount;
        const double deviation = std::sqrt(std::max(0.0, squares / kCount - mean * mean) / kCount);
        EXPECT_NEAR(mean, expected, 4.5 * deviation + 1e-4 * expected) << e.name;
    }
}

/// Integral of each coordinate's square over the surface's image, by the midpoint rule.
V3d second_moments(const SurfaceOfRevolution& shape, const Matrix& to_world) {
    constexpr int kGrid = 400;
    V3d sum(0.0);
    const double dphi = shape.phi_max() / kGrid, dv = 1.0 / kGrid, h = 1e-6;
    for (int i = 0; i < kGrid; ++i) {
        for (int j = 0; j < kGrid; ++j) {
            const double phi = (i + 0.5) * dphi, v = (j + 0.5) * dv;
            const auto at = [&](double a, double b) {
                V3d image;
                to_world.multVecMatrix(shape.at(a, b).p, image);
                return image;
            };
            const V3d along = at(phi, v + h) - at(phi, v - h);
            const V3d around = at(phi + h, v) - at(phi - h, v);
            const double area = along.cross(around).length() / (4 * h * h) * dphi * dv;
            const V3d p = at(phi, v);
            sum += V3d(p.x * p.x, p.y * p.y, p.z * p.z) * area;
        }
    }
    return sum;
}

TEST(RevolutionLight, PointsHaveTheirDensityWhenStretched) {
    const Matrix m = scaling(1, 0.4, 1.7) * translation(0.2, -0.3, 0.5);
    for (const Emitter& e : emitters()) {
        const Quadric quadric = placed(e.shape, m);
        const auto light = make_area_light(emissive(quadric, Rgb(1.0f)), Matrix());
        const V3d expected = second_moments(SurfaceOfRevolution::of(quadric).value(), m);
        Random random(29);
        V3d sum(0.0), squares(0.0);
        constexpr int kCount = 40000;
        for (int i = 0; i < kCount; ++i) {
            EmissionSample s;
            ASSERT_TRUE(light->sample_emission({random(), random(), random(), random()}, s));
            for (int k = 0; k < 3; ++k) {
                // power = pi / density
                const double x = double(s.power.x) / kPi * s.ray.origin[k] * s.ray.origin[k];
                sum[k] += x;
                squares[k] += x * x;
            }
        }
        for (int k = 0; k < 3; ++k) {
            const double mean = sum[k] / kCount;
            const double deviation = std::sqrt((squares[k] / kCount - mean * mean) / kCount);
            EXPECT_NEAR(mean, expected[k], 4.5 * deviation + 1e-4 * expected[k])
                << e.name << ", coordinate " << k;
        }
    }
}

TEST(RevolutionLight, DensityOfAHitIsThatOfTheSample) {
    const Matrix m = scaling(1, 0.4, 1.7) * translation(0.2, -0.3, 0.5);
    const Vec3 from(1.5f, 2, 3);
    for (const Emitter& e : emitters()) {
        const auto light = make_area_light(emissive(placed(e.shape, m), Rgb(1.0f)), Matrix());
        Random random(31);
        int seen = 0;
        for (int i = 0; i < 500; ++i) {
            const Vec2 u(random(), 0.001f + 0.998f * random());
            DirectSample d;
            EmissionSample emission;
            if (!light->sample_direct(from, Vec3(0, 0, 1), u, d)) continue;
            ASSERT_TRUE(light->sample_emission({u.x, u.y, 0.5f, 0.5f}, emission));
            ++seen;
            const Vec3 p = from + d.wi * d.distance;
            const float pdf = light->pdf_direct(from, {}, d.wi, p, emission.normal, 0);
            EXPECT_NEAR(pdf / d.pdf, 1, 1e-3) << e.name;
            PrimaryPoint back{};
            if (!light->emission_coordinates(from, d, back)) continue;  // grazing
            EXPECT_NEAR(back[0], u.x, 2e-4) << e.name;
            EXPECT_NEAR(back[1], u.y, 2e-4) << e.name;
        }
        EXPECT_GT(seen, 50) << e.name;
    }
}

TEST(RevolutionLight, FrontIsOutsideUnlessReversed) {
    for (const bool reversed : {false, true}) {
        Primitive tube =
            emissive(placed(RevolvedSegment{Vec3(1, 0, -1), Vec3(1, 0, 1), 360}, {}), Rgb(1.0f));
        tube.reverse_orientation = reversed;
        for (const Matrix& place : {Matrix(), scaling(-1, 1, 1)}) {
            EmissionSample s;
            ASSERT_TRUE(make_area_light(tube, place)->sample_emission({0.4f, 0.3f, 0.5f, 0.5f}, s));
            const float outward = Vec3(s.ray.origin.x, s.ray.origin.y, 0).dot(s.normal);
            EXPECT_NEAR(outward, reversed ? -1 : 1, 1e-5f);
        }
    }
}

}  // namespace
}  // namespace lxs::test::revolution_light_test
