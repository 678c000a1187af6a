// Cylinders, cones, hyperboloids, paraboloids and tori: hits against their equations, normals
// against the tangents, cuts, and no ray that meets the surface it leaves.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"
#include "lxs/scene/surface_of_revolution.h"
#include "lxs/sdk/offset_origin.h"
#include "random_directions.h"

namespace lxs::test::revolution_hit_test {
namespace {

using Imath::V3d;

constexpr float kPi = 3.14159265f;

struct Solid {
    const char* name;
    Quadric quadric;
    /// Zero on the surface, scaled as a distance near it.
    double (*equation)(const V3d& p);
};

const RevolvedSegment kCylinder{Vec3(0.5f, 0, -0.4f), Vec3(0.5f, 0, 0.6f), 360};
const RevolvedSegment kCone{Vec3(0.8f, 0, 0), Vec3(0, 0, 1), 360};
const RevolvedSegment kFlatCone{Vec3(1, 0, 0), Vec3(0, 0, 0.01f), 360};
const RevolvedSegment kHyperboloid{Vec3(0.6f, -0.6f, -0.5f), Vec3(0.6f, 0.6f, 0.5f), 360};
const Paraboloid kBowl{0.8f, 0, 1, 360};
const Torus kTorus{0.7f, 0.2f, 0, 360, 360};

double radius(const V3d& p) {
    return std::hypot(p.x, p.y);
}

std::vector<Solid> solids() {
    return {
        {"cylinder", {kCylinder, {}}, [](const V3d& p) { return radius(p) - 0.5; }},
        {"cone", {kCone, {}}, [](const V3d& p) { return radius(p) - 0.8 * (1 - p.z); }},
        {"flat cone", {kFlatCone, {}}, [](const V3d& p) { return p.z - 0.01 * (1 - radius(p)); }},
        {"hyperboloid",
         {kHyperboloid, {}},
         [](const V3d& p) { return radius(p) - std::sqrt(0.36 + 1.44 * p.z * p.z); }},
        {"paraboloid",
         {kBowl, {}},
         [](const V3d& p) { return (p.z - radius(p) * radius(p) / 0.64) / (1 + 3 * radius(p)); }},
        {"torus",
         {kTorus, {}},
         [](const V3d& p) { return std::hypot(radius(p) - 0.7, p.z) - 0.2; }},
    };
}

/// A ray from around to somewhere inside of the unit sphere.
Ray random_ray(Random& random, float distance) {
    const Vec3 target = random_direction(random) * uniform(random, 0, 0.9f);
    const Vec3 from = random_direction(random) * distance;
    return ray(from, target - from);
}

TEST(RevolutionHit, EveryHitLiesOnTheSurfaceFromNearAndFar) {
    for (const Solid& solid : solids()) {
        const auto scene = trace({primitive(solid.quadric)});
        Random random(5);
        for (const float distance : {3.0f, 1e4f}) {
            int hits = 0;
            for (int i = 0; i < 5000; ++i) {
                const Ray r = random_ray(random, distance);
                SurfaceHit result;
                if (!hit(*scene, r, result)) continue;
                ++hits;
                EXPECT_NEAR(solid.equation(V3d(result.p)), 0, 3e-7) << solid.name << result.p;
                const V3d along = V3d(r.origin) + V3d(r.direction) * double(result.distance);
                EXPECT_LT((along - V3d(result.p)).length(), 1e-6 * distance) << solid.name;
            }
            EXPECT_GT(hits, 500) << solid.name;
        }
    }
}

/// Sign changes of the equation along a ray, finely sampled, within the cuts of whole solids.
int crossings(const Solid& solid, const Ray& r) {
    const auto shape = SurfaceOfRevolution::of(solid.quadric).value();
    int count = 0;
    bool inside = false, first = true;
    constexpr int kSteps = 20000;
    for (int i = 0; i <= kSteps; ++i) {
        const V3d p = V3d(r.origin) + V3d(r.direction) * (6.0 * i / kSteps);
        const bool now = solid.equation(p) < 0;
        if (!first && now != inside && p.z >= shape.z_min() && p.z <= shape.z_max()) ++count;
        inside = now;
        first = false;
    }
    return count;
}

TEST(RevolutionHit, NoCrossingIsMissed) {
    for (const Solid& solid : solids()) {
        const auto scene = trace({primitive(solid.quadric)});
        Random random(6);
        int disagreements = 0;
        for (int i = 0; i < 200; ++i) {
            const Ray r = random_ray(random, 3);
            int met = 0;
            Ray rest = r;
            SurfaceHit result;
            while (met < 8 && hit(*scene, rest, result)) {
                ++met;
                rest.origin = offset_origin(result.p, result.p_error, result.ng, r.direction);
            }
            disagreements += met != crossings(solid, r);
        }
        // Rays that graze within a sampling step, or pass a rim, may differ.
        EXPECT_LE(disagreements, 2) << solid.name;
    }
}

TEST(RevolutionHit, CoordinatesInvertAndNormalsFollowTheTangents) {
    for (const Solid& solid : solids()) {
        const auto shape = SurfaceOfRevolution::of(solid.quadric).value();
        Random random(7);
        for (int i = 0; i < 300; ++i) {
            const double phi = uniform(random, 0.01f, 6.2f), v = uniform(random, 0.01f, 0.99f);
            const RevolutionPoint at = shape.at(phi, v);
            const Imath::V2d back = shape.coordinates(at.p);
            EXPECT_NEAR(back.x, phi, 1e-9) << solid.name;
            EXPECT_NEAR(back.y, v, 1e-9) << solid.name;
            constexpr double kStep = 1e-5;
            const V3d dphi =
                (shape.at(phi + kStep, v).p - shape.at(phi - kStep, v).p) / (2 * kStep);
            const V3d dv = (shape.at(phi, v + kStep).p - shape.at(phi, v - kStep).p) / (2 * kStep);
            EXPECT_LT((at.dpdv - dv).length(), 1e-6) << solid.name;
            const V3d across = dphi.cross(dv);
            EXPECT_NEAR(at.area, across.length(), 1e-6) << solid.name;
            EXPECT_GT(at.normal.dot(across.normalized()), 1 - 1e-8) << solid.name;
        }
    }
}

TEST(RevolutionHit, ConePointNormalAndCoordinates) {
    const auto scene = trace({primitive(Quadric{kCone, Matrix()})});
    SurfaceHit result;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 5, 0.25f), Vec3(0, -1, 0)), result));
    EXPECT_NEAR(result.p.y, 0.6f, 1e-6f);
    EXPECT_NEAR(result.uv.x, 0.25f, 1e-6f);
    EXPECT_NEAR(result.uv.y, 0.25f, 1e-6f);
    EXPECT_NEAR(result.ng.z / result.ng.y, 0.8f, 1e-5f);
    EXPECT_NEAR(result.dpdu.x, -2 * kPi * 0.6f, 1e-5f);
}

