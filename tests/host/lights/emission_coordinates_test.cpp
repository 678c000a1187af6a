// Protects Light::emission_coordinates: a photon emitted from them goes through the point for
// which direct light was sampled, from the light point that was sampled.
#include <gtest/gtest.h>

#include <cmath>

#include "light_cases.h"

namespace lxs::test::emission_coordinates_test {
namespace {

/// Values that no light writes, to see which coordinates it left alone.
constexpr PrimaryPoint kUntouched = {0.11, 0.22, 0.33, 0.44};

struct Case {
    std::string name;
    std::unique_ptr<Light> light;
};

/// A fan of 40 triangles of unlike sizes; every third one has no area.
TriangleMesh fan() {
    TriangleMesh mesh;
    mesh.positions.push_back(Vec3(0, 0, 2.5f));
    for (std::uint32_t i = 0; i <= 40; ++i) {
        const float angle = 0.0037f * static_cast<float>(i * i);
        mesh.positions.push_back(Vec3(std::cos(angle), std::sin(angle), 2));
    }
    for (std::uint32_t i = 0; i < 40; ++i) {
        const std::uint32_t third = i % 3 == 2 ? 0 : i + 1;
        mesh.indices.insert(mesh.indices.end(), {0, i + 2, third});
    }
    return mesh;
}

std::unique_ptr<Light> area(Geometry geometry) {
    return make_area_light(emissive(std::move(geometry), Rgb(1.0f)), Matrix());
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (ExtendedLight& c : extended_lights())
        all.push_back({c.name, std::move(c.light)});
    all.push_back({"fan", area(fan())});
    const Matrix tilted = Matrix().setEulerAngles(Imath::V3d(2, 0.4, 0.3)) * translation(0, 0, 2);
    all.push_back({"slice of a disk", area(placed(Disk{0.1f, 1, 0.2f, 120}, tilted))});
    all.push_back({"slice of a sphere", area(placed(Sphere{1, -0.3f, 0.8f, 200}, tilted))});
    all.push_back({"point", make_one("point", {numbers("point", "from", {0.1, 0.2, 0.3})})});
    all.push_back({"spot", make_one("spot", {numbers("float", "coneangle", {50}),
                                             numbers("float", "conedeltaangle", {30})})});
    all.push_back({"hard spot", make_one("spot", {numbers("float", "coneangle", {40}),
                                                  numbers("float", "conedeltaangle", {0})})});
    all.push_back({"goniometric", make_one("goniometric", {text("mapname", probe_image())})});
    all.push_back({"projection", make_one("projection", {text("mapname", probe_image()),
                                                         numbers("float", "fov", {120})})});
    all.push_back({"distant", make_one("distant", {numbers("point", "to", {1, 2, 3})})});
    all.push_back({"sky2", make_one("sky2", {})});
    return all;
}

/// Uniform in the ball that the scene fills.
Vec3 random_point(Random& random) {
    const SceneSphere sphere = scene_sphere();
    for (;;) {
        const Vec3 p(2 * random() - 1, 2 * random() - 1, 2 * random() - 1);
        if (p.length2() < 1) return sphere.center + p * sphere.radius;
    }
}

double distance_to_ray(const Vec3& p, const Ray& ray) {
    const Imath::V3d to = Imath::V3d(p) - Imath::V3d(ray.origin), d(ray.direction);
    const double along = to ^ d;
    return along > 0 ? (to - d * along).length() : to.length();
}

/// How far a ray may miss, as a share of its length. Rounding of coordinates shows where the map is
/// steep: at a spot's edge, and for directions grazing a surface.
double tolerance(const Light& light) {
    if (light.kind() == "spot") return 1e-3;
    if (light.kind() == "goniometric") return 2e-4;  // angles from the pole, by their cosine
    return light.kind() == "area" ? 5e-4 : 1e-5;
}

/// One point that the light lights: false if no coordinates were found.
bool check(const Light& light, const Vec3& p, const DirectSample& sample) {
    PrimaryPoint u = kUntouched;
    if (!light.emission_coordinates(p, sample, u)) return false;
    for (const double x : u)
        EXPECT_TRUE(x >= 0 && x < 1) << x;
    EmissionSample emission;
    EXPECT_TRUE(light.sample_emission(u, emission));
    const bool far_away = !std::isfinite(sample.distance);
    const double length = far_away ? 2 * scene_sphere().radius : sample.distance;
    EXPECT_LT(distance_to_ray(p, emission.ray), tolerance(light) * length);
    EXPECT_NEAR((emission.ray.direction + sample.wi).length(), 0, 2e-3);
    if (!far_away) {
        EXPECT_LT((emission.ray.origin - sample.segment_end).length(), 1e-4 + 1e-5 * length);
    }
    return true;
}

TEST(EmissionCoordinates, PhotonsGoFromTheSampledPointThroughTheLitOne) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        Random random(61);
        int lit = 0, found = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vec3 p = random_point(random);
            DirectSample sample;
            const Vec2 u(random(), random());
            if (!c.light->sample_direct(p, Vec3(0, 0, 1), u, sample)) continue;
            // Where a spot fades below a thousandth its rounding exceeds the tolerance.
            const float d2 = sample.distance * sample.distance;
            if (c.light->kind() == "spot" && !(sample.radiance.x * d2 > 1e-3f)) continue;
            ++lit;
            found += check(*c.light, p, sample) ? 1 : 0;
            if (HasFailure()) return;
        }
        EXPECT_GT(lit, 500);
        // Rounding may put a light point behind an edge, or a direction beyond a cone's rim.
        EXPECT_GE(found, 0.998 * lit);
    }
}

