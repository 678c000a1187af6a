// Protects: whatever was learned in another scene, a render that begins with it has the expectation
// of one that begins with nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "resumable_render.h"
#include "test_form.h"

namespace aips::learned_agreement_test {
namespace {

using mock::Bytes;
using mock::ResumableCase;
using mock::ResumableRender;

/// Of each side; renders of few passes, in which what was taken counts most.
unsigned seeds() {
    return statistics::sized(24u, 96u);
}
constexpr unsigned kPasses = 3;
/// Blocks of the image, in each direction.
constexpr std::uint32_t kBlocks = 3;
/// 9 blocks in each of some cases: |z| > 4.5 comes by chance in one of 10 000 test runs.
constexpr double kMostSigmas = 4.5;

struct Moments {
    double sum = 0, squares = 0;

    void add(double x) {
        sum += x;
        squares += x * x;
    }
    double mean() const { return sum / seeds(); }
    double variance_of_mean() const {
        return (squares - sum * sum / seeds()) / (seeds() - 1.0) / seeds();
    }
};

using Blocks = std::array<Moments, std::size_t{kBlocks} * kBlocks>;

void add(Blocks& blocks, const ResumableRender& render, const ResumableCase& what) {
    const std::vector<Rgb> image = render.film().image();
    for (std::uint32_t b = 0; b < blocks.size(); ++b) {
        const std::uint32_t x = b % kBlocks, y = b / kBlocks;
        blocks[b].add(mock::mean_luminance(
            image, what.width, x * what.width / kBlocks, y * what.height / kBlocks,
            (x + 1) * what.width / kBlocks, (y + 1) * what.height / kBlocks));
    }
}

class LearnedAgreement : public testing::TestWithParam<ResumableCase> {};

TEST_P(LearnedAgreement, WithTheRenderThatBeginsWithNothing) {
    ResumableCase before = GetParam();
    before.moved = 0.8f;
    before.settings.seed = 77;
    ResumableRender old(before);
    old.render_to(4);
    const Bytes learned = old.save_learned();
    Blocks cold, warm;
    for (unsigned i = 0; i < seeds(); ++i) {
        ResumableCase what = GetParam();
        what.settings.seed = 1000 + 2 * i;
        ResumableRender alone(what);
        alone.render_to(kPasses);
        add(cold, alone, what);
        what.settings.seed += 1;
        ResumableRender warm_started(what);
        warm_started.take_learned(learned);
        warm_started.render_to(kPasses);
        add(warm, warm_started, what);
    }
    for (std::size_t b = 0; b < cold.size(); ++b) {
        const double sigma = std::sqrt(cold[b].variance_of_mean() + warm[b].variance_of_mean());
        EXPECT_LT(std::abs(warm[b].mean() - cold[b].mean()), kMostSigmas * sigma)
            << "block " << b << ": " << cold[b].mean() << " and " << warm[b].mean();
    }
}

/// Eye paths that go on have none of the blur that photons have, and carry another share: where
/// they do, radii are small.
ResumableCase shared(ResumableCase what) {
    what.name += "_shared";
    what.settings.continue_eye_paths = true;
    what.settings.start_radius = 0.4;  // pixel footprints
    return what;
}

std::vector<ResumableCase> learning_cases() {
    std::vector<ResumableCase> cases;
    for (ResumableCase what : mock::resumable_cases()) {
        const bool wanted =
            what.name == "progressive_adaptive" || what.name == "lights" || what.name == "explored";
        if (!wanted) continue;
        what.settings.alpha = 1;  // the same radius for both
        what.settings.continue_eye_paths = false;
        what.settings.photons_per_pass = std::min(what.settings.photons_per_pass, 4000u);
        cases.push_back(what);
        if (what.name == "progressive_adaptive") cases.push_back(shared(what));
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Renders, LearnedAgreement, testing::ValuesIn(learning_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace aips::learned_agreement_test
