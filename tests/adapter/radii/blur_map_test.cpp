// Protects what blur does to radii: only what is surely there and larger than noise narrows them,
// noise alone doesn't, and they widen again once noise is what is left.
#include "radii/blur_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "aips/core/sampling/random.h"
#include "radii/constants.h"

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

/// A pixel's narrowing after so many of them.
float narrowing(double bias, double share, int points, std::uint64_t seed, double told = 1) {
    BlurMap map(1);
    RandomStream random(seed, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < points; ++i)
        map.add(0, densities(bias, share, random, told));
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
        map.add(1, densities(1, 0.1, random));
    EXPECT_LT(map.narrowing(1), 0.1f);
    EXPECT_EQ(map.narrowing(0), 1);
    for (int i = 0; i < 400; ++i)
        map.add(1, densities(0, 1, random));
    EXPECT_GT(map.narrowing(1), 0.9f);
}

TEST(BlurMap, LeavesOutWhatIsNotANumber) {
    BlurMap map(1);
    const double infinity = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 100; ++i) {
        map.add(0, {infinity, 1, 1});
        map.add(0, {infinity, infinity, 1});
        map.add(0, {1e300, 0, 1});
        map.add(0, {2, 1, infinity});
    }
    EXPECT_EQ(map.narrowing(0), 1);
    for (int i = 0; i < 30; ++i)
        map.add(0, {2, 1, 0.01});
    EXPECT_LT(map.narrowing(0), 0.5f);
}

}  // namespace
}  // namespace aips::blur_map_test