/// A hit on the light has the mesh's own count, in which triangles without area have numbers too.
TEST(EmissionCoordinates, TrianglesAreCountedAsInTheMesh) {
    const auto light = area(fan());
    Random random(83);
    std::array<int, 40> drawn{};
    for (int i = 0; i < 20000; ++i) {
        DirectSample sample;
        const Vec2 u(random(), random());
        if (!light->sample_direct(Vec3(0.0f), Vec3(0, 0, 1), u, sample)) continue;
        ASSERT_LT(sample.primitive, drawn.size());
        ++drawn[sample.primitive];
    }
    for (std::size_t i = 1; i < drawn.size(); ++i)
        EXPECT_EQ(drawn[i] > 0, i % 3 != 2) << i;
}

TEST(EmissionCoordinates, OnesThatDoNotMatterStay) {
    const auto coordinates = [](const Light& light) {
        const Vec3 p(0.5f, 0.4f, 1);
        DirectSample sample;
        PrimaryPoint u = kUntouched;
        EXPECT_TRUE(light.sample_direct(p, Vec3(0, 0, 1), Vec2(0.5f, 0.5f), sample));
        EXPECT_TRUE(light.emission_coordinates(p, sample, u));
        return u;
    };
    const auto point = coordinates(*make_one("point", {}));
    EXPECT_EQ(point[0], kUntouched[0]);
    EXPECT_EQ(point[1], kUntouched[1]);
    const auto distant = coordinates(*make_one("distant", {}));
    EXPECT_EQ(distant[2], kUntouched[2]);
    EXPECT_EQ(distant[3], kUntouched[3]);
}

/// Nothing may be found for a point that the light does not reach, whatever sample is shown.
TEST(EmissionCoordinates, NoneWhereNoLightArrives) {
    const auto none = [](const Light& light, const Vec3& p, const DirectSample& sample) {
        PrimaryPoint u = kUntouched;
        return !light.emission_coordinates(p, sample, u);
    };
    DirectSample sample;
    const auto panel = area(parallelogram(Vec3(-1, -1, 2), Vec3(0, 2, 0), Vec3(2, 0, 0)));
    ASSERT_TRUE(panel->sample_direct(Vec3(0.0f), Vec3(0, 0, 1), Vec2(0.3f, 0.6f), sample));
    EXPECT_FALSE(none(*panel, Vec3(0.0f), sample));
    EXPECT_TRUE(none(*panel, Vec3(0, 0, 4), sample)) << "behind the panel";
    sample.primitive = 2;
    EXPECT_TRUE(none(*panel, Vec3(0.0f), sample)) << "no such triangle";

    const auto ball = area(placed(Sphere{1, -1, 1, 360}, Matrix()));
    ASSERT_TRUE(ball->sample_direct(Vec3(0, 0, 3), Vec3(0, 0, 1), Vec2(0.3f, 0.6f), sample));
    EXPECT_TRUE(none(*ball, Vec3(0, 0, -3), sample)) << "behind the ball";

    const auto spot = make_one("spot", {});
    ASSERT_TRUE(spot->sample_direct(Vec3(0, 0, 1), Vec3(0, 0, 1), Vec2(0.5f), sample));
    EXPECT_TRUE(none(*spot, Vec3(1, 0, 0.1f), sample)) << "outside of the cone";
    EXPECT_TRUE(none(*spot, Vec3(0.0f), sample)) << "at the light";

    const auto sun = make_one("sun", {numbers("vector", "sundir", {0, 0, 1})});
    ASSERT_TRUE(sun->sample_direct(Vec3(0.0f), Vec3(0, 0, 1), Vec2(0.5f), sample));
    EXPECT_FALSE(none(*sun, Vec3(0.0f), sample));
    EXPECT_TRUE(none(*sun, Vec3(5, 0, 0), sample)) << "beyond the scene";
    sample.wi = Vec3(0, 1, 0);
    EXPECT_TRUE(none(*sun, Vec3(0.0f), sample)) << "not in the sun";

    const Rgb black(0.0f);
    const auto dark = make_area_light(
        emissive(parallelogram(Vec3(-1, -1, 2), Vec3(0, 2, 0), Vec3(2, 0, 0)), black), Matrix());
    dark->sample_direct(Vec3(0.0f), Vec3(0, 0, 1), Vec2(0.3f, 0.6f), sample);
    EXPECT_TRUE(none(*dark, Vec3(0.0f), sample)) << "black panel";
    const auto color = [](double v) { return numbers("color", "L", {v, v, v}); };
    sample.wi = Vec3(0, 0, 1);
    EXPECT_TRUE(none(*make_one("infinite", {color(0)}), Vec3(0.0f), sample)) << "black sky";
    EXPECT_TRUE(none(*make_one("distant", {color(0)}), Vec3(0.0f), sample)) << "black distant";
}

}  // namespace
}  // namespace lxs::test::emission_coordinates_test
