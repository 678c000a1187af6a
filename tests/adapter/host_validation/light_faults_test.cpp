// Faults of lights: each is planted in one of the scene's lights and found alone, with its name.
#include <gtest/gtest.h>

#include "aips/core/sampling/sampling.h"
#include "faulty_scene.h"
#include "scene_with_lights.h"

namespace aips::light_faults_test {
namespace {

enum class Fault {
    None,
    Power,        // power() leaves out 4 pi
    DeadPower,    // power() is 0
    Emission,     // photons carry 4 pi times as much
    Directions,   // photons go where no radiance goes
    Radiance,     // shadow rays bring twice the radiance
    PdfDirect,    // pdf_direct() is half of what sample_direct() says
    Density,      // both are half of the density
    Unasked,      // shadow rays go to half of the light alone
    Group,        // no such light group
    Coordinates,  // emission_coordinates() lead elsewhere
    NotFinite,    // photons carry NaN
    Escaped,      // rays that leave the scene see half
    Delta,        // is_delta() of a lamp that rays meet
};

class FaultyLight final : public mock::LightLike {
  public:
    FaultyLight(const Light& light, Fault fault) : LightLike(light), light_(light), fault_(fault) {}

    std::string name() const override { return "spoilt"; }
    std::uint32_t group() const override { return fault_ == Fault::Group ? 9 : light_.group(); }
    float power() const override {
        if (fault_ == Fault::DeadPower) return 0;
        return light_.power() / (fault_ == Fault::Power ? 4 * kPi : 1);
    }
    bool is_delta() const override { return fault_ == Fault::Delta; }
    bool emit(const PrimaryPoint& u, Emission& emission) const override {
        if (!light_.emit(u, emission)) return false;
        if (fault_ == Fault::Emission) emission.power *= 4 * kPi;
        Vec3& d = emission.ray.direction;
        if (fault_ == Fault::Directions && d.z < -0.3f) d.y = std::abs(d.y);
        if (fault_ == Fault::NotFinite) emission.power.r = std::numeric_limits<float>::infinity();
        return true;
    }
    bool sample_direct(const SurfacePoint& from, Vec2 u, DirectSample& sample) const override {
        if (fault_ == Fault::Unasked) u.x *= 0.5f;
        if (!light_.sample_direct(from, u, sample)) return false;
        if (fault_ == Fault::Radiance) sample.radiance *= 2;
        if (fault_ == Fault::Density) sample.pdf *= 0.5f;
        return true;
    }
    float pdf_direct(const SurfacePoint& from, Vec3 wi, const SurfacePoint* at) const override {
        const bool half = fault_ == Fault::PdfDirect || fault_ == Fault::Density;
        return light_.pdf_direct(from, wi, at) * (half ? 0.5f : 1);
    }
    bool emission_coordinates(const SurfacePoint& towards, const DirectSample& sample,
                              PrimaryPoint& u) const override {
        if (!light_.emission_coordinates(towards, sample, u)) return false;
        if (fault_ == Fault::Coordinates) std::swap(u[2], u[3]);
        return true;
    }
    Rgb escaped(Vec3 direction) const override {
        return light_.escaped(direction) * (fault_ == Fault::Escaped ? 0.5f : 1);
    }

