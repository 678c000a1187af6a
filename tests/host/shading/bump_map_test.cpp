// Bump and normal maps: tilted normals against closed forms, Bsdfs about them, both transports.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bsdf_statistics.h"
#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"
#include "materials/bumped_material.h"
#include "shading_fixture.h"
#include "temporary_folder.h"

namespace lxs::bump_map_test {
namespace {

using shading::bumped_normal;

constexpr float kStep = 1e-3f;

/// height = amplitude sin(frequency u) cos(frequency v).
class Waves final : public FloatTexture {
  public:
    Waves(float amplitude, float frequency) : amplitude_(amplitude), frequency_(frequency) {}
    float evaluate(const TexturePoint& point) const override {
        return amplitude_ * std::sin(frequency_ * point.uv.x) * std::cos(frequency_ * point.uv.y);
    }
    Vec2 gradient(const Vec2& uv) const {
        const float a = amplitude_ * frequency_;
        return {a * std::cos(frequency_ * uv.x) * std::cos(frequency_ * uv.y),
                -a * std::sin(frequency_ * uv.x) * std::sin(frequency_ * uv.y)};
    }

  private:
    float amplitude_, frequency_;
};

/// height = slope . p: what a three-dimensional texture is.
class Ramp final : public FloatTexture {
  public:
    explicit Ramp(const Vec3& slope) : slope_(slope) {}
    float evaluate(const TexturePoint& point) const override { return slope_.dot(point.p); }

  private:
    Vec3 slope_;
};

void expect_near(const Vec3& a, const Vec3& b, float tolerance) {
    EXPECT_LT((a - b).length(), tolerance) << a << " and " << b;
}

/// A point of the plane z = 0 with coordinates along the two tangents.
ShadingPoint plane_point(const Vec3& dpdu, const Vec3& dpdv, const Vec2& uv) {
    ShadingPoint point = shading_point({0, 0, 1}, {0, 0, 1}, dpdu);
    point.dpdv = dpdv;
    point.texture.uv = uv;
    point.texture.p = dpdu * uv.x + dpdv * uv.y;
    return point;
}

TEST(BumpedNormal, WavesOnAPlaneHaveTheirGradient) {
    const Waves waves(0.3f, 2.5f);
    // Plain, stretched, skewed and mirrored coordinates.
    const Vec3 tangents[][2] = {{{1, 0, 0}, {0, 1, 0}},
                                {{0, 3, 0}, {-0.5f, 0, 0}},
                                {{2, 0, 0}, {1, 3, 0}},
                                {{1, 1, 0}, {1, -2, 0}}};
    for (const auto& [dpdu, dpdv] : tangents) {
        for (const Vec2& uv : {Vec2(0.1f, 0.2f), Vec2(0.7f, -0.4f), Vec2(1.9f, 1.1f)}) {
            const Vec2 g = waves.gradient(uv);
            // (hx, hy) solves hx dpdu.x + hy dpdu.y = hu, hx dpdv.x + hy dpdv.y = hv.
            const float det = dpdu.x * dpdv.y - dpdu.y * dpdv.x;
            const float hx = (g.x * dpdv.y - g.y * dpdu.y) / det;
            const float hy = (g.y * dpdu.x - g.x * dpdv.x) / det;
            const Vec3 normal = bumped_normal(waves, kStep, plane_point(dpdu, dpdv, uv));
            expect_near(normal, Vec3(-hx, -hy, 1).normalized(), 1e-3f);
        }
    }
}

TEST(BumpedNormal, TexturesInSpaceNeedNoCoordinates) {
    const Ramp ramp({0.5f, -0.25f, 3});
    ShadingPoint point = shading_point();
    point.dpdu = Vec3(0.0f);
    expect_near(bumped_normal(ramp, kStep, point), Vec3(-0.5f, 0.25f, 1).normalized(), 1e-4f);
}

TEST(BumpedNormal, HeightsRiseFromTheFront) {
    // Seen from behind the same ramp leans the other way.
    ShadingPoint point = shading_point({0, 0, -1}, {0, 0, -1});
    expect_near(bumped_normal(Ramp({0.5f, 0, 0}), kStep, point), Vec3(-0.5f, 0, -1).normalized(),
                1e-4f);
}

TEST(BumpedNormal, StaysOnTheGeometricSide) {
    const ShadingPoint point = shading_point({0.9f, 0, 0.3f}, {0, 0, 1});
    for (const float slope : {-30.0f, -1.0f, 0.5f, 4.0f, 1e30f}) {
        const Vec3 normal = bumped_normal(Ramp({slope, 0, 0}), kStep, point);
        EXPECT_GT(normal.dot(point.ng), 0);
        EXPECT_NEAR(normal.length(), 1, 1e-5f);
    }
}

class NormalMapTest : public ::testing::Test {
  protected:
    std::shared_ptr<const FloatTexture> map_of(const Rgb& color) {
        const std::string path = folder_ / "normal.exr";
        const auto out = OIIO::ImageOutput::create(path);
        EXPECT_TRUE(out && out->open(path, OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::FLOAT)));
        EXPECT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, &color.x));
        out->close();
        return scene_.make_float("normalmap", {text("filename", path)});
    }

    files::TemporaryFolder folder_;
    ShadingFixture scene_;
};

