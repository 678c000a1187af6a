// The ready sampler: even in each pixel, other in the next one, a function of its arguments.
#include <gtest/gtest.h>

#include <set>

#include "aips/parts/sobol_sampler.h"

namespace aips::sobol_sampler_test {
namespace {

// Protects the noise of hosts that take it: 16 samples fall into the 16 squares of the pixel, those
// of the lens likewise, in any aligned block.
TEST(SobolSampler, BlocksFillTheSquares) {
    const SobolSampler sampler(5);
    for (const std::uint64_t begin : {0u, 16u, 4096u}) {
        std::set<int> film, lens;
        for (std::uint64_t i = 0; i < 16; ++i) {
            const CameraSample s = sampler.camera_sample(begin + i, 7, 9);
            film.insert(int((s.film.x - 7) * 4) * 4 + int((s.film.y - 9) * 4));
            lens.insert(int(s.lens.x * 4) * 4 + int(s.lens.y * 4));
        }
        EXPECT_EQ(film.size(), 16u);
        EXPECT_EQ(*film.begin(), 0);
        EXPECT_EQ(*film.rbegin(), 15);
        EXPECT_EQ(lens.size(), 16u);
    }
}

// Protects against patterns: pixels and seeds have sequences of their own. The mean of 4096 first
// samples is within 5 standard deviations, 5 sqrt(1/12/4096).
TEST(SobolSampler, PixelsDiffer) {
    const SobolSampler sampler(5), other(6);
    double sum = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const float at = sampler.camera_sample(0, x, y).film.x - float(x);
            EXPECT_GE(at, 0);
            sum += at;
        }
    }
    EXPECT_NEAR(sum / 4096, 0.5, 0.0226);
    EXPECT_NE(sampler.camera_sample(3, 1, 1).film, other.camera_sample(3, 1, 1).film);
    EXPECT_EQ(sampler.camera_sample(3, 1, 1).film, SobolSampler(5).camera_sample(3, 1, 1).film);
}

}  // namespace
}  // namespace aips::sobol_sampler_test
