// A function known on paper, for chains of Metropolis sampling to estimate.
#include "metropolis_landscape.h"

namespace lxs::test {
namespace {

constexpr double kHighest = 100;

}  // namespace

double landscape_height(std::uint32_t x, std::uint32_t y) {
    if (x == 5 && y == 2) return kHighest;
    if (y == 7) return 0;
    return 0.2 + 0.1 * x * y;
}

double landscape_mean() {
    double sum = 0;
    for (std::uint32_t y = 0; y < kLandscapeSize; ++y) {
        for (std::uint32_t x = 0; x < kLandscapeSize; ++x)
            sum += landscape_height(x, y) / (kLandscapeSize * kLandscapeSize);
    }
    return sum;
}

void Landscape::evaluate(PrimarySample& sample, Contribution& contribution) {
    const Vec2 p = sample.next_2d();
    contribution.position = p * static_cast<float>(kLandscapeSize);
    const auto x = static_cast<std::uint32_t>(contribution.position.x);
    const auto y = static_cast<std::uint32_t>(contribution.position.y);
    double value = landscape_height(x, y);
    if (x < kLandscapeSize / 2) {
        for (int i = 0; i < 4; ++i)
            sample.next();
        value *= 2 * sample.next();  // a factor of mean 1
    }
    contribution.radiance.assign(1, Rgb(static_cast<float>(value)));
    contribution.brightness = value;
}

void start_fairly(MetropolisChain& chain, std::uint64_t seed) {
    Landscape landscape;
    Contribution contribution;
    for (std::uint64_t i = 0;; ++i) {
        const RandomStream stream(seed, i, 0, RandomDomain::MetropolisSeeds);
        RandomStream sample = stream;
        landscape.evaluate(sample, contribution);
        RandomStream coin(seed, i, 1, RandomDomain::MetropolisSeeds);
        if (kHighest * coin.next() < contribution.brightness)
            return chain.start(stream, landscape_mean(), landscape);
    }
}

std::vector<double> image_of(const ChainRun& run, std::uint64_t seed, ChainCounts* counts) {
    Landscape landscape;
    MetropolisChain chain(run.settings, kLandscapeSize, kLandscapeSize, seed, 0);
    start_fairly(chain, seed);
    std::vector<Vec2> positions(run.mutations + 1);
    std::vector<Rgb> radiance(run.mutations + 1);
    SplatList splats{positions, radiance};
    std::vector<LitSample> lit;
    const ChainCounts done = chain.run(run.mutations, run.guess, landscape, splats, lit);
    if (counts != nullptr) *counts = done;
    std::vector<double> image(std::size_t{kLandscapeSize} * kLandscapeSize);
    for (std::size_t i = 0; i < splats.used; ++i) {
        const auto pixel = static_cast<std::size_t>(positions[i].y) * kLandscapeSize +
                           static_cast<std::size_t>(positions[i].x);
        image[pixel] +=
            radiance[i].x * double{kLandscapeSize * kLandscapeSize} / double(run.mutations);
    }
    return image;
}

}  // namespace lxs::test