TEST_F(NormalMapTest, ColoursAreTangentSpaceNormals) {
    const Vec3 normal = Vec3(0.3f, -0.2f, 0.8f).normalized();
    const auto map = map_of((normal + Vec3(1, 1, 1)) * 0.5f);
    EXPECT_EQ(map->evaluate({}), 0);  // not a height
    EXPECT_FALSE(map->constant());
    const ShadingPoint straight = plane_point({2, 0, 0}, {0, 5, 0}, {0, 0});
    expect_near(bumped_normal(*map, kStep, straight), normal, 1e-5f);
    // v the other way round, and u along y.
    const ShadingPoint turned = plane_point({0, 1, 0}, {1, 0, 0}, {0, 0});
    expect_near(bumped_normal(*map, kStep, turned), {normal.y, normal.x, normal.z}, 1e-5f);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
}

TEST_F(NormalMapTest, IsWeakenedAndMixedLikeAnyHeight) {
    const auto map = map_of({0.7f, 0.5f, 0.9f});  // slope -0.4 / 0.8 along u
    scene_.floats["map"] = map;
    scene_.floats["ramp"] = std::make_shared<Ramp>(Vec3(0, 0.6f, 0));
    const ShadingPoint point = plane_point({1, 0, 0}, {0, 1, 0}, {0, 0});
    const auto half = scene_.make_float("scale", {texture("tex1", "map"), number("tex2", 0.5)});
    expect_near(bumped_normal(*half, kStep, point), Vec3(0.25f, 0, 1).normalized(), 1e-4f);
    const auto both = scene_.make_float(
        "mix", {texture("tex1", "map"), texture("tex2", "ramp"), number("amount", 0.25)});
    expect_near(bumped_normal(*both, kStep, point),
                Vec3(0.5f * 0.75f, -0.6f * 0.25f, 1).normalized(), 1e-4f);
}

class BumpedMaterialTest : public ::testing::Test {
  protected:
    BumpedMaterialTest() {
        scene_.floats["ramp"] = std::make_shared<Ramp>(Vec3(0.6f, -0.3f, 0));
        matte_ =
            scene_.make_material("matte", {color("Kd", Rgb(0.8f)), texture("bumpmap", "ramp")});
    }

    ShadingFixture scene_;
    BsdfMemory memory_;
    std::shared_ptr<const Material> matte_;
    const Vec3 tilted_ = Vec3(-0.6f, 0.3f, 1).normalized();
};

TEST_F(BumpedMaterialTest, HandsItsNormalToTheIntegrator) {
    EXPECT_TRUE(matte_->facts().bends);
    ShadingPoint point = shading_point();
    matte_->bend(point);
    expect_near(point.ns, tilted_, 1e-4f);
    const Bsdf& bsdf = *memory_.scatter(*matte_, point);
    const Vec3 wi = Vec3(0.2f, 0.5f, 0.7f).normalized();
    EXPECT_NEAR(bsdf.pdf({0, 0, 1}, wi, kAllLobes), wi.dot(tilted_) * kInvPi, 1e-4f);
}

// The side that the tilted normal turns away from light stays dark, and is dark both ways.
TEST_F(BumpedMaterialTest, DoesNotReflectAcrossTheTiltedPlane) {
    ShadingPoint point = shading_point();
    matte_->bend(point);
    const Bsdf& bsdf = *memory_.scatter(*matte_, point);
    const Vec3 below = Vec3(0.9f, -0.4f, 0.1f).normalized();
    ASSERT_LT(below.dot(tilted_), 0);
    const Vec3 above(0, 0, 1);
    for (const Transport transport : {Transport::Radiance, Transport::Power}) {
        EXPECT_EQ(bsdf.evaluate(above, below, transport, kAllLobes), Rgb(0.0f));
        EXPECT_EQ(bsdf.evaluate(below, above, transport, kAllLobes), Rgb(0.0f));
    }
    EXPECT_GT(chi_square_p_value(bsdf, above, point.ng, kAllLobes, 7), 1e-4);
    EXPECT_GT(chi_square_p_value(bsdf, below, point.ng, kAllLobes, 8), 1e-4);
}

