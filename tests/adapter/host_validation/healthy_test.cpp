// Sound hosts are left alone, whatever the seed.
#include <gtest/gtest.h>

#include "faulty_scene.h"
#include "random_scenes.h"

namespace aips::healthy_test {
namespace {

TEST(SoundHosts, RoomsOfAllMaterials) {
    mock::Material glass, phong, null;
    glass.kind = mock::Material::Kind::Glass;
    phong.kind = mock::Material::Kind::Phong;
    null.kind = mock::Material::Kind::Null;
    for (const mock::Material& ball : {mock::Material{}, mock::half_mirror(), glass, phong, null}) {
        const auto findings = validate_host(mock::lamp_box({}, ball));
        EXPECT_TRUE(findings.empty()) << mock::lines(findings);
    }
}

TEST(SoundHosts, RandomScenes) {
    for (std::uint64_t number = 0; number < 24; ++number) {
        mock::RandomSceneKind kind;
        kind.open = number % 2;
        const mock::View view = mock::random_view(number, kind, 32, 32);
        HostValidationSettings settings = mock::quick_check();
        settings.seed = number;
        const auto findings = validate_host(view.scene, settings);
        EXPECT_TRUE(findings.empty()) << number << ": " << mock::lines(findings);
    }
}

TEST(SoundHosts, NarrowLobes) {
    mock::Material phong;
    phong.kind = mock::Material::Kind::Phong;
    for (const float exponent : {300.0f, 30'000.0f}) {
        phong.exponent = exponent;
        const auto findings = validate_host(mock::lamp_box(phong, phong), mock::quick_check());
        EXPECT_TRUE(findings.empty()) << exponent << ": " << mock::lines(findings);
    }
}

TEST(SoundHosts, SameSeedSameFindings) {
    const mock::Scene scene = mock::lamp_box({}, mock::half_mirror());
    mock::Spoils spoils;
    spoils.facts = [](SceneFacts& facts) { facts.max_bsdf_bytes = 0; };
    const mock::FaultyScene faulty(scene, spoils);
    const auto once = validate_host(faulty, mock::quick_check());
    ASSERT_EQ(once.size(), 1u);
    EXPECT_EQ(mock::lines(once), mock::lines(validate_host(faulty, mock::quick_check())));
}

}  // namespace
}  // namespace aips::healthy_test
