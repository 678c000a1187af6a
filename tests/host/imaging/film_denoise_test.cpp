// Protects what a film keeps for denoising: halves of its passes with their means and variances, an
// image that keeps its bits, the same denoised bits after a pause, refusal of foreign state.
#include "film_denoise.h"
#include "dark_beside_bright.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "film_samples.h"
#include "memory_archive.h"

namespace lxs::test::film_denoise_test {
namespace {

/// One sample a pixel around 1, with a brighter right half, and a surface for each.
void add_pass(FileFilm& film, unsigned pass) {
    std::mt19937 generator(pass);
    std::normal_distribution<float> normal;
    Samples samples = pixel_centres(film, Rgb(0.0f));
    std::vector<SeenSurface> seen(samples.positions.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const bool right = samples.positions[i].x > 12;
        samples.radiance[i] = Rgb(std::max(0.0f, (right ? 3.0f : 1.0f) + 0.3f * normal(generator)));
        seen[i] = {.albedo = Rgb(right ? 0.8f : 0.2f), .normal = Vec3(0, 0, 1), .depth = 5};
    }
    film.add_pass(samples.pass());
    film.add_surfaces(samples.positions, seen);
    film.end_pass();
}

std::unique_ptr<FileFilm> film(bool denoises) {
    auto film = make(scene_of_size(24, 16));
    film->keep_for_denoising(denoises);
    return film;
}

TEST(FilmDenoise, TheImageKeepsItsBits) {
    const auto with = film(true), without = film(false);
    for (unsigned pass = 0; pass < 20; ++pass) {
        add_pass(*with, pass);
        add_pass(*without, pass);
    }
    EXPECT_EQ(with->image(), without->image());
    EXPECT_TRUE(without->denoised().empty());
    EXPECT_EQ(without->layers_wanted(), LayersWanted{});
    EXPECT_EQ(with->layers_wanted(), FilmDenoise::guides());
}

TEST(FilmDenoise, LessNoiseThanInTheImage) {
    const auto film = film_denoise_test::film(true);
    for (unsigned pass = 0; pass < 37; ++pass)
        add_pass(*film, pass);
    const auto error = [](const std::vector<Rgb>& image) {
        double sum = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const std::size_t x = i % 24;
            sum += std::pow(image[i].y - (x < 12 ? 1 : 3), 2);
        }
        return sum;
    };
    EXPECT_LT(error(film->denoised()), error(film->image()) / 5);
}

TEST(FilmDenoise, ThereIsAnImageFromTheFourthPassOnAndNoneAfterClearing) {
    const auto film = film_denoise_test::film(true);
    for (unsigned pass = 1; pass <= 6; ++pass) {
        add_pass(*film, pass);
        EXPECT_EQ(film->denoised().empty(), pass < 4) << pass;
    }
    film->clear();
    EXPECT_TRUE(film->denoised().empty());
}

TEST(FilmDenoise, APauseChangesNoBit) {
    const auto whole = film(true);
    for (unsigned pass = 0; pass < 21; ++pass)
        add_pass(*whole, pass);
    const auto first = film(true), second = film(true);
    for (unsigned pass = 0; pass < 13; ++pass)
        add_pass(*first, pass);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    second->state(archive);
    EXPECT_EQ(archive.remaining(), 0u);
    for (unsigned pass = 13; pass < 21; ++pass)
        add_pass(*second, pass);
    EXPECT_EQ(second->denoised(), whole->denoised());
}

TEST(FilmDenoise, StateOfAnotherKindIsRefused) {
    const auto with = film(true), without = film(false);
    add_pass(*with, 0);
    add_pass(*without, 0);
    MemoryArchive denoises, plain;
    with->state(denoises);
    without->state(plain);
    denoises.restore();
    plain.restore();
    EXPECT_THROW(film(false)->state(denoises), StateError);
    EXPECT_THROW(film(true)->state(plain), StateError);
}

TEST(FilmDenoise, HalvesGetAlikeSharesOfEveryDigitOfThePass) {
    HalvesSchedule schedule;
    std::array<std::vector<std::uint64_t>, 2> halves;
    std::vector<std::uint64_t> open;
    for (std::uint64_t pass = 0; pass < 1000; ++pass) {
        open.push_back(pass);
        schedule.end_pass();
        if (!schedule.full()) continue;
        auto& half = halves[schedule.half()];
        half.insert(half.end(), open.begin(), open.end());
        open.clear();
        schedule.close();
    }
    for (const auto& half : halves) {
        const auto size = static_cast<double>(half.size());
        EXPECT_NEAR(size / 1000, 0.5, 0.1);
        for (const std::uint64_t digit : {1u, 2u, 4u, 8u}) {
            const auto set = std::count_if(half.begin(), half.end(),
                                           [&](std::uint64_t pass) { return (pass & digit) != 0; });
            EXPECT_NEAR(static_cast<double>(set) / size, 0.5, 0.05) << digit;
        }
    }
}

TEST(FilmDenoise, ARingBesideABrightPixelStaysDarkAndOneWithoutItDoesNot) {
    std::vector<Rgb> image(9, Rgb(1.0f)), denoised(9, Rgb(1.0f));
    image[3] = image[6] = Rgb(0.0f);
    denoised[5] = Rgb(50.0f);
    keep_dark_beside_bright({denoised, 9, 1, 2, 2}, image);
    const std::vector<Rgb> expected{Rgb(1.0f),  Rgb(1.0f), Rgb(1.0f), Rgb(0.0f), Rgb(1.0f),
                                    Rgb(50.0f), Rgb(0.0f), Rgb(1.0f), Rgb(1.0f)};
    EXPECT_EQ(denoised, expected);
    denoised.assign(9, Rgb(1.0f));
    keep_dark_beside_bright({denoised, 9, 1, 2, 2}, image);
    EXPECT_EQ(denoised, std::vector<Rgb>(9, Rgb(1.0f)));
}

TEST(FilmDenoise, ARingThatIsHalfFilledStaysDark) {
    std::vector<Rgb> image(9, Rgb(50.0f)), denoised(9, Rgb(50.0f));
    image[2] = image[6] = Rgb(1.0f);
    denoised[2] = Rgb(20.0f);
    denoised[6] = Rgb(30.0f);  // this one is bright itself, and chance has left it dark
    keep_dark_beside_bright({denoised, 9, 1, 2, 2}, image);
    EXPECT_EQ(denoised[2], Rgb(1.0f));
    EXPECT_EQ(denoised[6], Rgb(30.0f));
}

/// Two parts of unlike weights; the halves' means together are the mean of all.
TEST(FilmDenoise, HalvesMakeUpTheWhole) {
    const PixelFilter box(0.5, 0.5, [](double, double) { return 1.0; });
    FilmAccumulator film(2, 1, 1, box);
    HalfMeans halves(2);
    const std::vector<Vec2> positions{{0.5f, 0.5f}, {1.5f, 0.5f}};
    std::array<double, 2> sums{}, weights{}, second_sums{};
    std::array<int, 2> passes{};
    for (int pass = 0; pass < 12; ++pass) {
        const auto half = static_cast<std::size_t>(pass % 3 == 0 ? 0 : 1);
        const float first = static_cast<float>(pass), second = static_cast<float>(pass * pass);
        const double weight = 1 + pass % 4;
        const std::vector<Rgb> a(2, Rgb(first)), b(2, Rgb(second));
        film.add({positions, a, 1, 1, b, weight});
        halves.end_batch(film, half);
        sums[half] += double{first};
        ++passes[half];
        second_sums[half] += weight * double{second};
        weights[half] += weight;
    }
    for (std::size_t half = 0; half < 2; ++half) {
        const double mean = sums[half] / passes[half] + second_sums[half] / weights[half];
        EXPECT_NEAR(halves.mean(half, 1).y / mean, 1, 1e-5);
    }
    EXPECT_EQ(halves.memory_bytes(), 2 * 64u);
}

}  // namespace
}  // namespace lxs::test::film_denoise_test
