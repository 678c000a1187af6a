// Protects: a render that is saved between two passes and goes on in a new engine gives the bits of
// the uninterrupted one, film, layers, statistics and later states alike, whatever was learned.
#include <gtest/gtest.h>

#include "guides/adaptive/constants.h"
#include "resumable_render.h"
#include "test_form.h"

namespace aips::engine_state_test {
namespace {

using mock::ResumableCase;
using mock::ResumableRender;

void expect_same_film(const mock::Film& film, const mock::Film& other) {
    EXPECT_EQ(film.photon_weights(), other.photon_weights());
    EXPECT_EQ(film.image(), other.image());
    EXPECT_EQ(film.layers(), other.layers());
    ASSERT_EQ(film.color_layers().size(), other.color_layers().size());
    for (const auto& [name, layer] : film.color_layers())
        EXPECT_EQ(layer.image(), other.color_layers().at(name).image()) << name;
}

void expect_same_transport(const TransportStatistics& a, const TransportStatistics& b) {
    const auto of_lights = [](const TransportStatistics& transport) {
        std::vector<double> all{double(transport.cut_eye_paths)};
        for (const LightStatistics& t : transport.lights)
            all.insert(all.end(), {double(t.paths), double(t.counted), t.seen, t.photons});
        return all;
    };
    const auto of_materials = [](const TransportStatistics& transport) {
        std::vector<std::uint64_t> all;
        for (const MaterialStatistics& t : transport.materials)
            all.insert(all.end(), {t.hits, t.stored, t.unseen, t.direct, t.specular, t.black, t.cut,
                                   t.cut_specular});
        return all;
    };
    EXPECT_EQ(of_lights(a), of_lights(b));
    EXPECT_EQ(of_materials(a), of_materials(b));
}

/// All but times and how much memory vectors hold.
void expect_same_statistics(const EngineStatistics& a, const EngineStatistics& b) {
    const auto counts = [](const EngineStatistics& s) {
        return std::vector<std::uint64_t>{
            s.passes,           s.eye_paths,          s.eye_rays,
            s.photon_paths,     s.photon_rays,        s.photons,
            s.split_off,        s.gathered,           s.bounces,
            s.guided_bounces,   s.measured_paths,     s.visible_paths,
            s.guide_nodes,      s.bounce_tables,      s.pruned_paths,
            s.photons_per_pass, s.memory_bound_bytes, s.continued_paths,
            s.emitter_paths,    s.emitter_searches,   s.emitter_rays,
            s.emitter_images};
    };
    const auto values = [](const EngineStatistics& s) {
        return std::vector<double>{s.mutation_size,  s.emission_gain,    s.survival_gain,
                                   s.bounce_gain,    s.score_times_cost, s.pruned_emission,
                                   double(s.radius), s.eye_share};
    };
    expect_same_transport(a.transport, b.transport);
    EXPECT_EQ(counts(a), counts(b));
    EXPECT_EQ(values(a), values(b));
    EXPECT_EQ(a.refused, b.refused);
    EXPECT_LE(b.memory_bytes, b.memory_bound_bytes);
}

/// A state without the times at its end.
std::span<const std::byte> timeless(const mock::Bytes& state) {
    return std::span(state).first(state.size() - Engine::kStateSecondsBytes);
}

struct Interruption {
    mock::Bytes state;
    mock::Film film;
    std::size_t said = 0;  // lines of the log
};

std::vector<std::string> said_since(const mock::Log& log, std::size_t line) {
    return {log.lines.begin() + std::ptrdiff_t(line), log.lines.end()};
}

/// In the short form after a third or so of the passes, and after all.
std::vector<unsigned> interrupted_after(unsigned passes) {
    if (!statistics::long_form()) return {(passes + 2) / 3, passes};
    std::vector<unsigned> all;
    for (unsigned pass = 0; pass <= passes; pass += passes > 5 ? 3 : 1)
        all.push_back(pass);
    return all;
}

class EngineState : public testing::TestWithParam<ResumableCase> {};

TEST_P(EngineState, GoesOnWithTheSameBits) {
    const ResumableCase& what = GetParam();
    ResumableRender straight(what);
    std::vector<Interruption> interruptions;
    for (unsigned pass = 0; pass <= what.passes; ++pass) {
        straight.render_to(pass);
        interruptions.push_back({straight.save(), straight.film(), straight.log().lines.size()});
        EXPECT_EQ(interruptions.back().state, straight.save()) << "saved twice";
    }
    ResumableRender unrendered(what, interruptions[0].state, interruptions[0].film);
    EXPECT_EQ(unrendered.save(), interruptions[0].state) << "saved before the first pass";
    for (const unsigned pass : interrupted_after(what.passes)) {
        SCOPED_TRACE("interrupted after pass " + std::to_string(pass));
        ResumableRender resumed(what, interruptions[pass].state, interruptions[pass].film);
        EXPECT_EQ(resumed.save(), interruptions[pass].state) << "saved where it was restored";
        resumed.render_to(what.passes);
        expect_same_film(straight.film(), resumed.film());
        expect_same_statistics(straight.statistics(), resumed.statistics());
        EXPECT_EQ(said_since(straight.log(), interruptions[pass].said),
                  said_since(resumed.log(), interruptions[0].said));
        const mock::Bytes& last = interruptions.back().state;
        const mock::Bytes state = resumed.save();
        EXPECT_TRUE(std::ranges::equal(timeless(state), timeless(last)));
    }
}

/// What the cases are named after has happened in them.
TEST(ResumableCases, ExploreOrLeaveTheGuideOutWhereTheySaySo) {
    for (const ResumableCase& what : mock::resumable_cases()) {
        if (what.name != "explored" && what.name != "needless_guide") continue;
        ResumableRender render(what);
        render.render_to(2);
        EXPECT_EQ(render.statistics().guide_bytes > 0, what.name == "explored") << what.name;
        EXPECT_EQ(std::ranges::any_of(
                      render.log().lines,
                      [](const std::string& line) { return line.starts_with("explored: "); }),
                  what.name == "explored");
    }
}

TEST(ResumableCases, HavePassesWithoutPhotonsWhereTheySaySo) {
    for (const ResumableCase& what : mock::resumable_cases()) {
        if (what.name != "photon_turns") continue;
        ResumableRender render(what);
        unsigned without = 0;
        for (unsigned pass = 1; pass <= what.passes; ++pass) {
            const std::uint64_t before = render.statistics().photon_paths;
            render.render_to(pass);
            without += render.statistics().photon_paths == before;
        }
        EXPECT_GE(without, 3u);
    }
}

TEST(ResumableCases, LearnBesideTracingWhereTheySaySo) {
    for (const ResumableCase& what : mock::resumable_cases()) {
        if (what.name != "lagging_guide") continue;
        ResumableRender render(what);
        render.render_to(what.passes);
        EXPECT_GT(render.statistics().photon_paths, kEagerPaths + what.settings.photons_per_pass);
    }
}

TEST(ResumableCases, DrawEmitterPathsWhereTheySaySo) {
    for (const ResumableCase& what : mock::resumable_cases()) {
        if (!what.lamps) continue;
        ResumableRender render(what);
        render.render_to(2);
        EXPECT_GT(render.statistics().emitter_paths, 0u) << what.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Renders, EngineState, testing::ValuesIn(mock::resumable_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace aips::engine_state_test
