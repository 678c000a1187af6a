// Protects the division of light between eye paths and emitter paths: an image with emitter paths
// has the expectation of one without, in scenes that nobody chose and in one whose light is mostly
// theirs; where images of a lamp are smaller than pixels they lessen the variance; and a film that
// takes no splats gets an image without them.
//
// Photons are left out: the part that they carry is the same. Welch tests of each scene's image
// mean and quarters, Sidak-corrected together.
#include <gtest/gtest.h>

#include "block_test.h"
#include "lamp_room.h"
#include "random_scenes.h"
#include "run_on_threads.h"
#include "test_form.h"

namespace aips::emitter_paths_test {
namespace {

constexpr std::uint32_t kSize = 12;

/// Loses what splats bring, or a part of it.
class LossyFilm final : public ImageFilm {
  public:
    LossyFilm(std::uint32_t groups, float kept, bool takes)
        : ImageFilm(kSize, kSize, groups), kept_(kept), takes_(takes) {}
    bool takes_splats() const override { return takes_; }
    void add_pass(const FilmPass& pass) override {
        FilmPass lossy = pass;
        had_splats_ = had_splats_ || pass.splats;
        if (pass.splats) {
            splats_.assign(pass.splats->radiance.begin(), pass.splats->radiance.end());
            for (Rgb& splat : splats_)
                splat *= kept_;
            lossy.splats->radiance = splats_;
        }
        ImageFilm::add_pass(lossy);
    }
    bool had_splats() const { return had_splats_; }

  private:
    float kept_;
    bool takes_, had_splats_ = false;
    std::vector<Rgb> splats_;
};

struct Shot {
    std::vector<double> means;  // of quarters and all
    EngineStatistics statistics;
    bool had_splats = false;
    std::vector<Rgb> image;
};

/// How a scene is rendered.
struct Way {
    bool emitter_paths = true;
    float kept = 1;  // of splats
    bool film_takes = true;
};

Shot shoot(const mock::View& view, std::uint64_t seed, unsigned passes, const Way& way) {
    Settings settings = mock::small_settings(seed, 1);
    settings.max_photon_depth = 1;
    settings.guide_emitters = way.emitter_paths;
    LossyFilm film(view.scene.light_groups(), way.kept, way.film_takes);
    const mock::Sampler sampler(seed);
    mock::Log log;
    Engine engine({view.scene, view.camera, sampler, film, log}, settings);
    for (unsigned pass = 0; pass < passes; ++pass)
        engine.render_pass(pass);
    std::vector<double> luminances;
    for (const Rgb& pixel : film.image())
        luminances.push_back(double(luminance(pixel)));
    Shot shot{statistics::block_means(luminances, kSize, kSize, 6), engine.statistics(),
              film.had_splats(), film.image()};
    shot.means.push_back(film.mean());
    return shot;
}

statistics::BlockMeans room_means(std::uint64_t first_seed, unsigned seeds, unsigned passes,
                                  const Way& way, float lamp_radius = 0.05f) {
    const mock::View view = mock::lamp_room(kSize, lamp_radius);
    statistics::BlockMeans means;
    for (unsigned s = 0; s < seeds; ++s)
        means.push_back(shoot(view, first_seed + s, passes, way).means);
    return means;
}

TEST(EmitterPaths, SameExpectationWhereLampsAreSeenInMirrorAndGlass) {
    constexpr float kRadius = 0.2f;
    const unsigned seeds = statistics::sized(20u, 40u);
    const auto without = room_means(1000, seeds, 3500, {.emitter_paths = false}, kRadius);
    const auto with = room_means(2000, seeds, 400, {}, kRadius);
    const auto same = statistics::compare(without, with, 0.01);
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_LT(same.detectable, statistics::sized(0.04, 0.025)) << same.describe();
    const auto lossy = room_means(2000, seeds, 400, {.kept = 0.9f}, kRadius);
    const auto lost = statistics::compare(without, lossy, 0.01);
    EXPECT_TRUE(lost.differs()) << "unnoticed that splats bring less: " << lost.describe();
}

TEST(EmitterPaths, LessenTheVarianceOfSmallImages) {
    const double without =
        statistics::mean_variance(room_means(3000, 20, 60, {.emitter_paths = false}));
    const double with = statistics::mean_variance(room_means(4000, 20, 60, {}));
    EXPECT_LT(10 * with, without);
}

TEST(EmitterPaths, SameExpectationInRandomScenes) {
    constexpr unsigned kSeeds = 20;
    statistics::BlockMeans without(kSeeds), with(kSeeds);
    std::uint64_t paths = 0;
    for (std::uint64_t scene = 0; scene < 20; ++scene) {
        const mock::View view =
            mock::random_view(scene, {.open = scene % 2 == 1, .no_points = true}, kSize, kSize);
        double mean = 0;
        for (unsigned s = 0; s < kSeeds; ++s)
            mean += shoot(view, 9000 + 100 * scene + s, 50, {.emitter_paths = false}).means.back();
        for (unsigned s = 0; s < kSeeds; ++s) {
            const auto add = [&](statistics::BlockMeans& to, const Shot& shot) {
                for (const double value : shot.means)
                    to[s].push_back(value * kSeeds / mean);
            };
            add(without, shoot(view, 20000 + 100 * scene + s, 50, {.emitter_paths = false}));
            const Shot shot = shoot(view, 40000 + 100 * scene + s, 50, {});
            add(with, shot);
            paths += shot.statistics.emitter_paths;
        }
    }
    EXPECT_GT(paths, 10000u);
    const auto same = statistics::compare(without, with, 0.01);
    EXPECT_FALSE(same.differs()) << "scene " << same.smallest_at / 5 << ", value "
                                 << same.smallest_at % 5 << ": " << same.describe();
    EXPECT_LT(same.detectable, 0.02) << same.describe();
}

TEST(EmitterPaths, BelongToTheirLightGroup) {
    const mock::View view = mock::lamp_room(kSize, 0.05f, 3);
    const auto r = mock::render(
        view.scene, view.camera, kSize, kSize,
        [] {
            Settings settings = mock::small_settings(5, 1);
            settings.max_photon_depth = 1;
            return settings;
        }(),
        20);
    EXPECT_GT(r.statistics.emitter_paths, 0u);
    EXPECT_EQ(r.film.image(), r.film.image_of_group(2));
}

TEST(EmitterPaths, SameBitsForAnyNumberOfThreads) {
    const mock::View view = mock::lamp_room(kSize);
    const auto image_with = [&](unsigned threads) {
        const Shot shot = concurrency::run_on(threads, [&] { return shoot(view, 7, 10, {}); });
        EXPECT_GT(shot.statistics.emitter_paths, 0u);
        EXPECT_LE(shot.statistics.memory_bytes, shot.statistics.memory_bound_bytes);
        return shot.image;
    };
    const auto one = image_with(1);
    EXPECT_EQ(one, image_with(2));
    EXPECT_EQ(one, image_with(7));
}

TEST(EmitterPaths, NoneForAFilmThatTakesNoSplats) {
    const mock::View view = mock::lamp_room(kSize);
    const Shot none = shoot(view, 7, 4, {.film_takes = false});
    EXPECT_FALSE(none.had_splats);
    EXPECT_EQ(none.statistics.emitter_searches, 0u);
    EXPECT_EQ(none.image, shoot(view, 7, 4, {.emitter_paths = false}).image);
    EXPECT_TRUE(shoot(view, 7, 4, {}).had_splats);
}

}  // namespace
}  // namespace aips::emitter_paths_test
