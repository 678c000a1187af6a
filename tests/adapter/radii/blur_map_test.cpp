// Protects what blur does to radii: only what is surely there and larger than noise narrows them,
// noise alone doesn't, and they widen again once noise is what is left.
#include "radii/blur_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "aips/core/sampling/random.h"
#include "radii/constants.h"
#include "state/memory_archive.h"

namespace aips::blur_map_test {
namespace {

/// Light of photons' kind: now and then a bright one, mean 1, variance 3.
double noise(RandomStream& random) {
    return random.next() < 1.0f / 3 ? 6 * double(random.next()) : 0.0;
}

/// A point whose inner half tells 1 and whose whole disc is more by half of `bias`, both noisy by
/// `share` of noise(); `told`: the part of the variance that single photons tell.
DiscDensities densities(double bias, double share, RandomStream& random, double told = 1) {
    const double half = 1 - share + share * noise(random);
    const double rest = 1 - share + share * noise(random);
    return {(half + rest + bias) / 2, half, told * share * share * 1.5};
}

/// A pass that sees one point.
void one_pass(BlurMap& map, std::uint32_t pixel, const DiscDensities& seen) {
    map.add(pixel, seen);
    map.end_pass();
}

/// A pixel's narrowing after so many passes with one each.
float narrowing(double bias, double share, int passes, std::uint64_t seed, double told = 1) {
    BlurMap map(1);
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < passes; ++i)
        one_pass(map, 0, densities(bias, share, random, told));
    return map.narrowing(0);
}

TEST(BlurMap, NarrowsWhatIsSurelyBlurred) {
    for (const double bias : {0.5, -0.5}) {
        EXPECT_FLOAT_EQ(narrowing(bias, 0.01, 10, 0), float(std::pow(kNarrowingStep, 10)));
        EXPECT_FLOAT_EQ(narrowing(bias, 0.1, 100, 0), float(kLeastNarrowing));
    }
}

/// Mean narrowing of pixels that are not blurred, and the share that is narrowed by a tenth.
struct WronglyNarrowed {
    double mean = 0, share = 0;
};

WronglyNarrowed wrongly_narrowed(double told) {
    constexpr int kPixels = 2000;
    WronglyNarrowed all;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        const auto now = double(narrowing(0, 1, 100, std::uint64_t(pixel), told));
        all.mean += now / kPixels;
        all.share += (now < 0.9 ? 1.0 : 0.0) / kPixels;
    }
    return all;
}

/// At 3 standard errors one pixel in 370 is wrongly sure at a time, and its radii come back.
TEST(BlurMap, NoiseAloneNarrowsNothing) {
    const WronglyNarrowed all = wrongly_narrowed(1);
    EXPECT_GT(all.mean, 0.99);
    EXPECT_LT(all.share, 0.03);
}

/// Where photons come in hundreds they tell next to nothing of their noise: what points differ by
/// does.
TEST(BlurMap, NoiseOfPhotonsThatComeTogetherNarrowsLittle) {
    EXPECT_GT(wrongly_narrowed(0.01).mean, 0.85);
}

/// A blur of 0.1 is smaller than the error of the mean of 100 points, 0.12; one of 2 is larger.
TEST(BlurMap, NarrowsNoMoreThanNoiseAllows) {
    EXPECT_GT(narrowing(0.1, 1, 100, 1), 0.9f);
    EXPECT_LT(narrowing(2, 1, 100, 1), 0.5f);
}

TEST(BlurMap, WidensAgainWhereNoiseIsLeft) {
    BlurMap map(2);
    RandomStream random(1, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 60; ++i)
        one_pass(map, 1, densities(1, 0.1, random));
    EXPECT_LT(map.narrowing(1), 0.1f);
    EXPECT_EQ(map.narrowing(0), 1);
    for (int i = 0; i < 400; ++i)
        one_pass(map, 1, densities(0, 1, random));
    EXPECT_GT(map.narrowing(1), 0.9f);
}

/// A disc that is half as wide is clear of the bright light beside it, whose dark side is a
/// hundredth as bright: it does not go on to narrow by what wider ones saw.
TEST(BlurMap, StopsWhereDiscsAreClearOfWhatBlurs) {
    BlurMap map(1);
    RandomStream random(3, 0, 0, RandomDomain::Photon);
    float least = 1;
    for (int i = 0; i < 200; ++i) {
        one_pass(map, 0, densities(map.narrowing(0) > 0.5f ? 50 : 0, 1, random));
        least = std::min(least, map.narrowing(0));
    }
    EXPECT_GT(least, 0.3f);
    EXPECT_LT(least, 0.5f);
}

/// Many points of a pass that see the same photons tell no more than one.
TEST(BlurMap, PointsOfAPassAreNotIndependent) {
    double mean = 0;
    for (int pixel = 0; pixel < 500; ++pixel) {
        BlurMap map(1);
        RandomStream random(std::uint64_t(pixel), 0, 0, RandomDomain::Photon);
        for (int pass = 0; pass < 100; ++pass) {
            const DiscDensities seen = densities(0, 1, random);
            for (int point = 0; point < 16; ++point)
                map.add(0, seen);
            map.end_pass();
        }
        mean += double(map.narrowing(0)) / 500;
    }
    EXPECT_GT(mean, 0.99);
}

TEST(BlurMap, GoesOnWhereItsStateWasSaved) {
    BlurMap map(2);
    RandomStream random(5, 0, 0, RandomDomain::Photon);
    std::vector<DiscDensities> seen;
    seen.reserve(80);
    for (int i = 0; i < 80; ++i)
        seen.push_back(densities(i < 20 ? 1 : 0, i < 20 ? 0.2 : 1, random));
    const auto run = [&](BlurMap& to, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            one_pass(to, 1, seen[i]);
    };
    run(map, 0, 30);
    mock::Saving saving;
    map.state(saving);
    BlurMap restored(2);
    mock::Restoring restoring(saving.saved());
    restored.state(restoring);
    EXPECT_LT(restored.narrowing(1), 0.5f);
    run(map, 30, 80);
    run(restored, 30, 80);
    EXPECT_EQ(restored.narrowing(1), map.narrowing(1));
    EXPECT_EQ(restored.narrowing(0), 1);
}

/// Sums over a pass of what is finite by itself may be no numbers.
TEST(BlurMap, LeavesOutWhatIsNotANumber) {
    BlurMap map(1);
    const double infinity = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 100; ++i) {
        for (const DiscDensities& odd : {DiscDensities{infinity, 1, 1},
                                         {infinity, infinity, 1},
                                         {1e300, 0, 1},
                                         {2, 1, infinity}})
            one_pass(map, 0, odd);
        for (int point = 0; point < 1000; ++point)
            map.add(0, {3e38, 0, 3e38});
        map.end_pass();
    }
    EXPECT_EQ(map.narrowing(0), 1);
    for (int i = 0; i < 30; ++i)
        one_pass(map, 0, {2, 1, 0.01});
    EXPECT_LT(map.narrowing(0), 0.5f);
}

}  // namespace
}  // namespace aips::blur_map_test
