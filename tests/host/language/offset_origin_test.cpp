// Ray origins leave the surface's error box whatever the scale; clear media never give NaN.
#include <gtest/gtest.h>

#include <cmath>

#include "lxs/sdk/medium.h"
#include "lxs/sdk/offset_origin.h"

namespace lxs::offset_origin_test {
namespace {

TEST(OffsetOrigin, GoesToTheSideOfTheDirection) {
    const Vec3 p(1, 2, 3);
    const Vec3 error(1e-6f);
    const Vec3 ng(0, 0, 1);
    EXPECT_GT(offset_origin(p, error, ng, Vec3(0, 0, 1)).z, 3.0f + 0.9e-6f);
    EXPECT_LT(offset_origin(p, error, ng, Vec3(0, 0, -1)).z, 3.0f - 0.9e-6f);
}

TEST(OffsetOrigin, ClearsTheErrorBoxAtAnyScale) {
    const Vec3 ng = Vec3(1, -2, 0.5f).normalized();
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
        const Vec3 p = Vec3(3, -5, 7) * scale;
        const Vec3 error(scale * 1e-6f);
        const Vec3 origin = offset_origin(p, error, ng, ng);
        const double extent =
            std::abs(ng.x) * error.x + std::abs(ng.y) * error.y + std::abs(ng.z) * error.z;
        const Imath::V3d moved = Imath::V3d(origin) - Imath::V3d(p);
        EXPECT_GE(moved.dot(Imath::V3d(ng)), extent * 0.999) << "scale " << scale;
        EXPECT_LE(moved.length(), extent * 3) << "scale " << scale;
    }
}

// One float further than the rounded sum, on both sides of zero and from zero itself.
TEST(OffsetOrigin, StepsOneFloatBeyondTheSum) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float z : {-2.0f, -1e-30f, -0.0f, 0.0f, 1e-30f, 1.0f, 16777216.0f}) {
        for (const float side : {1.0f, -1.0f}) {
            constexpr float kError = 1e-40f;  // vanishes in most sums
            const Vec3 moved =
                offset_origin(Vec3(0, 0, z), Vec3(kError), Vec3(0, 0, 1), Vec3(0, 0, side));
            EXPECT_EQ(moved.z, std::nextafter(z + side * kError, side * kInfinity)) << z;
        }
    }
    const Vec3 cancelled =
        offset_origin(Vec3(0, 0, 0.5f), Vec3(0.5f), Vec3(0, 0, 1), Vec3(0, 0, -1));
    EXPECT_EQ(cancelled.z, std::nextafter(0.0f, -kInfinity));
}

TEST(OffsetOrigin, WithoutErrorStaysInPlace) {
    EXPECT_EQ(offset_origin(Vec3(1, 2, 3), Vec3(0.0f), Vec3(0, 0, 1), Vec3(0, 0, 1)),
              Vec3(1, 2, 3));
}

TEST(Medium, FollowsBeerLambert) {
    const Medium medium(Rgb(0.5f, 1.0f, 0.0f), 1.33f);
    const Rgb t = medium.transmittance(2.0f);
    EXPECT_FLOAT_EQ(t.x, std::exp(-1.0f));
    EXPECT_FLOAT_EQ(t.y, std::exp(-2.0f));
    EXPECT_FLOAT_EQ(t.z, 1.0f);
}

TEST(Medium, IsFiniteOverInfiniteDistances) {
    const Medium medium(Rgb(0.5f, 0.0f, 0.0f), 1.0f);
    const Rgb t = medium.transmittance(std::numeric_limits<float>::infinity());
    EXPECT_EQ(t, Rgb(0.0f, 1.0f, 1.0f));
}

}  // namespace
}  // namespace lxs::offset_origin_test
