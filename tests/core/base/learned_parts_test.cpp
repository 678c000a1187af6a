// Protects: parts of what was learned come back as they were saved, by their names and only where
// they fit, and old knowledge yields to new in everything that fades.
#include "aips/core/base/learned_parts.h"

#include <gtest/gtest.h>

#include "../../adapter/state/memory_archive.h"
#include "aips/core/sampling/random.h"
#include "aips/core/tables/learned_lights.h"
#include "aips/core/trees/primary_tree.h"
#include "aips/core/trees/score_cache.h"

namespace aips::learned_parts_test {
namespace {

mock::Bytes two_parts() {
    mock::Saving archive;
    LearnedParts parts(archive);
    double x = 3;
    std::uint32_t n = 7;
    parts.part("real", 1, [&](StateArchive& a) { a.amount(x); });
    parts.part("whole", 2, [&](StateArchive& a) { a.value(n); });
    parts.end();
    return archive.saved();
}

TEST(LearnedParts, ComeBackInAnyOrderWhereTheyFit) {
    const mock::Bytes saved = two_parts();
    mock::Restoring archive(saved);
    LearnedParts parts(archive);
    EXPECT_EQ(archive.remaining(), 0u);
    double x = 0;
    std::uint32_t n = 0;
    const auto number = [&](StateArchive& a) { a.value(n); };
    EXPECT_FALSE(parts.part("whole", 3, number));
    EXPECT_TRUE(parts.part("whole", 2, number));
    EXPECT_FALSE(parts.part("whole", 2, number)) << "taken twice";
    EXPECT_FALSE(parts.part("other", 1, number));
    EXPECT_EQ(n, 7u);
    EXPECT_EQ(parts.taken(), std::vector<std::string>{"whole"});
    EXPECT_EQ(parts.left_out(), std::vector<std::string>{"real"});
    EXPECT_TRUE(parts.part("real", 1, [&](StateArchive& a) { a.amount(x); }));
    EXPECT_EQ(x, 3);
}

TEST(LearnedParts, OfAnotherLengthAreRefused) {
    const mock::Bytes saved = two_parts();
    const auto read = [&](const LearnedParts::Describe& describe) {
        mock::Restoring archive(saved);
        LearnedParts(archive).part("whole", 2, describe);
    };
    std::uint64_t wide = 0;
    std::uint8_t narrow = 0;
    EXPECT_THROW(read([&](StateArchive& a) { a.value(wide); }), StateError);
    EXPECT_THROW(read([&](StateArchive& a) { a.value(narrow); }), StateError);
    for (std::size_t length = 0; length < saved.size(); ++length) {
        mock::Restoring archive{std::span<const std::byte>(saved).first(length)};
        EXPECT_THROW(LearnedParts parts(archive), StateError) << length;
    }
}

PrimaryPoint any(RandomStream& random) {
    PrimaryPoint point;
    for (double& x : point)
        x = double(random.next());
    return point;
}

/// Learned: the upper half is bright; then, from a tenth as many paths: the lower half is.
TEST(OldKnowledge, YieldsInTreesOfStarts) {
    const auto share_below = [](bool fades) {
        PrimaryTree tree;
        RandomStream random(3, 0, 0, RandomDomain::Photon);
        const auto learn = [&](int paths, bool upper) {
            for (int i = 0; i < paths; ++i) {
                const PrimaryPoint point = any(random);
                tree.add(point, (point[0] >= 0.5) == upper ? 1 : 1e-4);
            }
            tree.update(paths);
        };
        for (int block = 0; block < 10; ++block)
            learn(1000, true);
        if (fades) tree.fade(100, 0);
        learn(1000, false);
        tree.set_mixture({0.1, 0});
        int below = 0;
        for (int i = 0; i < 1000; ++i)
            below += tree.sample(any(random)).point[0] < 0.5 ? 1 : 0;
        return below / 1000.0;
    };
    EXPECT_LT(share_below(false), 0.4);
    EXPECT_GT(share_below(true), 0.7);
}

TEST(OldKnowledge, YieldsInCachesOfScores) {
    ScoreCache cache(Bounds{{0, 0, 0}, {1, 1, 1}});
    const Vec3 place{0.5f, 0.5f, 0}, up{0, 0, 1};
    for (int i = 0; i < 1000; ++i)
        cache.add({place, up, 100, 1});
    cache.update(1000);
    const float before = cache.at(place, up).score;
    cache.fade(10);
    EXPECT_NEAR(cache.at(place, up).score, before, 1e-3 * double(before)) << "means stay";
    for (int i = 0; i < 100; ++i)
        cache.add({place, up, 1, 1});
    cache.update(100);
    EXPECT_LT(cache.at(place, up).score, 15);
}

TEST(OldKnowledge, OfLightsGoesOnLearning) {
    const std::vector<float> even{1, 1};
    const DiscreteDistribution plain(even);
    const Bounds scene{{0, 0, 0}, {1, 1, 1}};
    const Vec3 place{0.5f, 0.5f, 0}, up{0, 0, 1};
    const auto teach = [&](LearnedLights& lights, std::uint32_t bright, std::size_t rays) {
        std::vector<LightSample> samples;
        for (std::uint32_t i = 0; i < rays; ++i)
            samples.push_back({place, up, i % 2, 0.5f, i % 2 == bright ? 1.0f : 0.01f});
        lights.learn(samples, samples.size(), 1);
    };
    LearnedLights first(scene, plain);
    while (first.learns())
        teach(first, 0, kMostNewRays);
    mock::Saving archive;
    LearnedParts saved(archive);
    first.learned(saved);
    saved.end();
    LearnedLights next(scene, plain);
    mock::Restoring restoring(archive.saved());
    LearnedParts parts(restoring);
    next.learned(parts);
    EXPECT_TRUE(next.learns());
    EXPECT_GT(next.at(place, up).pdf(0), 0.8f);
    teach(next, 1, 4 * kRememberedRays);
    EXPECT_LT(next.at(place, up).pdf(0), 0.5f);
}

}  // namespace
}  // namespace aips::learned_parts_test
