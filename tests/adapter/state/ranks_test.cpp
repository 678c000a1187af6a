// Protects: ranks that share the work of each pass all get the bits of one process alone, film and
// state alike, whatever their number; and a state goes on with any other number of them.
#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <stdexcept>

#include "resumable_render.h"
#include "thread_ranks.h"

namespace aips::ranks_test {
namespace {

using mock::ResumableCase;
using mock::ResumableRender;

constexpr unsigned kMostPasses = 3;

/// A state without the times at its end.
mock::Bytes timeless(const mock::Bytes& state) {
    return {state.begin(), state.end() - Engine::kStateSecondsBytes};
}

struct Rendered {
    std::vector<Rgb> image;
    mock::Bytes state;
    std::uint64_t photon_paths = 0, eye_rays = 0, gathered = 0;

    explicit Rendered(ResumableRender& render)
        : image(render.film().image()), state(timeless(render.save())) {
        const EngineStatistics s = render.statistics();
        photon_paths = s.photon_paths;
        eye_rays = s.eye_rays;
        gathered = s.gathered;
    }
    bool operator==(const Rendered&) const = default;
};

/// By each of `count` ranks; what they told each other is added to `bytes`.
std::vector<Rendered> rendered_by(std::uint32_t count, const ResumableCase& what,
                                  std::size_t* bytes = nullptr) {
    std::vector<std::optional<Rendered>> of_ranks(count);
    mock::ThreadRanks job(count);
    job.run([&](Ranks& ranks) {
        ResumableRender render(what, &ranks);
        render.render_to(what.passes);
        of_ranks[ranks.rank()].emplace(render);
    });
    if (bytes) *bytes += job.bytes();
    std::vector<Rendered> all;
    all.reserve(of_ranks.size());
    for (std::optional<Rendered>& one : of_ranks)
        all.push_back(std::move(*one));
    return all;
}

/// Whether each rank does all of the work.
bool by_itself(const ResumableCase& what) {
    return what.fog || what.settings.debug_layers;
}

/// With more than one block of eye paths.
std::vector<ResumableCase> shared_cases() {
    std::vector<ResumableCase> cases;
    for (ResumableCase what : mock::resumable_cases()) {
        // One of each is enough where nothing is shared.
        if (by_itself(what) && what.settings.guide != GuideKind::Adaptive) continue;
        what.settings.transport_statistics = false;
        what.passes = std::min(what.passes, kMostPasses);
        if (!by_itself(what)) {
            what.width *= 2;
            what.height *= 2;
        }
        cases.push_back(what);
    }
    return cases;
}

class RanksOf : public testing::TestWithParam<ResumableCase> {};

TEST_P(RanksOf, HaveTheBitsOfOneProcess) {
    const ResumableCase& what = GetParam();
    ResumableRender alone(what);
    alone.render_to(what.passes);
    const Rendered expected(alone);
    std::size_t bytes = 0;
    for (const Rendered& rank : rendered_by(3, what, &bytes)) {
        EXPECT_TRUE(rank.image == expected.image);
        EXPECT_TRUE(rank.state == expected.state);
        EXPECT_TRUE(rank == expected);
    }
    EXPECT_EQ(bytes == 0, by_itself(what));
}

INSTANTIATE_TEST_SUITE_P(Renders, RanksOf, testing::ValuesIn(shared_cases()),
                         [](const auto& test) { return test.param.name; });

ResumableCase guided_case() {
    ResumableCase what{"guided", mock::small_settings(5, 20000)};
    what.settings.guide = GuideKind::Adaptive;
    what.settings.alpha = 0.7;
    what.width = 64;
    what.height = 48;
    what.passes = 3;
    return what;
}

TEST(Ranks, MayBeMoreThanBlocksAndAnyNumber) {
    const ResumableCase what = guided_case();
    ResumableRender alone(what);
    alone.render_to(what.passes);
    const Rendered expected(alone);
    for (const std::uint32_t count : {1u, 2u, 5u, 11u}) {
        for (const Rendered& rank : rendered_by(count, what))
            EXPECT_TRUE(rank == expected) << count << " ranks";
    }
}

TEST(Ranks, GoOnFromWhatAnotherNumberOfThemSaved) {
    const ResumableCase what = guided_case();
    ResumableRender alone(what);
    alone.render_to(what.passes);
    const Rendered expected(alone);
    mock::Bytes saved;
    mock::ThreadRanks two(2);
    std::optional<mock::Film> film;
    two.run([&](aips::Ranks& ranks) {
        ResumableRender render(what, &ranks);
        render.render_to(1);
        if (ranks.rank() > 0) return;
        saved = render.save();
        film.emplace(render.film());
    });
    mock::ThreadRanks three(3);
    three.run([&](aips::Ranks& ranks) {
        ResumableRender render(what, saved, *film, &ranks);
        render.render_to(what.passes);
        EXPECT_TRUE(Rendered(render) == expected);
    });
}

TEST(Ranks, EndWhereOneIsGone) {
    mock::ThreadRanks job(3);
    std::atomic<int> told{0};
    EXPECT_THROW(job.run([&](aips::Ranks& ranks) {
        if (ranks.rank() == 1) throw std::runtime_error("this one");
        ResumableRender render(guided_case(), &ranks);
        try {
            render.render_to(1);
        } catch (const std::runtime_error&) {
            ++told;
            throw;
        }
    }),
                 std::runtime_error);
    EXPECT_EQ(told, 2) << "the others rendered on without it";
}

}  // namespace
}  // namespace aips::ranks_test
