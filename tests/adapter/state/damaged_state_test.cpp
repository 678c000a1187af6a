// Protects: whatever a saved state holds, it is refused with one message, or the render goes on
// within its memory bound and gives numbers that an image may hold.
#include <gtest/gtest.h>

#include <bit>
#include <iterator>
#include <limits>

#include "aips/core/sampling/random.h"
#include "resumable_render.h"
#include "test_form.h"

namespace aips::damaged_state_test {
namespace {

using mock::ResumableCase;
using mock::ResumableRender;

/// Small, so that much can be tried; states of a few tens of kilobytes.
std::vector<ResumableCase> small_cases() {
    std::vector<ResumableCase> cases;
    for (ResumableCase& what : mock::resumable_cases()) {
        // Enough shadow rays in two passes for tables of lights, or next to none.
        const bool learns_lights = what.name == "lights";
        what.width = learns_lights ? 72 : 8;
        what.height = learns_lights ? 60 : 6;
        what.settings.max_nodes = 64;
        what.settings.cdf_resolution = 4;
        if (what.settings.photons_per_pass) what.settings.photons_per_pass = 1500;
        // The guide would begin with 62500 photons a pass: that of automatic_none tells enough.
        // With few photons a lagging guide is that of progressive_adaptive.
        if (what.name != "automatic_paper" && what.name != "automatic_adaptive" &&
            what.name != "lagging_guide")
            cases.push_back(what);
    }
    return cases;
}

/// Of each way to damage a state, in each case.
unsigned trials() {
    return statistics::sized(AIPS_SANITIZED ? 30u : 60u, 120u);
}

struct Saved {
    mock::Bytes state;
    mock::Film film;
};

Saved saved_after(const ResumableCase& what, unsigned passes) {
    ResumableRender render(what);
    render.render_to(passes);
    return {render.save(), render.film()};
}

/// Whether the state was refused; if not, the next pass's results are checked.
bool refused(const ResumableCase& what, std::span<const std::byte> state, const mock::Film& film) {
    std::unique_ptr<ResumableRender> render;
    try {
        render = std::make_unique<ResumableRender>(what, state, film);
    } catch (const StateError&) {
        return true;
    }
    render->render_pass();
    for (const Rgb& pixel : render->film().image())
        EXPECT_TRUE(is_valid_radiance(pixel));
    const EngineStatistics statistics = render->statistics();
    EXPECT_LE(statistics.memory_bytes, statistics.memory_bound_bytes);
    return false;
}

class DamagedState : public testing::TestWithParam<ResumableCase> {};

TEST_P(DamagedState, CutShortIsRefused) {
    const Saved saved = saved_after(GetParam(), 2);
    const std::size_t size = saved.state.size();
    const auto expect_refused = [&](std::size_t length) {
        EXPECT_TRUE(refused(GetParam(), std::span(saved.state).first(length), saved.film))
            << length << " of " << size << " bytes";
    };
    for (std::size_t length = 0; length < size; length += size / 60 + 1)
        expect_refused(length);
    expect_refused(size - 1);
}

/// One number of eight bytes, or of four, replaced: what breaks sizes, indices and sums.
TEST_P(DamagedState, WrongNumbersDoNoHarm) {
    const Saved saved = saved_after(GetParam(), 2);
    const double wrong[] = {std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity(),
                            -1,
                            0,
                            5e-324,
                            1e300,
                            std::bit_cast<double>(~std::uint64_t{0} >> 1),
                            std::bit_cast<double>(std::uint64_t{0x0000000300000005})};
    RandomStream random(7, 0, 0, RandomDomain::Photon);
    for (unsigned trial = 0; trial < trials(); ++trial) {
        mock::Bytes state = saved.state;
        // Half of all trials in the short part with counts and switches before the first sums.
        const std::size_t range =
            trial % 2 ? state.size() : std::min<std::size_t>(600, state.size());
        const std::size_t at = std::size_t(random.next() * float(range - 8));
        const std::size_t size = random.next() < 0.5f ? 8 : 4;
        const auto bad = float(wrong[trial % std::size(wrong)]);
        std::memcpy(&state[at],
                    size == 8 ? static_cast<const void*>(&wrong[trial % std::size(wrong)]) : &bad,
                    size);
        SCOPED_TRACE(testing::Message() << size << " bytes at " << at);
        refused(GetParam(), state, saved.film);
    }
}

TEST_P(DamagedState, FlippedBitsDoNoHarm) {
    const Saved saved = saved_after(GetParam(), 2);
    RandomStream random(8, 0, 0, RandomDomain::Photon);
    for (unsigned trial = 0; trial < trials(); ++trial) {
        mock::Bytes state = saved.state;
        const std::size_t at =
            std::min(std::size_t(random.next() * float(state.size())), state.size() - 1);
        state[at] ^= std::byte(1u << (random.next_uint() % 8));
        SCOPED_TRACE(testing::Message() << "byte " << at);
        refused(GetParam(), state, saved.film);
    }
}

INSTANTIATE_TEST_SUITE_P(Renders, DamagedState, testing::ValuesIn(small_cases()),
                         [](const auto& test) { return test.param.name; });

/// The message of what is refused.
std::string complaint(const ResumableCase& what, const Saved& saved) {
    try {
        const ResumableRender render(what, saved.state, saved.film);
    } catch (const StateError& error) {
        return error.what();
    }
    return "";
}

TEST(StateOfAnotherRender, IsRefusedByName) {
    const ResumableCase what = small_cases().front();
    const Saved saved = saved_after(what, 1);
    EXPECT_EQ(complaint(what, saved), "");
    const std::string start = "the engine's saved state is of another render: other ";
    ResumableCase other = what;
    other.settings.seed += 1;
    EXPECT_EQ(complaint(other, saved), start + "seed");
    other = what;
    other.settings.mode = Mode::Ppm;
    EXPECT_EQ(complaint(other, saved), start + "mode");
    other = what;
    other.width += 1;
    EXPECT_EQ(complaint(other, saved), start + "image size");
    other = what;
    other.fog = true;
    EXPECT_EQ(complaint(other, saved), start + "media");
}

TEST(StateOfAnotherRender, SaysWhatIsDamaged) {
    const ResumableCase what = small_cases().front();
    Saved saved = saved_after(what, 1);
    std::fill(saved.state.end() - 8, saved.state.end(), std::byte{0xFF});
    EXPECT_EQ(complaint(what, saved),
              "the engine's saved state is damaged: a sum that is negative or not finite");
}

}  // namespace
}  // namespace aips::damaged_state_test
