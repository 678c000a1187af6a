// Protects the two parts of what samples saw: each has a mean over passes of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "film_accumulator.h"
#include "film_samples.h"
#include "run_on_threads.h"

namespace lxs::test::film_parts_test {
namespace {

constexpr std::uint32_t kWidth = 13, kHeight = 9;

/// A film of two light groups.
std::unique_ptr<FileFilm> film_of_groups() {
    SceneContents contents = scene_of_size(kWidth, kHeight);
    contents.light_groups = {"default", "sun"};
    set_option(contents, "PixelFilter", "mitchell", {});
    return make(contents);
}

/// Its samples in pass `pass`, of either part.
struct Parts {
    Samples seen;
    std::vector<Rgb> brought;
    double weight, second_weight;

    explicit Parts(unsigned pass) : weight(1.0 + pass), second_weight(7.0 - 2 * pass) {
        const auto film = film_of_groups();
        const auto value = [](float u) { return Rgb(1 + u, 2 + u * u, 3); };
        seen = random_samples(*film, 2000, pass, value);
        brought = random_samples(*film, 2000, 10 + pass, value).radiance;
    }
    PassSamples both() const {
        return {seen.positions, seen.radiance, 2, weight, brought, second_weight};
    }
};

/// Each part of what samples saw has the mean of its own weights, of the passes that have it, under
/// the filter and in each light group; the image is their sum.
TEST(FilmParts, HaveMeansOfTheirOwn) {
    const PixelFilter filter(1.5, 1.2, [](double x, double y) { return 2 - x * x - y * y; });
    FilmAccumulator both(kWidth, kHeight, 2, filter), first(both), second(both);
    for (unsigned pass = 0; pass < 3; ++pass) {
        Parts parts(pass);
        if (pass == 2) parts.brought.clear();
        both.add(parts.both());
        first.add(parts.seen.pass(parts.weight, 2));
        if (pass < 2) second.add({parts.seen.positions, parts.brought, 2, parts.second_weight});
    }
    std::vector<Rgb> sum(std::size_t{kWidth} * kHeight), a(sum), b(sum);
    for (const std::uint32_t group : {0u, 1u}) {
        both.resolve_group(group, sum);
        first.resolve_group(group, a);
        second.resolve_group(group, b);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(sum[i][c], a[i][c] + b[i][c], 1e-5) << group << ", " << i;
        }
    }
    both.clear();
    both.resolve_total(sum);
    for (const Rgb& pixel : sum)
        EXPECT_EQ(pixel, Rgb(0.0f));
}

TEST(FilmParts, SameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        concurrency::run_on(threads, [&] {
            const auto film = film_of_groups();
            for (unsigned pass = 0; pass < 3; ++pass)
                film->add_pass(Parts(pass).both());
            images.push_back(film->image());
        });
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
}

TEST(FilmParts, MemoryDoesNotGrowWithPassesAndIsNotTakenWithoutASecondPart) {
    const auto film = film_of_groups();
    const Parts parts(0);
    film->add_pass(parts.seen.pass(1, 2));
    const std::size_t without = film->memory_bytes();
    film->add_pass(parts.both());
    const std::size_t with = film->memory_bytes();
    // Sums of weights and colours of all pixels, and a pixel's for each row; and what is displayed.
    constexpr std::size_t kSums =
        std::size_t{kWidth} * kHeight * (7 * sizeof(double) + 4 * sizeof(float));
    EXPECT_GE(with - without, kSums);
    EXPECT_LE(with - without, kSums + std::size_t{kHeight} * 13 * sizeof(double));
    for (int pass = 0; pass < 20; ++pass)
        film->add_pass(parts.both());
    EXPECT_EQ(film->memory_bytes(), with);
}

/// A sample is refused whole if either part is bad, so that both have the same filter weights.
TEST(FilmParts, EitherMayBeRefused) {
    const auto film = make(scene_of_size(2, 2));
    Samples seen = pixel_centres(*film, Rgb(2.0f)), brought = pixel_centres(*film, Rgb(3.0f));
    for (const auto& [a, b] : {std::pair(std::nanf(""), 1.0f), std::pair(9.0f, -1.0f)}) {
        seen.positions.emplace_back(0.5f, 0.5f);
        seen.radiance.emplace_back(a);
        brought.radiance.emplace_back(b);
    }
    film->add_pass({seen.positions, seen.radiance, 1, 1, brought.radiance, 1});
    EXPECT_EQ(film->refused_samples(), 2u);
    for (const Rgb& pixel : film->image())
        EXPECT_EQ(pixel, Rgb(5.0f));
}

/// Two parts of different weights, whose wavelengths tint them differently.
TEST(FilmParts, WavelengthsOfEitherBecomeColours) {
    const auto film = make(scene_of_size(3, 2));
    const Rgb grey(0.5f);
    for (std::uint64_t pass = 0; pass < 3; ++pass) {
        const Wavelengths wavelengths = wavelengths_of_pass(5, pass);
        film->set_wavelengths(wavelengths);
        const Samples samples = pixel_centres(*film, wavelengths.values_of(grey));
        const double second_weight = 1 + 9 * double(pass);
        film->add_pass(
            {samples.positions, samples.radiance, 1, 1, samples.radiance, second_weight});
        for (const Rgb& pixel : film->image()) {
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixel[c], 1, 1e-6) << pass;
        }
    }
}

TEST(FilmParts, MalformedOnesAreTheCallersBug) {
    const auto film = make(scene_of_size(2, 2));
    const Samples samples = pixel_centres(*film, Rgb(1.0f));
    const auto with_second = [&](std::span<const Rgb> second, double weight) {
        film->add_pass({samples.positions, samples.radiance, 1, 1, second, weight});
    };
    EXPECT_THROW(with_second(std::span(samples.radiance).first(3), 1), std::invalid_argument);
    EXPECT_THROW(with_second(samples.radiance, 0), std::invalid_argument);
}

}  // namespace
}  // namespace lxs::test::film_parts_test
