// Protects the bounds on fireflies that are proved at the code, with guides taught by an adversary:
// a start weighs at most 1 / 0.15 of an unguided one, a bounce at most 4 times as much, roulette
// multiplies by at most 1 / 0.05, and no photon counts more than 3.2 times for the learning
// weights.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "eye/light_choice.h"
#include "guides/adaptive/bounce_guide.h"
#include "guides/adaptive/emission_guide.h"
#include "guides/adaptive/learning_weight.h"
#include "mock_bsdf.h"
#include "photons/photon_iteration.h"
#include "photons/scatter_photon.h"
#include "render_mock.h"
#include "stress_case.h"

namespace weight_bounds_test {
namespace {

using namespace aips;
using namespace stress;

constexpr double kPlainShare = 0.15, kTableBound = 4, kRouletteBound = 20;
constexpr Vec3 kUp{0, 0, 1};

std::string figure_of(double greatest, double most) {
    std::ostringstream figure;
    figure.precision(8);
    figure << "greatest " << greatest << " of at most " << most;
    return figure.str();
}

/// Learns that one start of one light is worth all and others nothing; seeds say so of another.
void mislead(EmissionGuide& guide, LightIndex light, int updates) {
    for (int u = 0; u < updates; ++u) {
        const float x = u % 50 < 25 ? 0 : 0x1.fffffep-1f;
        RandomStream random(6, std::uint64_t(u), 0, RandomDomain::Guide);
        for (int i = 0; i < 256; ++i) {
            const PrimaryPoint dark{random.next(), random.next(), random.next(), random.next()};
            guide.add({{light, dark, 1}, 0, 1e-3});
        }
        for (int i = 0; i < 64; ++i)
            guide.add({{light, {x, 0, x, 0}, 1}, std::pow(10.0, i - 30), 1e-3});
        guide.add_seeds(std::vector<EmissionSeed>(20, {light, {0.7f, 0.7f, x, x}, 1e30f}));
        guide.update(100);
    }
}

TEST(StressFireflies, StartsWeighAtMostByThePlainShare) {
    double greatest = 0;
    for (const std::size_t lights : {1u, 2u, 10'000u}) {
        std::vector<float> powers(lights, 1.0f);
        for (std::size_t l = 0; l < lights; ++l)
            powers[l] = std::pow(10.0f, float(l % 10) - 9);  // ratios of 1e9
        const DiscreteDistribution plain{powers};
        EmissionGuide guide(lights, plain);
        mislead(guide, 0, 100);
        ASSERT_TRUE(guide.on());
        RandomStream random(7, lights, 0, RandomDomain::Guide);
        const double bound =
            1 / (kPlainShare * (1 - (double(lights) + 1) * 0x1p-24) * (1 - 80 * 0x1p-23));
        const int draws = sized(300'000, 10'000'000);
        for (int i = 0; i < draws; ++i) {
            const float u_light = random.next();
            const EmissionStart start =
                guide.sample(u_light, {random.next(), random.next(), random.next(), random.next()});
            const double weight = double(plain.pdf(start.light)) / start.pdf;
            ASSERT_LE(weight, bound * (1 + 1e-6)) << lights;
            greatest = std::max(greatest, weight);
        }
    }
    EXPECT_GT(greatest, 6);  // or nothing was put to the test
    record("1, 2 and 10,000 lights with powers of 1e-9 to 1, all scores at one start",
           figure_of(greatest, 1 / kPlainShare));
}

BounceGuide misled_bounces() {
    BounceGuide guide(Bounds{{-1, -1, -1}, {1, 1, 1}}, 1e6);
    for (int u = 0; u < 60; ++u) {
        for (int i = 0; i < 600; ++i) {
            PathVertex vertex;
            const Vec3 normals[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, kUp, {0, 0, -1}};
            vertex.normal = normals[i % 6];
            vertex.position = vertex.normal * -1.0f;
            vertex.power = 1;
            vertex.direction =
                cosine_square_direction(Frame::world_aligned(vertex.normal), {0.01f, 0.98f});
            vertex.pdf = vertex.plain_pdf = 0.01f;
            vertex.lobes = kDiffuse;
            guide.add(vertex, 1e20, 0);
        }
        guide.update(600);
    }
    return guide;
}

TEST(StressFireflies, BouncesWeighAtMostByTheBsdfsShare) {
    const BounceGuide guide = misled_bounces();
    const mock::Scene scene = mock::lamp_box({}, {});
    const Settings settings;
    const DiscreteDistribution lights;
    const PhotonInput input{scene, settings, lights, &guide};
    Arena arena;
    SurfacePoint point;
    point.position = {0, 0, -1};
    PhotonCounts counts;
    double greatest = 0;
    const int draws = sized(200'000, 5'000'000);
    for (int i = 0; i < draws; ++i) {
        arena.reset();
        RandomStream random(8, 0, std::uint64_t(i), RandomDomain::Photon);
        point.geometric_normal = point.shading_normal = kUp;
        mock::Material matte;
        matte.reflectance = kWhite;
        point.bsdf = mock::make_bsdf(matte, kUp, kUp, arena);
        ScatteredPhoton s;
        if (!scatter_photon(input, point, normalize(Vec3{0.3f, 0.1f, 1}), random, arena, counts, s))
            continue;
        greatest = std::max(greatest, double(s.weight.r));
        ASSERT_LE(s.plain_pdf, float(kTableBound) * s.pdf * (1 + 1e-5f));
    }
    EXPECT_LE(greatest, kTableBound * (1 + 1e-5));
    EXPECT_GT(greatest, 3.5);
    record("bounces off white Lambert, its table taught one grazing direction",
           figure_of(greatest, kTableBound));
}

TEST(StressFireflies, RouletteMultipliesByAtMostTwenty) {
    const float inf = std::numeric_limits<float>::infinity();
    const float odd[] = {0,     1e-45f, 1e-38f, 1e-3f, 1,       20,
                         1e38f, inf,    -inf,   -1,    -1e-45f, std::nanf("")};
    double greatest = 0;
    for (const float plain : odd) {
        for (const float scored : odd) {
            for (const float power : odd) {
                for (const ScoreMix mix : {ScoreMix::None, ScoreMix::Half, ScoreMix::Quarters}) {
                    const float photons = photons_going_on({1, plain, scored}, mix, power);
                    ASSERT_GE(photons, kMinSurvival) << plain << ' ' << scored << ' ' << power;
                    ASSERT_LE(photons, kMostPhotons);
                    greatest = std::max(greatest, 1 / double(photons));
                }
            }
        }
    }
    EXPECT_LE(greatest, kRouletteBound * (1 + 1e-6));
    record("1728 triples of powers and scores of 0, denormal, 1e38, infinite, NaN, negative",
           figure_of(greatest, kRouletteBound));
}

/// Scores that are next to nothing but at one place, faded beyond a double's range, and sane.
ScoreCache misled_cache() {
    ScoreCache cache(Bounds{{-1, -1, -1}, {1, 1, 1}});
    for (int u = 0; u < 30; ++u) {
        for (int i = 0; i < 300; ++i) {
            const float x = float(i % 20) / 10 - 1;
            cache.add({{x, 0, -1}, kUp, i % 20 == 7 ? 1e30 : 1e-30, i % 3 ? 1e-6 : 1e6});
        }
        cache.update(300);
    }
    return cache;
}

/// All guides at once: what a photon carries when it lands, against what it could by the bounds.
TEST(StressFireflies, PhotonsCarryAtMostTheProductOfTheBounds) {
    mock::Material wall;
    wall.reflectance = {0.8f, 0.8f, 0.8f};
    const mock::Scene scene = mock::lamp_box(wall, wall);
    Settings settings = mock::small_settings(31, 1000);
    settings.direct_light_sampling = false;
    settings.max_photon_depth = 8;
    const DiscreteDistribution lights = light_choice(scene);
    EmissionGuide emission(scene.lights().size(), lights);
    mislead(emission, 0, 200);
    const BounceGuide bounces = misled_bounces();
    const ScoreCache cache = misled_cache();
    const auto greatest_share = [&](double cost_over_score, ScoreMix mix) {
        ScoreSurvival survival(cache);
        survival.set_reference(cost_over_score);
        PhotonInput input{scene, settings, lights, &bounces};
        input.emission = &emission;
        input.survival = &survival;
        input.score_mix = mix;
        input.split_limit = 1u << 20;
        input.unguided_roulette = true;
        InvalidSampleFilter filter(scene);
        PhotonStore store;
        const std::uint32_t paths = sized(2'000u, 100'000u);
        PhotonTracer().trace(input, 0, 0, paths, filter, store);
        EXPECT_EQ(filter.total(), 0u);
        PhotonInput unguided{scene, settings, lights};
        PhotonStore plain;
        PhotonTracer().trace(unguided, 0, 0, 1000, filter, plain);
        float emitted = 0;  // greatest power of an unguided photon's first photon
        for (const Photon& l : plain.photons())
            emitted = std::max(emitted, l.depth == 1 ? max_component(l.power) : 0.0f);
        double greatest = 0;
        for (const Photon& l : store.photons()) {
            const double bound = double(emitted) / kPlainShare *
                                 std::pow(0.8 * kTableBound * kRouletteBound, l.depth - 1);
            const double share = double(max_component(l.power)) / bound;
            EXPECT_TRUE(share >= 0 && share <= 1 + 1e-4) << l.depth;
            greatest = std::max(greatest, share);
        }
        return greatest;
    };
    double greatest = 0;
    for (const double reference : {1e-300, 1.0, 1e300, std::numeric_limits<double>::infinity()}) {
        for (const ScoreMix mix : {ScoreMix::None, ScoreMix::Half, ScoreMix::Quarters})
            greatest = std::max(greatest, greatest_share(reference, mix));
    }
    EXPECT_GT(greatest, 0.5);
    record("emission, bounces and roulette misled together, 8 surfaces deep",
           figure_of(greatest, 1) + " of 6.7 P0 (80 albedo)^(depth - 1)");
}

/// Photons in the order and the blocks that a pass shoots them in.
TEST(StressFireflies, LearningWeightsFavourNoPhotonMuch) {
    constexpr std::uint64_t kMostPaths = 4'000'000;
    double greatest = 0;
    for (const std::uint64_t per_pass : {125'000u, 200'000u, 1'000'000u, 4'000'000u}) {
        double sum = 0;
        for (std::uint64_t pass = 0; pass < kMostPaths; pass += per_pass) {
            for (std::uint64_t first = 0; first < per_pass; first += kIterationPaths) {
                const double weight = learning_weight(pass + first);
                const std::uint64_t count =
                    std::min<std::uint64_t>(kIterationPaths, per_pass - first);
                // The image may be stopped after any pass; here after any block's first photon.
                greatest = std::max(greatest, weight * double(pass + first + 1) / (sum + weight));
                sum += weight * double(count);
            }
        }
    }
    EXPECT_LE(greatest, 3.2);
    EXPECT_GT(greatest, 2.5);
    record("four million photon paths in passes of 125,000 to 4 million",
           figure_of(greatest, 3.2) + " of what a photon counts in a plain mean");
}

}  // namespace
}  // namespace weight_bounds_test
