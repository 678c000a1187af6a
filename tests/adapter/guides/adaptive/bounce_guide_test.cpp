// Protects guided directions: their density integrates to one and is what is drawn, the mean of a
// scattering stays what it is, and only matte surfaces are guided.
#include "guides/adaptive/bounce_guide.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aips/core/sampling/random.h"
#include "mock_bsdf.h"
#include "photons/scatter_photon.h"
#include "render_mock.h"

namespace aips::bounce_guide_test {
namespace {

constexpr Bounds kScene{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kPlace{0.5f, 0.5f, 0};
const Vec3 kNormal = normalize(Vec3{0.3f, -0.2f, 0.9f});
const Vec3 kRich = normalize(Vec3{0.8f, 0.2f, 0.6f});

/// Has met photons that left by Lambert's lobe and were worth something near one direction.
BounceGuide trained(LobeMask lobes = kDiffuse) {
    BounceGuide guide(kScene, 1e6);
    const Frame frame = Frame::world_aligned(kNormal);
    for (std::uint64_t b = 0; b < 20; ++b) {
        RandomStream random(1, b, 0, RandomDomain::Guide);
        for (int i = 0; i < 2000; ++i) {
            PathVertex vertex;
            vertex.position = kPlace;
            vertex.normal = kNormal;
            vertex.power = 2;
            vertex.direction = frame.to_world(square_to_cosine_hemisphere(random.next2()));
            vertex.pdf = vertex.plain_pdf =
                std::max(1e-6f, dot(vertex.direction, kNormal)) * kInvPi;
            vertex.lobes = lobes;
            guide.add(vertex, dot(vertex.direction, kRich) > 0.9f ? 4 : 1e-3, 2);
        }
        guide.update(2000);
    }
    return guide;
}

const GuidedDirections* directions_on(const BounceGuide& guide, const Bsdf* bsdf, Arena& arena) {
    return guide.directions({kPlace, kNormal, kNormal, bsdf, kNormal}, arena);
}

TEST(BounceGuide, DensityIntegratesToOneAndFollowsWhatWasLearned) {
    const BounceGuide guide = trained();
    Arena arena;
    const Bsdf* matte = mock::make_bsdf({}, kNormal, kNormal, arena);
    const GuidedDirections* directions = directions_on(guide, matte, arena);
    ASSERT_NE(directions, nullptr);
    EXPECT_GT(directions->share(), 0);
    constexpr int kSide = 1000;
    double sum = 0, rich = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide, y = i / kSide;
        const Vec3 w =
            square_to_uniform_sphere({(float(x) + 0.5f) / kSide, (float(y) + 0.5f) / kSide});
        const double mass = double(directions->pdf(w)) * 4 * double(kPi) / (kSide * kSide);
        sum += mass;
        if (dot(w, kRich) > 0.9f) rich += mass;
    }
    EXPECT_NEAR(sum, 1, 2e-3);
    // What is drawn there, to 4 standard errors and the integral's own.
    RandomStream random(2, 0, 0, RandomDomain::Photon);
    constexpr int kDraws = 100000;
    double drawn = 0;
    for (int i = 0; i < kDraws; ++i)
        drawn += dot(directions->sample(random.next2()), kRich) > 0.9f ? 1.0 / kDraws : 0;
    EXPECT_NEAR(drawn, rich, 4 * std::sqrt(rich * (1 - rich) / kDraws) + 2e-3);
    EXPECT_GT(rich, 0.5);
}

/// Mean of weight * (1 + a component of the direction), to 4 standard errors of 400 000 samples.
TEST(BounceGuide, LeavesTheMeanOfAScatteringAlone) {
    const BounceGuide guide = trained();
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    using Kind = mock::Material::Kind;
    for (const Kind kind : {Kind::Lambert, Kind::LambertAndMirror}) {
        mock::Material material;
        material.kind = kind;
        material.specular = {0.3f, 0.3f, 0.3f};
        double means[2]{}, errors[2]{};
        for (const bool guided : {false, true}) {
            const PhotonInput input{scene, settings, lights, guided ? &guide : nullptr};
            Arena arena;
            SurfacePoint point;
            point.position = kPlace;
            point.geometric_normal = kNormal;
            point.shading_normal = normalize(kNormal + Vec3{0.2f, 0.1f, 0});
            PhotonCounts counts;
            constexpr int kSamples = 400000;
            double sum = 0, squares = 0;
            for (std::uint32_t i = 0; i < kSamples; ++i) {
                arena.reset();
                point.bsdf =
                    mock::make_bsdf(material, point.geometric_normal, point.shading_normal, arena);
                RandomStream random(3, guided ? 1 : 0, i, RandomDomain::Photon);
                ScatteredPhoton s;
                const Vec3 wo = normalize(Vec3{-0.5f, 0.2f, 0.9f});
                if (!scatter_photon(input, point, wo, random, arena, counts, s)) continue;
                const double value =
                    double(luminance(s.weight)) * (1 + double(dot(s.direction, kRich)));
                sum += value;
                squares += value * value;
            }
            means[guided] = sum / kSamples;
            errors[guided] = std::sqrt(squares / kSamples / kSamples);
            EXPECT_EQ(counts.guided_bounces > 0, guided);
        }
        EXPECT_NEAR(means[1], means[0], 4 * std::hypot(errors[0], errors[1]));
        EXPECT_LT(4 * errors[1], 0.01 * means[0]);  // a bias of 1 % would be found
    }
}

/// Diffuse and mirror lobe together: each keeps its own albedo, so that densities per steradian and
/// the mirror's probability do not mix. To 4 standard errors of 400 000 samples.
TEST(BounceGuide, LobesBesideAMirrorKeepTheirAlbedos) {
    const BounceGuide guide = trained();
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, &guide};
    Arena arena;
    PhotonCounts counts;
    SurfacePoint point;
    point.position = kPlace;
    point.geometric_normal = point.shading_normal = kNormal;
    constexpr int kSamples = 400000;
    double sums[2] = {}, squares[2] = {};  // diffuse, mirror
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        arena.reset();
        point.bsdf = mock::make_bsdf(mock::half_mirror(), kNormal, kNormal, arena);
        RandomStream random(4, 0, i, RandomDomain::Photon);
        ScatteredPhoton s;
        const Vec3 wo = normalize(Vec3{-0.5f, 0.2f, 0.9f});
        if (!scatter_photon(input, point, wo, random, arena, counts, s)) continue;
        const bool mirror = s.lobe == kSpecular;
        const double weight = double(luminance(s.weight));
        sums[mirror] += weight / kSamples;
        squares[mirror] += weight * weight / kSamples;
    }
    EXPECT_GT(counts.guided_bounces, 0u);
    const double albedos[2] = {double(luminance(mock::half_mirror().reflectance)),
                               double(luminance(mock::half_mirror().specular))};
    for (const int lobe : {0, 1}) {
        const double error = std::sqrt((squares[lobe] - sums[lobe] * sums[lobe]) / kSamples);
        EXPECT_NEAR(sums[lobe], albedos[lobe], 4 * error) << lobe;
        EXPECT_LT(4 * error, 0.015 * albedos[lobe]) << lobe;  // what would be found
    }
}

TEST(BounceGuide, GuidesAndLearnsFromMatteSurfacesOnly) {
    const BounceGuide guide = trained();
    Arena arena;
    using Kind = mock::Material::Kind;
    for (const Kind kind : {Kind::Mirror, Kind::Glass, Kind::Null, Kind::Phong}) {
        mock::Material material;
        material.kind = kind;
        const Bsdf* bsdf = mock::make_bsdf(material, kNormal, kNormal, arena);
        EXPECT_EQ(directions_on(guide, bsdf, arena), nullptr) << int(kind);
    }
    const BounceGuide untrained = trained(kSpecular | kGlossy);
    EXPECT_EQ(directions_on(untrained, mock::make_bsdf({}, kNormal, kNormal, arena), arena),
              nullptr);
}

}  // namespace
}  // namespace aips::bounce_guide_test
