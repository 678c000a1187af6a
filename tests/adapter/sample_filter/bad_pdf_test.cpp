// Protects guided bounces from surfaces whose densities are wrong: what a pdf of zero, NaN or
// infinity makes of a photon is refused and counted, and nothing but finite power is stored,
// learned from or shown.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eye/light_choice.h"
#include "photons/cosine_directions.h"
#include "photons/photon_iteration.h"
#include "render_mock.h"

namespace aips::bad_pdf_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kSize = 16;

/// A box whose ball, after six walls, claims a density that is not its own.
mock::Scene box_with(float claimed_pdf) {
    mock::Material ball;
    ball.claimed_pdf = claimed_pdf;
    return mock::lamp_box({}, ball);
}

/// Draws half of all directions like Lambert's lobe.
class CosineGuide final : public DirectionGuide {
  public:
    const GuidedDirections* directions(const GuideVertex& vertex,
                                       std::pmr::memory_resource& memory) const override {
        return mock::CosineDirections::about(vertex.normal, memory);
    }
};

struct Traced {
    PhotonStore store;
    PathLog log;
    PhotonCounts counts;
    std::vector<std::pair<std::string, std::uint64_t>> refused;
};

/// All photons of 20 000 guided photon paths.
Traced trace(const mock::Scene& scene) {
    Settings settings = mock::small_settings(61, 20000);
    settings.direct_light_sampling = false;
    const DiscreteDistribution lights = light_choice(scene);
    const CosineGuide guide;
    PhotonInput input{scene, settings, lights, &guide};
    input.unguided_roulette = true;
    InvalidSampleFilter filter(scene);
    PhotonTracer tracer;
    Traced result;
    result.counts = tracer.trace(input, 0, 0, 20000, filter, result.store);
    result.refused = filter.by_origin();
    return result;
}

TEST(BadPdf, PhotonsHaveFinitePower) {
    for (const float bad : {0.0f, kNan, kInfinity}) {
        const Traced traced = trace(box_with(bad));
        EXPECT_GT(traced.counts.guided_bounces, 0u);
        for (const Photon& photon : traced.store.photons())
            ASSERT_TRUE(is_valid_radiance(photon.power)) << bad;
    }
}

/// Light that is lost to a density that is none is not lost in silence.
TEST(BadPdf, WhatIsNoDensityIsCounted) {
    for (const float bad : {kNan, kInfinity}) {
        const Traced traced = trace(box_with(bad));
        ASSERT_EQ(traced.refused.size(), 1u) << bad;
        EXPECT_EQ(traced.refused.front().first, R"(material "surface 6")") << bad;
        EXPECT_GT(traced.refused.front().second, 0u) << bad;
    }
    EXPECT_TRUE(trace(mock::lamp_box({}, {})).refused.empty());
}

/// A density of zero counts as one: the guide's alone remains, and its directions have finite
/// weights.
TEST(BadPdf, ImagesAreFinite) {
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kSize, kSize);
    for (const GuideKind guide : {GuideKind::None, GuideKind::Paper, GuideKind::Adaptive}) {
        for (const float bad : {0.0f, kNan, kInfinity}) {
            Settings settings = mock::small_settings(62, 10000);
            settings.guide = guide;
            const mock::Scene scene = box_with(bad);
            const auto r = mock::render(scene, camera, kSize, kSize, settings, 6);
            for (const Rgb& pixel : r.film.image())
                ASSERT_TRUE(is_valid_radiance(pixel)) << mock::name(guide) << ' ' << bad;
            EXPECT_GT(r.film.mean(), 0) << mock::name(guide) << ' ' << bad;
            EXPECT_TRUE(std::isfinite(r.statistics.bounce_gain)) << bad;
            EXPECT_TRUE(std::isfinite(r.statistics.emission_gain)) << bad;
            EXPECT_TRUE(std::isfinite(r.statistics.survival_gain)) << bad;
        }
    }
}

}  // namespace
}  // namespace aips::bad_pdf_test
