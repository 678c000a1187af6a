// Shadow rays reach the light they were drawn for: neither it nor the surface they leave blocks
// them, at any scale and place, however flat the light is seen; what stands between does.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fakes.h"
#include "lxs/sdk/rays.h"
#include "random_directions.h"

namespace lxs::test::shadow_ray_test {
namespace {

constexpr int kPlacements = 10, kRays = 10000;

struct Counts {
    int drawn = 0, blocked = 0;
};

void draw(const Scene& scene, const SurfaceHit& hit, Random& random, Counts& counts) {
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
    return parallelogram(Vec3(-half, -half, z), Vec3(2 * half, 0, 0), Vec3(0, 2 * half, 0));
}

Primitive lamp(Geometry geometry) {
    Primitive result = primitive(std::move(geometry));
    result.emission = emission(Rgb(1.0f));
    return result;
}

/// A point without error that faces anywhere.
SurfaceHit in_the_air(Random& random, const Vec3& p) {
    SurfaceHit hit;
    hit.p = p;
    hit.ng = hit.ns = random_direction(random);
    return hit;
}

using MakeScene = std::function<std::unique_ptr<Scene>(const Matrix& placement)>;
using MakeHit = std::function<SurfaceHit(const Scene&, Random&, const Matrix& placement)>;

struct Case {
    float scale;
    float offset;  ///< of the lamp's centre from the origin, in multiples of `scale`
};

class ShadowRay : public testing::TestWithParam<Case> {
  protected:
    /// Shadow rays from hits to the scene's lamp, over random placements.
    Counts count(std::uint32_t seed, const MakeScene& make_scene, const MakeHit& make_hit) const {
        Random random(seed);
        Counts counts;
        for (int i = 0; i < kPlacements; ++i) {
            const Matrix m = placement(random);
            const auto scene = make_scene(m);
            for (int k = 0; k < kRays; ++k)
                draw(*scene, make_hit(*scene, random, m), random, counts);
        }
        EXPECT_GT(counts.drawn, kPlacements * kRays / 2);
        return counts;
    }

  private:
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
    return in_the_air(random, image(along * distance + Vec3(0, 0, height), m));
}

TEST_P(ShadowRay, MeetsNoFlatLamp) {
    // What rounding leaves of coordinates: nearer points may well lie behind the lamp.
    const float resolution = 1e-6f * (1 + GetParam().offset);
    const auto point = [&](const Scene&, Random& random, const Matrix& m) {
        return point_before_plane(random, m, resolution);
    };
    const auto square = [](const Matrix& m) { return trace({lamp(placed(panel(1, 0), m))}); };
    EXPECT_EQ(count(1, square, point).blocked, 0);
    const auto round = [](const Matrix& m) { return trace({lamp(disk(1, m))}); };
    EXPECT_EQ(count(2, round, point).blocked, 0);
}

TEST_P(ShadowRay, MeetsNoBall) {
    const auto ball = [](const Matrix& m) { return trace({lamp(sphere(1, m))}); };
    const auto point = [](const Scene&, Random& random, const Matrix& m) {
        const float height = std::pow(10.0f, uniform(random, -5, 2));
        return in_the_air(random, image(random_direction(random) * (1 + height), m));
    };
    EXPECT_EQ(count(3, ball, point).blocked, 0);
}

TEST_P(ShadowRay, LeavesTheWallBesideALamp) {
    // The wall's points see the lamp at all elevations. A gap of more than rounding between them:
    // no lamp point may lie within the wall's own error.
    const auto corner = [](const Matrix& m) {
        const TriangleMesh wall = parallelogram(Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 0, 2));
        return trace({lamp(placed(panel(0.999f, 0), m)), primitive(placed(wall, m))});
    };
    const auto wall_point = [](const Scene& scene, Random& random, const Matrix& m) {
        const float height = std::pow(10.0f, uniform(random, -3, 0));
        const Vec3 eye = image(Vec3(0, 0.5f, 0.7f), m);
        const Vec3 target = image(Vec3(uniform(random, -0.9f, 0.9f), -1, height), m);
        SurfaceHit result;
        EXPECT_TRUE(hit(scene, ray(eye, (target - eye).normalized()), result));
        return result;
    };
    EXPECT_EQ(count(4, corner, wall_point).blocked, 0);
}

TEST_P(ShadowRay, IsBlockedByAScreenCloseToTheLamp) {
    // A thousandth of the lamp's size before it, at a hundred of its sizes from the origin still
    // far more than rounding.
    const auto screened = [](const Matrix& m) {
        return trace({lamp(placed(panel(1, 0), m)), primitive(placed(panel(2, 1e-3f), m))});
    };
    const auto point = [](const Scene&, Random& random, const Matrix& m) {
        const Vec3 p(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, 0.1f, 3));
        return in_the_air(random, image(p, m));
    };
    const Counts counts = count(5, screened, point);
    EXPECT_EQ(counts.blocked, counts.drawn);
}

}  // namespace
}  // namespace lxs::test::shadow_ray_test
