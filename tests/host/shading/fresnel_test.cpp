// Fresnel terms against closed forms.
#include "bsdfs/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lxs::shading::fresnel_test {
namespace {

TEST(Fresnel, NormalIncidenceOfGlass) {
    EXPECT_NEAR(fresnel_dielectric(1, 1.5f), 0.04f, 1e-6f);
    EXPECT_NEAR(fresnel_dielectric(1, 1 / 1.5f), 0.04f, 1e-6f);
}

TEST(Fresnel, GrazingIncidenceReflectsAll) {
    EXPECT_FLOAT_EQ(fresnel_dielectric(0, 1.5f), 1);
    EXPECT_FLOAT_EQ(fresnel_conductor(0, {Rgb(0.2f), Rgb(3.0f), true}).x, 1);
}

TEST(Fresnel, TotalReflectionInsideGlass) {
    const float critical = std::sqrt(1 - 1 / (1.5f * 1.5f));
    EXPECT_EQ(fresnel_dielectric(critical - 0.01f, 1 / 1.5f), 1);
    EXPECT_LT(fresnel_dielectric(critical + 0.01f, 1 / 1.5f), 1);
}

TEST(Fresnel, EqualIndicesReflectNothing) {
    for (const float c : {0.01f, 0.4f, 1.0f})
        EXPECT_NEAR(fresnel_dielectric(c, 1), 0, 1e-6f);
}

// A conductor without extinction is a dielectric: the two formulas are independent.
TEST(Fresnel, ConductorFormulaAgreesWithDielectric) {
    const FresnelValue glass{Rgb(1.7f), Rgb(0.0f), false};
    for (int i = 1; i <= 100; ++i) {
        const float c = 0.01f * static_cast<float>(i);
        EXPECT_NEAR(fresnel_conductor(c, glass).x, fresnel_dielectric(c, 1.7f), 2e-5f) << c;
    }
}

TEST(Fresnel, NormalIncidenceOfMetal) {
    const float n = 0.2f, k = 3.4f;
    const float expected = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    EXPECT_NEAR(fresnel_conductor(1, {Rgb(n), Rgb(k), true}).x, expected, 1e-6f);
}

TEST(Fresnel, ColouredMetalIsFiniteForAllReflectances) {
    const FresnelValue value = fresnel_from_reflectance({0, 0.5f, 1});
    const Rgb reflectance = fresnel_conductor(1, value);
    EXPECT_EQ(reflectance.x, 0);
    EXPECT_GT(reflectance.z, 0.99f);
    EXPECT_LE(reflectance.z, 1);
}

}  // namespace
}  // namespace lxs::shading::fresnel_test
