// Shadow rays reach the light they were drawn for: neither it nor the surface they leave blocks
// them, at any scale and place, however flat the light is seen; what stands between does.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"
#include "lxs/sdk/rays.h"
#include "random_directions.h"

namespace lxs::test {
namespace {

constexpr int kPlacements = 10, kRays = 10000;

struct Counts {
    int drawn = 0, blocked = 0;
};

void count(const Scene& scene, const SurfaceHit& hit, Random& random, Counts& counts) {
    DirectSample sample;
    const Vec2 u(uniform(random, 0, 1), uniform(random, 0, 1));
    if (!scene.lights().front()->sample_direct(hit.p, hit.ns, u, sample)) return;
    ++counts.drawn;
    counts.blocked += is_black(scene.transmittance(shadow_ray(hit, sample, 0)));
}

Vec3 image(const Vec3& v, const Matrix& m) {
    Imath::V3d result;
    m.multVecMatrix(Imath::V3d(v), result);
    return Vec3(result);
}

TriangleMesh placed(TriangleMesh mesh, const Matrix& m) {
    for (Vec3& p : mesh.positions)
        p = image(p, m);
    return mesh;
}

TriangleMesh panel(float half, float z) {
    return rectangle(Vec3(-half, -half, z), Vec3(2 * half, 0, 0), Vec3(0, 2 * half, 0));
}

Primitive lamp(Geometry geometry) {
    Primitive result = primitive(std::move(geometry));
    result.emission = emission(Rgb(1.0f));
    return result;
}

struct Case {
    float scale;
    float offset;  ///< of the lamp's centre from the origin, in multiples of `scale`
};

class ShadowRay : public testing::TestWithParam<Case> {
  protected:
    /// A lamp of about unit size, turned at random, to the case's scale and place.
    Matrix placement(Random& random) const {
        const auto [scale, offset] = GetParam();
        const Vec3 place = Vec3(1.0f, -0.7f, 0.4f) * offset * scale;
        return rotation(Imath::V3d(random_direction(random)), uniform(random, 0, 6)) *
               scaling(scale, scale, scale) * translation(place.x, place.y, place.z);
    }
};

INSTANTIATE_TEST_SUITE_P(ScalesAndPlaces, ShadowRay,
                         testing::Values(Case{1, 0}, Case{1e-4f, 0}, Case{1e4f, 0}, Case{1, 3},
                                         Case{1, 100}, Case{1e-3f, 100}));

/// A point in the air in front of the lamp's plane z = 0, from near to far, seen from the lamp at
/// elevations down to 1e-5, but never closer to the plane than `resolution`.
SurfaceHit point_before_plane(Random& random, const Matrix& m, float resolution) {
    const float distance = std::pow(10.0f, uniform(random, -1, 2));
    const float height = std::max(resolution, distance * std::pow(10.0f, uniform(random, -5, 0)));
    const Vec3 d = random_direction(random);
    const Vec3 along = Vec3(d.x, d.y, 0).normalized();
    SurfaceHit hit;
    hit.p = image(along * distance + Vec3(0, 0, height), m);
    hit.ng = hit.ns = random_direction(random);
    return hit;
}

TEST_P(ShadowRay, MeetsNoFlatLamp) {
    // What rounding leaves of coordinates: nearer points may well lie behind the lamp.
    const float resolution = 1e-6f * (1 + GetParam().offset);
    for (const bool round : {false, true}) {
        Random random(1);
        Counts counts;
        for (int i = 0; i < kPlacements; ++i) {
            const Matrix m = placement(random);
            const auto scene = trace({round ? lamp(disk(1, m)) : lamp(placed(panel(1, 0), m))});
            for (int k = 0; k < kRays; ++k)
                count(*scene, point_before_plane(random, m, resolution), random, counts);
        }
        EXPECT_EQ(counts.blocked, 0) << "round: " << round;
        EXPECT_GT(counts.drawn, kPlacements * kRays / 2);
    }
}

TEST_P(ShadowRay, MeetsNoBall) {
    Random random(2);
    Counts counts;
    for (int i = 0; i < kPlacements; ++i) {
        const Matrix m = placement(random);
        const auto scene = trace({lamp(sphere(1, m))});
        for (int k = 0; k < kRays; ++k) {
            const float height = std::pow(10.0f, uniform(random, -5, 2));
            SurfaceHit hit;
            hit.p = image(random_direction(random) * (1 + height), m);
            hit.ng = hit.ns = random_direction(random);
            count(*scene, hit, random, counts);
        }
    }
    EXPECT_EQ(counts.blocked, 0);
    EXPECT_GT(counts.drawn, kPlacements * kRays / 2);
}

TEST_P(ShadowRay, LeavesTheWallBesideALamp) {
    // Lamp and wall share an edge: the wall's points see the lamp at all elevations.
    Random random(3);
    Counts counts;
    for (int i = 0; i < kPlacements; ++i) {
        const Matrix m = placement(random);
        const TriangleMesh wall = rectangle(Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 0, 2));
        const auto scene = trace({lamp(placed(panel(1, 0), m)), primitive(placed(wall, m))});
        const Vec3 eye = image(Vec3(0, 0.5f, 0.7f), m);
        for (int k = 0; k < kRays; ++k) {
            const float height = std::pow(10.0f, uniform(random, -3, 0));
            const Vec3 target = image(Vec3(uniform(random, -0.9f, 0.9f), -1, height), m);
            SurfaceHit wall_point;
            if (hit(*scene, ray(eye, (target - eye).normalized()), wall_point))
                count(*scene, wall_point, random, counts);
        }
    }
    EXPECT_EQ(counts.blocked, 0);
    EXPECT_GT(counts.drawn, kPlacements * kRays / 2);
}

TEST_P(ShadowRay, IsBlockedByAScreenCloseToTheLamp) {
    // A thousandth of the lamp's size before it, at a hundred of its sizes from the origin still
    // far more than rounding.
    Random random(4);
    Counts counts;
    for (int i = 0; i < kPlacements; ++i) {
        const Matrix m = placement(random);
        const auto scene =
            trace({lamp(placed(panel(1, 0), m)), primitive(placed(panel(2, 1e-3f), m))});
        for (int k = 0; k < kRays; ++k) {
            const Vec3 p(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, 0.1f, 3));
            SurfaceHit hit;
            hit.p = image(p, m);
            hit.ng = hit.ns = random_direction(random);
            count(*scene, hit, random, counts);
        }
    }
    EXPECT_EQ(counts.blocked, counts.drawn);
    EXPECT_GT(counts.drawn, kPlacements * kRays / 2);
}

}  // namespace
}  // namespace lxs::test
