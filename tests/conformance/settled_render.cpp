// Renders until the image's own noise no longer matters to the comparison.
#include "settled_render.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace conformance {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool below(const Spread& noise, const Spread& limit, double share) {
    return noise.median <= share * limit.median && noise.p95 <= share * limit.p95;
}

/// How many times more passes bring `noise` to `goal`; noise falls with the root of passes.
double more_passes(const Spread& noise, const Spread& goal) {
    const double excess = std::max(noise.median / goal.median, noise.p95 / goal.p95);
    constexpr double kMargin = 1.2, kLeast = 2, kMost = 8;
    return std::isfinite(excess) ? std::clamp(kMargin * excess * excess, kLeast, kMost) : kMost;
}

}  // namespace

SettledImage render_settled(const RenderPasses& render, const Spread& limit,
                            const WithinLimits& within, const Budget& budget) {
    const auto start = std::chrono::steady_clock::now();
    const Spread goal{budget.share * limit.median, budget.share * limit.p95};
    std::size_t passes = budget.first_passes, seed = 1;
    SettledImage result;
    constexpr double kWorthwhile = 1.5;  // times more passes than the round before
    while (true) {
        const double before = seconds_since(start);
        const render::Image first = render(passes, seed++);
        const render::Image second = render(passes, seed++);
        result.image = mean(first, second);
        result.noise = noise_of_mean(first, second);
        result.passes = 2 * passes;
        result.seconds = seconds_since(start);
        result.settled = below(result.noise, limit, budget.share) ||
                         (below(result.noise, limit, budget.share_within) && within(result.image));
        const double affordable = (budget.seconds - result.seconds) / (result.seconds - before);
        const double factor = std::min(more_passes(result.noise, goal), affordable);
        if (result.settled || !(factor >= kWorthwhile)) return result;
        passes = std::size_t(std::ceil(factor * double(passes)));
    }
}

}  // namespace conformance
