// Protects: to save what was learned changes no bit of a render; one that begins with it gives the
// same bits each time and after an interruption; what does not fit is left out, and what is damaged
// is refused or does no harm.
#include <gtest/gtest.h>

#include <algorithm>

#include "aips/core/sampling/random.h"
#include "resumable_render.h"
#include "test_form.h"

namespace aips::learned_test {
namespace {

using mock::Bytes;
using mock::ResumableCase;
using mock::ResumableRender;

Bytes learned_by(const ResumableCase& what, unsigned passes) {
    ResumableRender render(what);
    render.render_to(passes);
    return render.save_learned();
}

/// The scene a while later, with a seed of its own.
ResumableCase next_frame(const ResumableCase& what) {
    ResumableCase next = what;
    next.moved = 0.3f;
    next.settings.seed += 1;
    return next;
}

bool said(const mock::Log& log, const std::string& text) {
    return std::ranges::any_of(
        log.lines, [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

class Learned : public testing::TestWithParam<ResumableCase> {};

TEST_P(Learned, IsSavedWithoutATrace) {
    ResumableRender plain(GetParam()), saving(GetParam());
    for (unsigned pass = 1; pass <= 3; ++pass) {
        plain.render_to(pass);
        saving.render_to(pass);
        EXPECT_EQ(saving.save_learned(), saving.save_learned());
    }
    EXPECT_EQ(plain.film().image(), saving.film().image());
    EXPECT_EQ(plain.film().photon_weights(), saving.film().photon_weights());
}

TEST_P(Learned, GivesTheSameBitsWithAndWithoutABreak) {
    const ResumableCase next = next_frame(GetParam());
    const Bytes learned = learned_by(GetParam(), 3);
    ResumableRender straight(next), again(next);
    for (ResumableRender* render : {&straight, &again})
        render->take_learned(learned);
    again.render_to(1);
    // Goes on from its state alone.
    ResumableRender resumed(next, again.save(), again.film());
    straight.render_to(4);
    again.render_to(4);
    resumed.render_to(4);
    EXPECT_EQ(straight.film().image(), again.film().image());
    EXPECT_EQ(straight.film().image(), resumed.film().image());
    EXPECT_EQ(straight.save_learned(), resumed.save_learned());
    const EngineStatistics statistics = straight.statistics();
    EXPECT_LE(statistics.memory_bytes, statistics.memory_bound_bytes);
}

/// Small: much is tried.
ResumableCase smaller(ResumableCase what) {
    if (what.name != "lights") {
        what.width = 8;
        what.height = 6;
    }
    if (what.settings.photons_per_pass) what.settings.photons_per_pass = 1500;
    what.settings.max_nodes = 64;
    what.settings.cdf_resolution = 4;
    return what;
}

TEST_P(Learned, DamagedItIsRefusedOrDoesNoHarm) {
    if (GetParam().settings.photons_per_pass == 0) GTEST_SKIP() << "its passes are long";
    const ResumableCase what = smaller(GetParam());
    const Bytes learned = learned_by(what, 2);
    RandomStream random(9, 0, 0, RandomDomain::Photon);
    const unsigned trials = statistics::sized(10u, 24u);
    for (unsigned trial = 0; trial < trials; ++trial) {
        Bytes damaged = learned;
        const auto at =
            std::min(std::size_t(random.next() * float(damaged.size())), damaged.size() - 1);
        damaged[at] ^= std::byte(1u << (random.next_uint() % 8));
        SCOPED_TRACE(testing::Message() << "byte " << at << " of " << damaged.size());
        ResumableRender render(what);
        try {
            render.take_learned(damaged);
        } catch (const StateError&) {
            continue;
        }
        render.render_pass();
        for (const Rgb& pixel : render.film().image())
            EXPECT_TRUE(is_valid_radiance(pixel));
        const EngineStatistics statistics = render.statistics();
        EXPECT_LE(statistics.memory_bytes, statistics.memory_bound_bytes);
    }
    for (std::size_t length = 0; length < learned.size(); length += learned.size() / 20 + 1) {
        ResumableRender render(what);
        EXPECT_THROW(render.take_learned(std::span(learned).first(length)), StateError) << length;
    }
}

/// All but one: what a lagging guide has learned is what any adaptive one has.
std::vector<ResumableCase> learning_cases() {
    std::vector<ResumableCase> cases = mock::resumable_cases();
    std::erase_if(cases, [](const ResumableCase& what) { return what.name == "lagging_guide"; });
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Renders, Learned, testing::ValuesIn(learning_cases()),
                         [](const auto& test) { return test.param.name; });

ResumableCase case_named(const std::string& name) {
    for (const ResumableCase& what : mock::resumable_cases()) {
        if (what.name == name) return what;
    }
    throw std::logic_error("no case " + name);
}

TEST(LearnedOfAnotherScene, IsTakenWhereItFits) {
    const ResumableCase what = case_named("progressive_adaptive");
    const Bytes learned = learned_by(what, 2);
    ResumableRender same(next_frame(what));
    same.take_learned(learned);
    EXPECT_TRUE(said(same.log(), "learned before: lights, "));
    EXPECT_TRUE(said(same.log(), "emission, survival, directions"));
    EXPECT_FALSE(said(same.log(), "does not fit"));

    ResumableCase lit = what;
    lit.another_lamp = true;
    ResumableRender other(lit);
    other.take_learned(learned);
    EXPECT_TRUE(said(other.log(), "as it does not fit: lights, emission"));
    EXPECT_TRUE(said(other.log(), "survival, directions"));

    ResumableCase small = what;
    small.width = 10;
    small.height = 7;
    ResumableRender sized(small);
    sized.take_learned(learned);
    EXPECT_TRUE(said(sized.log(), "as it does not fit: photons per pass, brightness of pixels"));
}

TEST(LearnedOfAnotherScene, OtherSettingsTakeWhatTheyUse) {
    ResumableRender plain(case_named("progressive_none"));
    plain.take_learned(learned_by(case_named("progressive_adaptive"), 2));
    EXPECT_TRUE(said(plain.log(), "learned before: lights"));
    plain.render_to(2);
}

TEST(LearnedOfAnotherScene, IsOfThisVersion) {
    const ResumableCase what = case_named("progressive_none");
    Bytes learned = learned_by(what, 1);
    learned[0] ^= std::byte{1};
    ResumableRender render(what);
    EXPECT_THROW(render.take_learned(learned), StateError);
}

TEST(LearnedOfAnotherScene, BelongsBeforeTheFirstPass) {
    const ResumableCase what = case_named("progressive_none");
    ResumableRender render(what);
    render.render_to(1);
    const Bytes learned = render.save_learned();
    EXPECT_THROW(render.take_learned(learned), std::logic_error);
}

}  // namespace
}  // namespace aips::learned_test
