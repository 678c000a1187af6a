// Protects the first rule of guiding in scenes that nobody chose: whatever decides where photons
// go, and however many a pass shoots, the expected image is the same.
//
// Eight random rooms (long form: thirty), a fixed radius, independent renders. Welch tests of
// each scene's image mean and its four quarters, and of the mean over all scenes (each relative to
// its own), are Sidak-corrected together: 41 or 151 tests a setting at 1 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "block_test.h"
#include "random_scenes.h"
#include "test_form.h"

namespace aips::random_scenes_test {
namespace {

constexpr std::uint32_t kSize = 12;
constexpr std::size_t kValues = 5;  // of a scene: four quarters and the whole image
constexpr double kSignificance = 0.01;
constexpr std::uint32_t kManyEyePaths = 4500;  // a pass

std::uint64_t scenes() {
    return statistics::sized(8u, 30u);
}

/// How all scenes are rendered.
struct Way {
    std::function<void(Settings&)> choose;
    std::uint64_t first_seed = 0;
    unsigned seeds = 16;
    unsigned passes = 6;
};

/// Parts of the renders of all scenes that a guide decided.
struct Guided {
    std::uint64_t bounces = 0, guided_bounces = 0;
    unsigned emission = 0, survival = 0;  ///< scenes whose first render says that they gained
    std::uint32_t most = 0;               ///< photons per pass at the end
};

/// Settings of a scene that all ways have in common.
Settings scene_settings(std::uint64_t scene) {
    Settings settings = mock::small_settings(0, 2560);
    settings.hit_points_per_pass = 3 * kSize * kSize;
    settings.start_radius = 1;
    settings.max_photon_depth = 8;
    settings.direct_light_sampling = scene % 4 == 3;
    settings.store_glossy = scene % 5 == 4;
    settings.iteration_photons = 1300;
    settings.initial_photons = 500;
    return settings;
}

/// Values of every scene, one after another: [seed][scene * kValues + value].
statistics::BlockMeans renders(const Way& way, Guided& guided) {
    statistics::BlockMeans means(way.seeds);
    for (std::uint64_t scene = 0; scene < scenes(); ++scene) {
        const bool open = scene % 2 == 1;
        const mock::View view = mock::random_view(scene, {open}, kSize, kSize);
        for (unsigned s = 0; s < way.seeds; ++s) {
            Settings settings = scene_settings(scene);
            settings.seed = way.first_seed + 100 * scene + s;
            way.choose(settings);
            const auto r =
                mock::render(view.scene, view.camera, kSize, kSize, settings, way.passes);
            auto values = statistics::block_means(mock::luminances(r.film), kSize, kSize, 6);
            values.push_back(r.film.mean());
            means[s].insert(means[s].end(), values.begin(), values.end());
            guided.bounces += r.statistics.bounces;
            guided.guided_bounces += r.statistics.guided_bounces;
            guided.most = std::max(guided.most, r.statistics.photons_per_pass);
            guided.emission += r.statistics.emission_gain > 1.05 && s == 0;
            guided.survival += r.statistics.survival_gain > 1.05 && s == 0;
        }
    }
    return means;
}

/// Scenes in whose mean or quarters a bias of `planted` is found, as one test of all of them.
std::size_t scenes_found(const statistics::BlockMeans& a, const statistics::BlockMeans& b,
                         double planted, double threshold) {
    std::size_t found = 0;
    for (std::size_t scene = 0; scene < scenes(); ++scene) {
        std::vector<std::size_t> values(kValues);
        std::iota(values.begin(), values.end(), scene * kValues);
        const auto biased = statistics::scaled(statistics::select(b, values), 1 + planted);
        const auto one = statistics::compare(statistics::select(a, values), biased, kSignificance);
        found += one.smallest_p < threshold ? 1 : 0;
    }
    return found;
}

/// Expects the expectation of `plain`. A bias of 4 % (long form: 3 %) of all scenes must be found
/// in their mean, one of 5 % of a single scene in most of them.
Guided expect_same(const statistics::BlockMeans& plain, const Way& way) {
    Guided guided;
    const auto rendered = renders(way, guided);
    const auto a = statistics::relative_to(plain, plain, kValues),
               b = statistics::relative_to(plain, rendered, kValues);
    const auto same = statistics::compare(a, b, kSignificance);
    EXPECT_FALSE(same.differs()) << "scene " << same.smallest_at / kValues << ": "
                                 << same.describe();
    const double planted = statistics::sized(0.04, 0.03);
    EXPECT_LT(same.detectable, planted) << same.describe();
    const auto found = statistics::compare(a, statistics::scaled(b, 1 + planted), kSignificance);
    EXPECT_TRUE(found.differs()) << "a planted bias went unnoticed: " << found.describe();
    EXPECT_GT(2 * scenes_found(a, b, 0.05, same.threshold), scenes());
    return guided;
}

void plain(Settings& /*settings*/) {}
void bounces(Settings& settings) {
    settings.guide = GuideKind::Adaptive;
}

TEST(RandomScenes, SameExpectationWhateverTheGuide) {
    const auto paper = [](Settings& s) { s.guide = GuideKind::Paper; };
    const auto adaptive = [](Settings& s) {
        s.guide = GuideKind::Adaptive;
        s.guide_bounces = false;
    };
    const auto by_noise = [](Settings& s) {
        s.photons_per_pass = 0;
        s.hit_points_per_pass = kManyEyePaths;
    };
    Guided none;
    const auto reference = renders({plain, 10000, 20}, none);
    {
        SCOPED_TRACE("paper");
        const Guided guided = expect_same(reference, {paper, 20000, 12});
        EXPECT_GT(double(guided.guided_bounces), 0.1 * double(guided.bounces));
    }
    {
        SCOPED_TRACE("adaptive");
        const Guided guided = expect_same(reference, {adaptive, 30000, 14});
        EXPECT_GE(guided.emission, statistics::sized(2u, 3u));
        EXPECT_GE(guided.survival, statistics::sized(2u, 3u));
    }
    {
        SCOPED_TRACE("adaptive, with directions");
        const Guided guided = expect_same(reference, {bounces, 40000, 14});
        EXPECT_GT(double(guided.guided_bounces), 0.005 * double(guided.bounces));
    }
    {
        SCOPED_TRACE("photons by the noise");
        const Guided chosen = expect_same(reference, {by_noise, 50000, 6, 7});
        EXPECT_NE(chosen.most, kManyEyePaths) << "what each render began with";
    }
}

}  // namespace
}  // namespace aips::random_scenes_test
