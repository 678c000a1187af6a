// Shadow rays: blocked, free, through straight surfaces and media.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"

namespace lxs::test::transmittance_test {
namespace {

Primitive pane(float z, std::shared_ptr<const Material> material) {
    return primitive(parallelogram(Vec3(-1, -1, z), Vec3(2, 0, 0), Vec3(0, 2, 0)),
                     std::move(material));
}

const Ray kUpwards = ray(Vec3(0.3f, 0.2f, 0), Vec3(0, 0, 1));

TEST(Transmittance, OpaqueBlocksUpToTheSegmentsEnd) {
    const auto scene = trace({pane(1, matte())});
    EXPECT_EQ(scene->transmittance(kUpwards), Rgb(0.0f));
    Ray segment = kUpwards;
    segment.t_max = 0.9999f;
    EXPECT_EQ(scene->transmittance(segment), Rgb(1.0f));
}

TEST(Transmittance, MediumAbsorbsOverTheSegment) {
    const auto scene = trace_within({pane(9, matte())}, std::make_shared<Medium>(Rgb(1, 0, 2), 1));
    Ray segment = kUpwards;
    segment.media = scene->camera_media();
    segment.t_max = 0.5f;
    const Rgb share = scene->transmittance(segment);
    EXPECT_NEAR(share.x, std::exp(-0.5f), 1e-6f);
    EXPECT_EQ(share.y, 1);
    EXPECT_NEAR(share.z, std::exp(-1.0f), 1e-6f);
}

/// A medium that no surface bounds ends at the sphere around the scene, here of radius sqrt(3);
/// shadow rays and rays that leave the scene agree on it.
TEST(Transmittance, EndlessRayEndsWithTheScene) {
    const auto scene = trace_within({pane(-1, matte()), pane(1, matte())},
                                    std::make_shared<Medium>(Rgb(1, 0, 2), 1));
    Ray sideways = ray(Vec3(0.5f, 0, 0), Vec3(1, 0, 0));
    sideways.media = scene->camera_media();
    const double length = std::sqrt(3.0) - 0.5;
    const Rgb share = scene->transmittance(sideways);
    EXPECT_NEAR(share.x, std::exp(-length), 1e-4);
    EXPECT_EQ(share.y, 1);
    EXPECT_NEAR(share.z, std::exp(-2 * length), 1e-4);
    SurfaceHit end;
    EXPECT_FALSE(hit(*scene, sideways, end));
    EXPECT_NEAR(end.distance, length, 1e-4);
    EXPECT_EQ(end.transmittance, share);
    sideways.direction = Vec3(-1, 0, 0);
    sideways.origin = Vec3(-5, 0, 0);
    EXPECT_EQ(scene->transmittance(sideways), Rgb(1.0f)) << "beyond the scene";
}

TEST(Transmittance, StraightSurfacesMultiply) {
    const auto scene = trace(
        {pane(1, straight(Rgb(0.5f, 1, 0.25f))), pane(2, straight(Rgb(0.5f))), pane(3, matte())});
    Ray segment = kUpwards;
    segment.t_max = 2.5f;
    EXPECT_EQ(scene->transmittance(segment), Rgb(0.25f, 0.5f, 0.125f));
    segment.t_max = 1.5f;
    EXPECT_EQ(scene->transmittance(segment), Rgb(0.5f, 1, 0.25f));
    EXPECT_EQ(scene->transmittance(kUpwards), Rgb(0.0f));
}

TEST(Transmittance, EachSurfaceCountsOnceAtAnyScale) {
    // Passed rays: twice through a closed sphere, once through a tilted triangle at all angles.
    const auto half = straight(Rgb(0.5f));
    for (const float scale : {1e-5f, 1.0f, 1e5f}) {
        const Vec3 a = Vec3(-1, -1, 0.2f) * scale, b = Vec3(1, -1.1f, 0.6f) * scale,
                   c = Vec3(0.1f, 1, -0.3f) * scale;
        const Vec3 middle = (a + b + c) / 3;
        const auto ball = trace({primitive(sphere(scale, Matrix()), half)});
        const auto single = trace({primitive(triangle(a, b, c), half)});
        int wrong = 0;
        for (int i = 0; i < 1000; ++i) {
            const float x = 0.0009995f * static_cast<float>(i) * scale;
            if (ball->transmittance(ray(Vec3(x, 0, -3 * scale), Vec3(0, 0, 1))) != Rgb(0.25f))
                ++wrong;
            const float angle = 0.00314f * static_cast<float>(i);
            const Vec3 d(std::cos(angle), 0.1f, std::sin(angle));
            if (single->transmittance(ray(middle - d * (3 * scale), d)) != Rgb(0.5f)) ++wrong;
        }
        EXPECT_EQ(wrong, 0) << "at scale " << scale;
    }
}

TEST(Transmittance, SwitchesMediumAtSurfaces) {
    Primitive ball = primitive(sphere(1, translation(0, 0, 3)), straight(Rgb(1.0f)));
    ball.interior = std::make_shared<Medium>(Rgb(1, 0.5f, 0), 1);
    ball.exterior = std::make_shared<Medium>(Rgb(0, 0, 0.25f), 1);
    const auto scene = trace_within({ball}, ball.exterior);
    Ray segment = ray(Vec3(0), Vec3(0, 0, 1));
    segment.media = scene->camera_media();
    segment.t_max = 6;
    const Rgb share = scene->transmittance(segment);
    EXPECT_NEAR(share.x, std::exp(-2.0f), 1e-6f);
    EXPECT_NEAR(share.y, std::exp(-1.0f), 1e-6f);
    EXPECT_NEAR(share.z, std::exp(-1.0f), 1e-6f);
}

TEST(Transmittance, StraightSurfacesInInstances) {
    SceneContents contents = instanced({pane(1, straight(Rgb(0.5f)))},
                                       {Matrix(), translation(0, 0, 1), translation(0, 9, 0)});
    contents.primitives = {pane(5, matte())};
    const auto scene = trace(std::move(contents));
    Ray segment = kUpwards;
    segment.t_max = 4;
    EXPECT_EQ(scene->transmittance(segment), Rgb(0.25f));
    EXPECT_EQ(scene->transmittance(kUpwards), Rgb(0.0f));
}

TEST(Transmittance, TooManySurfacesBlock) {
    // The walk is bounded: 200 surfaces pass, 300 count as blocked.
    std::vector<Primitive> panes;
    for (int i = 1; i <= 300; ++i)
        panes.push_back(pane(static_cast<float>(i), straight(Rgb(1.0f))));
    const auto scene = trace(std::move(panes));
    Ray segment = kUpwards;
    segment.t_max = 200.5f;
    EXPECT_EQ(scene->transmittance(segment), Rgb(1.0f));
    EXPECT_EQ(scene->transmittance(kUpwards), Rgb(0.0f));
}

}  // namespace
}  // namespace lxs::test::transmittance_test