  private:
    const Light& light_;
    Fault fault_;
};

/// An open room with a lamp and a sky (`sky`), whose last light is spoilt.
mock::Scene lit_room(bool sky) {
    mock::Scene scene;
    mock::Surface wall;
    wall.shape = mock::Quad{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
    scene.add(wall);
    wall.shape = mock::Ball{{0.5f, 0.5f, 0.5f}, 0.4f, false};
    scene.add(wall);
    if (sky) scene.add_distant_light({normalize({1, 1, 2}), 0.8f}, {2, 2, 1});
    mock::Surface lamp;
    lamp.shape = mock::Quad{{-1, -1, 2}, {0.2f, 1, 0}, {1, 0, 0.3f}};
    lamp.emitted = {3, 2, 1};
    if (!sky) scene.add(lamp);
    scene.finish();
    return scene;
}

std::vector<HostFinding> find(Fault fault, bool sky) {
    const mock::Scene scene = lit_room(sky);
    const FaultyLight light(*scene.lights()[0], fault);
    mock::FaultyScene faulty(scene, {});
    faulty.exchange_light(0, light);
    HostValidationSettings settings = mock::quick_check();
    settings.samples = 4096;
    return validate_host(faulty, settings);
}

struct Case {
    const char* name;
    Fault fault;
    bool sky;
    const char* check;
    const char* said;  ///< in what was found
};

class LightFaults : public testing::TestWithParam<Case> {};

TEST_P(LightFaults, AreNamed) {
    const auto findings = find(GetParam().fault, GetParam().sky);
    ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
    EXPECT_EQ(findings[0].subject, "light 0 \"spoilt\"");
    EXPECT_EQ(findings[0].check, GetParam().check) << mock::lines(findings);
    EXPECT_NE(findings[0].found.find(GetParam().said), std::string::npos) << mock::lines(findings);
}

INSTANTIATE_TEST_SUITE_P(
    Lamp, LightFaults,
    testing::Values(Case{"Power", Fault::Power, false, "power", "1 / (4 pi)"},
                    Case{"DeadPower", Fault::DeadPower, false, "power", "0 of a light"},
                    Case{"Emission", Fault::Emission, false, "emission", "(4 pi)"},
                    Case{"Directions", Fault::Directions, false, "directions of emission", ""},
                    Case{"Radiance", Fault::Radiance, false, "radiance", ""},
                    Case{"PdfDirect", Fault::PdfDirect, false, "pdf_direct", ""},
                    Case{"Density", Fault::Density, false, "density of directions", ""},
                    Case{"Group", Fault::Group, false, "group", "9"},
                    Case{"Coordinates", Fault::Coordinates, false, "emission_coordinates", ""},
                    Case{"NotFinite", Fault::NotFinite, false, "values", ""},
                    Case{"Delta", Fault::Delta, false, "is_delta", "delta false"}),
    [](const auto& each) { return std::string(each.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Sky, LightFaults,
    testing::Values(Case{"Power", Fault::Power, true, "power", "1 / (4 pi)"},
                    Case{"Emission", Fault::Emission, true, "emission", "(4 pi)"},
                    Case{"Directions", Fault::Directions, true, "directions of emission", ""},
                    Case{"Radiance", Fault::Radiance, true, "radiance", ""},
                    Case{"PdfDirect", Fault::PdfDirect, true, "pdf_direct", ""},
                    Case{"Density", Fault::Density, true, "density of directions", ""},
                    Case{"Coordinates", Fault::Coordinates, true, "emission_coordinates", ""},
                    Case{"Escaped", Fault::Escaped, true, "radiance", ""}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(LightFaults, NoneInSoundOnes) {
    for (const bool sky : {false, true}) {
        const auto findings = find(Fault::None, sky);
        EXPECT_TRUE(findings.empty()) << mock::lines(findings);
    }
}

TEST(LightFaults, VisibilityThroughWalls) {
    const mock::Scene scene = mock::lamp_box({}, {});
    mock::Spoils spoils;
    spoils.visibility = [](const auto&, const auto&) { return kWhite; };
    const auto findings = validate_host(mock::FaultyScene(scene, spoils), mock::quick_check());
    ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
    EXPECT_EQ(findings[0].check, "visibility");
}

/// The lamp's room, with a ball of this kind.
mock::Scene room_with(mock::Material::Kind kind) {
    mock::Material ball;
    ball.kind = kind;
    return mock::lamp_box({}, ball);
}

// What bends light lets none pass straight, whatever lobes it has.
TEST(LightFaults, VisibilityThroughGlass) {
    const mock::Scene with = room_with(mock::Material::Kind::Glass);
    const mock::Scene without = room_with(mock::Material::Kind::Null);
    const auto sound = validate_host(with, mock::quick_check());
    EXPECT_TRUE(sound.empty()) << mock::lines(sound);
    mock::Spoils spoils;
    spoils.visibility = [&](const SurfacePoint& point, const DirectSample& light) {
        return without.visibility(point, light, 0);
    };
    const auto findings = validate_host(mock::FaultyScene(with, spoils), mock::quick_check());
    ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
    EXPECT_EQ(findings[0].check, "visibility");
    EXPECT_NE(findings[0].found.find("through material"), std::string::npos) << findings[0].found;
}

TEST(LightFaults, NoVisibilityThroughWhatPassesStraight) {
    const mock::Scene scene = room_with(mock::Material::Kind::Null);
    const auto sound = validate_host(scene, mock::quick_check());
    EXPECT_TRUE(sound.empty()) << mock::lines(sound);
    for (const float share : {0.0f, 0.5f}) {
        mock::Spoils spoils;
        spoils.visibility = [&](const SurfacePoint& point, const DirectSample& light) {
            const Rgb passed = scene.visibility(point, light, 0);
            const Vec3 to_ball = Vec3{0.35f, 0.3f, -0.6f} - point.position;
            const float along = dot(to_ball, light.wi);
            const bool by =
                along > 0 && along < light.distance && length(to_ball - light.wi * along) < 0.4f;
            return by ? passed * share : passed;
        };
        const auto findings = validate_host(mock::FaultyScene(scene, spoils), mock::quick_check());
        ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
        EXPECT_EQ(findings[0].check, "visibility");
    }
}

// Rays see the back of the lamp, and neither shadow rays nor photons know of it.
TEST(LightFaults, LampSeenFromBehind) {
    const mock::Scene scene = lit_room(false);
    mock::Spoils spoils;
    spoils.point = [](SurfacePoint& point, auto&) {
        if (point.material != 2) return;
        point.light = 0;
        point.emitted = {3, 2, 1};
    };
    const auto findings = validate_host(mock::FaultyScene(scene, spoils), mock::quick_check());
    ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
    EXPECT_EQ(findings[0].subject.substr(0, 7), "light 0");
    EXPECT_EQ(findings[0].check, "missing directions");
}

}  // namespace
}  // namespace aips::light_faults_test
