// "glossy" with "conserving": white loses nothing in a white furnace, at any roughness and angle,
// on either side; and its coat is Fresnel's.
#include <gtest/gtest.h>

#include <cmath>

#include "bsdf_statistics.h"
#include "shading_fixture.h"

namespace lxs::conserving_test {
namespace {

class ConservingTest : public ::testing::Test {
  protected:
    const Bsdf& coated(const Rgb& kd, float ks, float roughness, const char* fresnel) {
        material_ = scene_.make_material(
            "glossy",
            {color("Kd", kd), color("Ks", Rgb(ks)), number("uroughness", roughness),
             number("vroughness", roughness), flag("conserving", true), text("fresnel", fresnel)});
        return *memory_.scatter(*material_, shading_point());
    }
    /// What comes from `wo` where light of 1 comes from everywhere.
    static float furnace(const Bsdf& bsdf, const Vec3& wo) {
        constexpr int kSide = 160;
        double sum = 0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const float row = static_cast<float>(i / kSide), column = static_cast<float>(i % kSide);
            const float choice = 0.61803399f * static_cast<float>(i);
            BsdfSample sample;
            if (bsdf.sample(wo, {(row + 0.5f) / kSide, (column + 0.5f) / kSide},
                            choice - std::floor(choice), Transport::Radiance, kAllLobes, sample))
                sum += sample.weight.y;
        }
        return static_cast<float>(sum / (kSide * kSide));
    }
    static Vec3 at(float cosine, float side) {
        return Vec3(std::sqrt(1 - cosine * cosine), 0, side * cosine);
    }

    ShadingFixture scene_;
    BsdfMemory memory_;
    std::shared_ptr<const Material> material_;
};

TEST_F(ConservingTest, WhiteIsWhite) {
    for (const char* fresnel : {"dielectric", "schlick"}) {
        for (const float ks : {0.0f, 0.04f, 0.2f}) {
            for (const float roughness : {0.01f, 0.1f, 0.25f, 0.64f, 1.0f}) {
                const Bsdf& bsdf = coated(Rgb(1.0f), ks, roughness, fresnel);
                for (const float cosine : {0.1f, 0.35f, 0.7f, 1.0f}) {
                    for (const float side : {1.0f, -1.0f})
                        EXPECT_NEAR(furnace(bsdf, at(cosine, side)), 1, 0.02)
                            << fresnel << ", Ks " << ks << ", roughness " << roughness
                            << ", cosine " << cosine << ", side " << side;
                }
            }
        }
    }
}

TEST_F(ConservingTest, MetalsLoseNothingEither) {
    for (const float roughness : {0.01f, 0.25f, 1.0f}) {
        const Bsdf& bsdf = coated(Rgb(0.0f), 1, roughness, "schlick");
        for (const float cosine : {0.2f, 0.9f})
            EXPECT_NEAR(furnace(bsdf, at(cosine, 1)), 1, 0.02) << roughness << ", " << cosine;
    }
}

TEST_F(ConservingTest, ASmoothCoatIsFresnels) {
    const Bsdf& bsdf = coated(Rgb(0.0f), 0.04f, 0.006f, "dielectric");
    // Unpolarised light on glass of index 1.5.
    for (const auto& [degrees, reflected] :
         {std::pair(0.0f, 0.04f), std::pair(60.0f, 0.0892f), std::pair(75.0f, 0.2531f)}) {
        const float cosine = std::cos(degrees * 3.14159265f / 180);
        EXPECT_NEAR(furnace(bsdf, at(cosine, 1)), reflected, 0.03f * reflected) << degrees;
    }
}

}  // namespace
}  // namespace lxs::conserving_test