TEST_F(BumpedMaterialTest, PartsOfAMixKeepTheirOwnBumps) {
    scene_.materials["bumped"] = matte_;
    scene_.materials["flat"] = scene_.make_material("matte", {color("Kd", Rgb(0.4f))});
    const auto mix = scene_.make_material(
        "mix",
        {text("namedmaterial1", "bumped"), text("namedmaterial2", "flat"), number("amount", 0.25)});
    ASSERT_TRUE(mix->facts().bends);
    ShadingPoint point = shading_point();
    mix->bend(point);
    expect_near(point.ns, {0, 0, 1}, 1e-6f);
    const Bsdf& bsdf = *memory_.scatter(*mix, point);
    const Vec3 wo = Vec3(0.3f, -0.4f, 0.6f).normalized();
    UniformSource u(1);
    for (int i = 0; i < 100; ++i) {
        Vec3 wi = u.direction();
        wi.z = std::abs(wi.z) + 1e-3f;
        wi.normalize();
        const float expected =
            kInvPi * (0.75f * 0.8f * std::max(0.0f, wi.dot(tilted_)) + 0.25f * 0.4f * wi.z);
        const Rgb f = bsdf.evaluate(wo, wi, Transport::Radiance, kAllLobes);
        ASSERT_NEAR(f.x * wi.z, expected, 2e-4f);
        // What an integrator makes of the photon's side: f |wo.ns| |wi.ng| / |wo.ng|.
        const Rgb adjoint = bsdf.evaluate(wi, wo, Transport::Power, kAllLobes);
        ASSERT_NEAR(adjoint.x * wi.z, expected, 2e-4f);
    }
}

TEST_F(BumpedMaterialTest, SamplingAboutTheOwnNormalFollowsItsDensity) {
    const ShadingPoint point = shading_point();
    const Bsdf& bsdf = *memory_.scatter(*matte_, point);
    const Vec3 wo = Vec3(0.3f, -0.4f, 0.6f).normalized();
    EXPECT_GT(chi_square_p_value(bsdf, wo, point.ng, kAllLobes, 5), 1e-4);
    UniformSource u(3);
    for (const Transport transport : {Transport::Radiance, Transport::Power}) {
        for (int i = 0; i < 1000; ++i) {
            BsdfSample sample;
            const Vec2 uv = u.pair();
            if (!bsdf.sample(wo, uv, u(), transport, kAllLobes, sample)) continue;
            const float weight = bsdf.evaluate(wo, sample.wi, transport, kAllLobes).x *
                                 std::abs(sample.wi.z) / sample.pdf;
            ASSERT_NEAR(sample.weight.x, weight, 1e-3f * weight);
        }
    }
}

TEST_F(BumpedMaterialTest, MirrorsReflectAboutTheTiltedNormalEitherWay) {
    const auto mirror = scene_.make_material("mirror", {texture("bumpmap", "ramp")});
    const Vec3 wo = Vec3(0.1f, 0.2f, 0.9f).normalized();
    const Vec3 expected = tilted_ * (2 * wo.dot(tilted_)) - wo;
    ShadingPoint point = shading_point();
    for (const bool bend : {false, true}) {
        if (bend) mirror->bend(point);
        BsdfSample sample;
        ASSERT_TRUE(memory_.scatter(*mirror, point)
                        ->sample(wo, {0, 0}, 0, Transport::Radiance, kAllLobes, sample));
        expect_near(sample.wi, expected, 1e-4f);
    }
}

TEST_F(BumpedMaterialTest, ConstantHeightsCostNothing) {
    scene_.floats["flat"] = scene_.make_float("constant", {number("value", 3)});
    const auto plain = scene_.make_material("matte", {texture("bumpmap", "flat")});
    EXPECT_FALSE(plain->facts().bends);
}

TEST_F(BumpedMaterialTest, GlassInShadowRaysHasTheTiltedCosine) {
    const auto glass =
        scene_.make_material("glass", {flag("architectural", true), texture("bumpmap", "ramp")});
    const auto plain = scene_.make_material("glass", {flag("architectural", true)});
    const Vec3 direction(0, 0, 1);
    ShadingPoint tilted = shading_point();
    tilted.ns = tilted_;
    EXPECT_NEAR(glass->straight_transmittance(shading_point(), direction).x,
                plain->straight_transmittance(tilted, direction).x, 1e-5f);
}

}  // namespace
}  // namespace lxs::bump_map_test
