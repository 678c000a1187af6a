// "coateddiffuse" against the random walk through its layers that it stands for, and against the
// closed form of a smooth coat.
#include <gtest/gtest.h>

#include <cmath>

#include "bsdf_statistics.h"
#include "bsdfs/directions.h"
#include "bsdfs/fresnel.h"
#include "bsdfs/trowbridge_reitz.h"
#include "shading_fixture.h"

namespace lxs::coated_diffuse_test {
namespace {

struct Layers {
    float kd, index, alpha, thickness;
};

std::shared_ptr<const Material> material(ShadingFixture& scene, const Layers& layers, int depth) {
    return scene.make_material(
        "coateddiffuse", {color("Kd", Rgb(layers.kd)), number("index", layers.index),
                          number("uroughness", layers.alpha), number("vroughness", layers.alpha),
                          number("thickness", layers.thickness), integer("maxdepth", depth)});
}

/// Weight of one walk from `wo` above the coat until it leaves again.
double walk(const Layers& layers, const Vec3& from, UniformSource& u) {
    const shading::TrowbridgeReitz facets(layers.alpha, layers.alpha);
    double weight = 1;
    Vec3 wo = from;
    bool outside = true;
    for (int i = 0; i < 400; ++i) {
        const float eta = outside ? layers.index : 1 / layers.index;
        const Vec3 h = facets.sample_visible(wo, u.pair());
        const float cosine = wo.dot(h);
        if (!(cosine > 0)) return 0;
        const bool reflects = u() < shading::fresnel_dielectric(cosine, eta);
        const float sine2 = (1 - cosine * cosine) / (eta * eta);
        const Vec3 wi = reflects ? shading::reflect(wo, h)
                                 : h * (cosine / eta - std::sqrt(1 - sine2)) - wo / eta;
        if (reflects != (wi.z > 0)) return 0;
        weight *= double(facets.seen_too(wo, wi));
        if (reflects == outside) return weight;
        // Down through the layer, off the base, and up again.
        weight *= layers.kd * std::exp(-layers.thickness / std::abs(wi.z));
        const float up = std::sqrt(u());
        weight *= std::exp(-layers.thickness / up);
        wo = Vec3(std::sqrt(1 - up * up), 0, up);
        outside = false;
    }
    return 0;
}

class CoatedDiffuseTest : public ::testing::Test {
  protected:
    ShadingFixture scene_;
    BsdfMemory memory_;
};

class CoatedDiffuseWalk : public CoatedDiffuseTest, public ::testing::WithParamInterface<Layers> {};

// Twelve comparisons by a table of linear steps: z below 4, and half a percent for the steps.
TEST_P(CoatedDiffuseWalk, IsTheRandomWalk) {
    const Layers& layers = GetParam();
    const auto coated = material(scene_, layers, 1000);
    const Bsdf& bsdf = *memory_.scatter(*coated, shading_point());
    UniformSource u(5);
    for (const float cosine : {0.95f, 0.6f, 0.25f}) {
        const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
        constexpr int kWalks = 200000;
        double sum = 0, squares = 0;
        for (int i = 0; i < kWalks; ++i) {
            const double weight = walk(layers, wo, u);
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / kWalks;
        const double error = std::sqrt((squares / kWalks - mean * mean) / kWalks);
        const MeanWeight found = mean_weight(bsdf, wo, Transport::Radiance, 200000, 7);
        EXPECT_NEAR(found.mean.x, mean,
                    4 * std::hypot(error, double(found.deviation.x)) + 0.005 * mean)
            << cosine;
    }
}

INSTANTIATE_TEST_SUITE_P(Layers, CoatedDiffuseWalk,
                         ::testing::Values(Layers{0.8f, 1.5f, 0.05f, 0.01f},
                                           Layers{0.5f, 1.5f, 0.5f, 0}, Layers{0.9f, 2, 0.3f, 0.2f},
                                           Layers{0.3f, 1.3f, 0.9f, 1}));

TEST_F(CoatedDiffuseTest, ASmoothCoatHasAClosedForm) {
    // Of grey 0.5 under an index of 1.5, whose underside throws back 0.5963 of diffuse light.
    const auto grey = material(scene_, {0.5f, 1.5f, 0, 0}, 1000);
    const Bsdf& bsdf = *memory_.scatter(*grey, shading_point());
    const MeanWeight found = mean_weight(bsdf, {0, 0, 1}, Transport::Radiance, 100000, 3);
    EXPECT_NEAR(found.mean.x, 0.04 + 0.96 * 0.5 * (1 - 0.5963) / (1 - 0.5 * 0.5963), 0.003);
    // White loses nothing, though little of it gets through a dense coat at once.
    for (const float index : {1.5f, 2.0f, 2.42f, 3.0f}) {
        const auto bright = material(scene_, {1, index, 0, 0}, 100000);
        const Bsdf& white = *memory_.scatter(*bright, shading_point());
        for (const float cosine : {1.0f, 0.5f}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
            EXPECT_NEAR(mean_weight(white, wo, Transport::Radiance, 100000, 4).mean.x, 1, 0.012)
                << index << ", " << cosine;
        }
    }
}

// Where the roughness varies the coat's table has rows, between which it goes in lines.
TEST_F(CoatedDiffuseTest, RoughnessByATextureIsThatByANumber) {
    for (const float roughness : {0.1f, 0.42f}) {
        scene_.floats["rough"] =
            scene_.make_float("bilerp", {number("v00", roughness), number("v01", roughness),
                                         number("v10", roughness), number("v11", roughness)});
        const auto varying = scene_.make_material(
            "coateddiffuse", {texture("uroughness", "rough"), texture("vroughness", "rough")});
        const Bsdf& by_texture = *memory_.scatter(*varying, shading_point());
        const auto constant = material(scene_, {0.5f, 1.5f, roughness, 0.01f}, 10);
        const Bsdf& by_number = *memory_.scatter(*constant, shading_point());
        for (const float cosine : {0.9f, 0.3f}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
            const float a = by_texture.albedo(wo, kDiffuse).x, b = by_number.albedo(wo, kDiffuse).x;
            EXPECT_NEAR(a, b, 0.01f * b) << roughness << ", " << cosine;
        }
    }
}

}  // namespace
}  // namespace lxs::coated_diffuse_test