TEST(RevolutionHit, CutsLeaveHoles) {
    SurfaceHit result;
    RevolvedSegment half = kCylinder;
    half.phi_max = 180;
    const auto gutter = trace({primitive(Quadric{half, Matrix()})});
    EXPECT_TRUE(hit(*gutter, ray(Vec3(0, 5, 0), Vec3(0, -1, 0)), result));
    EXPECT_NEAR(result.p.y, 0.5f, 1e-6f);
    EXPECT_FALSE(hit(*gutter, ray(Vec3(0, -5, 0), Vec3(0, 1, 0)), result) && result.p.y < 0);
    Torus bowl = kTorus;
    bowl.theta_min = 180;  // the lower half of the tube
    const auto gulley = trace({primitive(Quadric{bowl, Matrix()})});
    ASSERT_TRUE(hit(*gulley, ray(Vec3(0.7f, 0, 5), Vec3(0, 0, -1)), result));
    EXPECT_NEAR(result.p.z, -0.2f, 1e-6f);
    const Paraboloid ring{0.8f, 0.5f, 1, 360};
    const auto cut = trace({primitive(Quadric{ring, Matrix()})});
    EXPECT_FALSE(hit(*cut, ray(Vec3(0, 0, 5), Vec3(0, 0, -1)), result));
}

TEST(RevolutionHit, BoxHoldsTheSurface) {
    const Matrix m = rotation({1, 2, 3}, 1) * translation(4, -2, 1);
    for (const Solid& solid : solids()) {
        const auto scene = trace({primitive(Quadric{solid.quadric.shape, m})});
        const auto shape = SurfaceOfRevolution::of(solid.quadric).value();
        for (int i = 0; i < 400; ++i) {
            const int column = i % 20, row = i / 20;
            V3d p;
            m.multVecMatrix(shape.at(0.314 * column, row / 19.0).p, p);
            EXPECT_TRUE(scene->bounds().intersects(Vec3(p))) << solid.name;
        }
    }
}

/// Leaves points of tori and cylinders to their outside where that is locally convex.
TEST(RevolutionHit, LeavingRaysDoNotMeetTheirStart) {
    struct Place {
        double scale, x;
    };
    for (const Place place : {Place{1, 0}, Place{1e-6, 0}, Place{1e6, 3e6}, Place{1, 1e3}}) {
        const Matrix m = scaling(place.scale, place.scale, place.scale) * rotation({1, 2, 3}, 1) *
                         translation(place.x, 0, 0);
        for (const Solid& solid : solids()) {
            const auto scene = trace({primitive(Quadric{solid.quadric.shape, m})});
            const auto shape = SurfaceOfRevolution::of(solid.quadric).value();
            Random random(8);
            int remeetings = 0;
            for (int i = 0; i < 2000; ++i) {
                V3d target, from;
                const RevolutionPoint at =
                    shape.at(uniform(random, 0, 6.28f), uniform(random, 0.02f, 0.98f));
                m.multVecMatrix(at.p, target);
                m.multVecMatrix(at.p + at.normal * 0.05, from);
                SurfaceHit first, second;
                if (!hit(*scene, ray(Vec3(from), Vec3(target - from)), first)) continue;
                const float near = static_cast<float>(place.scale) * 1e-3f;
                const Vec3 aside = random_direction(random);
                const Vec3 tangent = (aside - first.ng * aside.dot(first.ng)).normalized();
                const Vec3 direction = (tangent + first.ng * 0.01f).normalized();
                Ray leaving =
                    ray(offset_origin(first.p, first.p_error, first.ng, direction), direction);
                leaving.t_max = near;
                remeetings += hit(*scene, leaving, second);
            }
            EXPECT_EQ(remeetings, 0) << solid.name << " at scale " << place.scale;
        }
    }
}

}  // namespace
}  // namespace lxs::test::revolution_hit_test
