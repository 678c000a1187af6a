// Protects the passes without photons: the expectation is that of passes which all shoot, wherever
// a render ends.
//
// Three random rooms open to the sky, of which photons bring little: one of several passes shoots
// from pass 8 on, and a render of 21 passes ends between two of them. Welch tests of each scene's
// image mean and quarters, Sidak-corrected together.
#include <gtest/gtest.h>

#include "block_test.h"
#include "random_scenes.h"

namespace aips::passes_without_photons_test {
namespace {

constexpr std::uint32_t kSize = 48;
constexpr unsigned kSeeds = 12, kPasses = 21;

struct Renders {
    statistics::BlockMeans means;  // [seed][scene * 5 + value]
    unsigned without = 0;          // passes
};

Renders renders(bool photon_turns, std::uint64_t first_seed) {
    Renders result;
    result.means.resize(kSeeds);
    for (const std::uint64_t scene : {5u, 15u, 17u}) {
        const mock::View view = mock::random_view(scene, {true}, kSize, kSize);
        for (unsigned s = 0; s < kSeeds; ++s) {
            Settings settings = mock::small_settings(first_seed + 100 * scene + s, 0);
            settings.start_radius = 1;
            settings.photon_turns = photon_turns;
            mock::Film film(kSize, kSize, view.scene.light_groups());
            const mock::Sampler sampler(settings.seed);
            mock::Log log;
            Engine engine({view.scene, view.camera, sampler, film, log}, settings);
            for (unsigned pass = 0; pass < kPasses; ++pass)
                result.without += engine.render_pass(pass).photon_paths == 0;
            auto values = statistics::block_means(mock::luminances(film), kSize, kSize, kSize / 2);
            values.push_back(film.mean());
            result.means[s].insert(result.means[s].end(), values.begin(), values.end());
        }
    }
    return result;
}

TEST(PassesWithoutPhotons, KeepTheExpectation) {
    const Renders all = renders(false, 1000), some = renders(true, 2000);
    EXPECT_EQ(all.without, 0u);
    EXPECT_GT(some.without, 12 * kSeeds);
    const auto same = statistics::compare(all.means, some.means, 0.01);
    EXPECT_FALSE(same.differs()) << "scene " << same.smallest_at / 5 << ": " << same.describe();
    EXPECT_LT(same.detectable, 0.05) << same.describe();
    const auto found = statistics::compare(all.means, statistics::scaled(some.means, 1.05), 0.01);
    EXPECT_TRUE(found.differs()) << "a planted bias went unnoticed: " << found.describe();
}

}  // namespace
}  // namespace aips::passes_without_photons_test
