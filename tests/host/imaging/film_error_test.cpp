// Protects the film's estimate of its own error: variances of means over passes of known noise,
// whatever the passes' weights; an interval that holds the true error; the same image with and
// without; the same figures on any number of threads and after a pause; refusal of foreign state.
#include "film_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "film_samples.h"
#include "memory_archive.h"
#include "pixel_variance.h"
#include "run_on_threads.h"

namespace lxs::test::film_error_test {
namespace {

constexpr std::uint32_t kSide = 64;
constexpr std::size_t kPixels = std::size_t{kSide} * kSide;

PixelFilter box() {
    return {0.5, 0.5, [](double, double) { return 1.0; }};
}

std::vector<Vec2> centres() {
    std::vector<Vec2> positions;
    for (std::uint32_t row = 0; row < kSide; ++row) {
        for (std::uint32_t column = 0; column < kSide; ++column)
            positions.emplace_back(static_cast<float>(column) + 0.5f,
                                   static_cast<float>(row) + 0.5f);
    }
    return positions;
}

/// Passes of two parts with Gaussian noise of deviations 1 and 2 and covariance 1, around 50 and
/// 100; the second part's weight is 1 at first and 8 from the eighth pass on, as the engine's are.
class NoisyPasses {
  public:
    explicit NoisyPasses(unsigned seed) : generator_(seed) {}

    double weight(int pass) const { return pass < 7 ? 1 : 8; }
    PassSamples next() {
        std::normal_distribution<float> normal;
        first_.clear(), second_.clear();
        for (std::size_t i = 0; i < kPixels; ++i) {
            const float common = normal(generator_);
            first_.emplace_back(50 + common);
            second_.emplace_back(100 + common + std::sqrt(3.0f) * normal(generator_));
        }
        return {positions_, first_, 1, 1, second_, weight(pass_++)};
    }
    /// Of the image after so many passes.
    double variance(int passes) const {
        double sum = 0, squares = 0;
        for (int i = 0; i < passes; ++i) {
            sum += weight(i);
            squares += weight(i) * weight(i);
        }
        return 1.0 / passes + 4 * squares / (sum * sum) + 2.0 / passes;
    }

  private:
    std::mt19937 generator_;
    int pass_ = 0;
    std::vector<Vec2> positions_ = centres();
    std::vector<Rgb> first_, second_;
};

/// A film's sums and what watches them.
struct Watched {
    FilmAccumulator film{kSide, kSide, 1, box()};
    FilmError error{kSide, kSide};

    void add(const PassSamples& pass) {
        film.add(pass);
        error.add(pass);
        error.end_pass(film);
    }
    double mean_variance() const {
        std::vector<Rgb> deviations(kPixels);
        error.standard_errors(film, deviations);
        double sum = 0;
        for (const Rgb& deviation : deviations)
            sum += double{deviation.y} * double{deviation.y};
        return sum / kPixels;
    }
};

TEST(FilmError, VarianceIsThatOfTheMeanOverWeightedPasses) {
    NoisyPasses passes(1);
    Watched watched;
    for (int n = 1; n <= 100; ++n) {
        watched.add(passes.next());
        if (n != 3 && n != 10 && n != 24 && n != 60 && n != 100) continue;
        // A mean of 4096 variances; at n = 3 each rests on two squares at most.
        const double five_deviations =
            5 * std::sqrt(2 / (n == 3 ? 0.8 : 2.5) / static_cast<double>(kPixels));
        EXPECT_NEAR(watched.mean_variance() / passes.variance(n), 1, five_deviations) << n;
    }
}

TEST(FilmError, VarianceIsKnownFromTheThirdPassOn) {
    NoisyPasses passes(2);
    Watched watched;
    for (int n = 1; n <= 3; ++n) {
        watched.add(passes.next());
        EXPECT_EQ(watched.error.estimate(watched.film).has_value(), n == 3);
    }
    watched.film.clear();
    watched.error.clear();
    watched.add(passes.next());
    EXPECT_FALSE(watched.error.known());
}

TEST(FilmError, PassesThatComplementEachOtherLeaveLessThanTheirDifferencesSay) {
    NoisyPasses passes(3);
    Watched watched;
    std::vector<Rgb> other;
    for (int n = 0; n < 100; ++n) {
        PassSamples pass = passes.next();
        pass.second_radiance = {};
        watched.add(pass);
        other.clear();
        for (const Rgb& value : pass.radiance)
            other.emplace_back(100 - value.x);
        pass.radiance = other;
        watched.add(pass);
    }
    // Independent passes of deviation 1 would leave 1 / 200, and these leave nothing.
    EXPECT_LT(watched.mean_variance(), 0.2 / 200);
}

TEST(FilmError, SplatsCount) {
    std::mt19937 generator(4);
    std::normal_distribution<float> normal(20, 2);
    Watched watched;
    std::vector<Rgb> radiance(kPixels);
    const std::vector<Vec2> positions = centres();
    for (int n = 0; n < 50; ++n) {
        for (Rgb& value : radiance)
            value = Rgb(normal(generator));
        const PassSplats splats{positions, radiance, 1, static_cast<double>(kPixels)};
        watched.film.add_splats(splats);
        watched.error.add(splats);
        watched.error.end_pass(watched.film);
    }
    EXPECT_NEAR(watched.mean_variance() / (4.0 / 50), 1,
                5 * std::sqrt(2 / 2.5 / static_cast<double>(kPixels)));
}

/// Squared relative error of the image, and what it was estimated as.
TEST(FilmError, TheIntervalHoldsTheTrueErrorOfNineteenImagesOfTwenty) {
    constexpr int kImages = 40;
    int held = 0, held_rmse = 0;
    double ratios = 0;
    for (unsigned seed = 0; seed < kImages; ++seed) {
        NoisyPasses passes(100 + seed);
        Watched watched;
        for (int n = 0; n < 12; ++n)
            watched.add(passes.next());
        const ErrorEstimate estimate = *watched.error.estimate(watched.film);
        double squared = 0;
        for (std::size_t i = 0; i < kPixels; ++i) {
            const PixelMeans means = watched.film.means(i);
            const double error = means.value[0].x + means.value[1].x - 150;
            squared += error * error / kPixels;
        }
        const double relmse = squared / (150.0 * 150.0);
        held += estimate.relmse_low <= relmse && relmse <= estimate.relmse_high;
        held_rmse +=
            estimate.rmse_low <= std::sqrt(squared) && std::sqrt(squared) <= estimate.rmse_high;
        ratios += estimate.relmse_whole / relmse / kImages;
    }
    // Fewer than 33 of 40 would have a probability of 10^-3 where the interval's is 0.95.
    EXPECT_GE(held, 33);
    EXPECT_GE(held_rmse, 33);
    EXPECT_NEAR(ratios, 1, 0.05);
}

TEST(FilmError, ABrightPathCountsByWhatIsAroundIt) {
    Watched watched;
    const std::vector<Vec2> positions = centres();
    std::vector<Rgb> radiance(kPixels, Rgb(1.0f));
    for (int n = 0; n < 20; ++n) {
        radiance[kPixels / 2 + 7] = Rgb(n == 11 ? 2001.0f : 1.0f);
        watched.add({positions, radiance});
    }
    // The pixel is 101 instead of 1: the true figure of the whole is 100^2 / 4096.
    const ErrorEstimate estimate = *watched.error.estimate(watched.film);
    EXPECT_NEAR(estimate.relmse_whole / (100 * 100 / double{kPixels}), 1, 0.5);
    EXPECT_EQ(estimate.relmse, 0);
}

TEST(FilmError, FiguresAreTheSameOnAnyNumberOfThreads) {
    const auto estimate = [] {
        NoisyPasses passes(5);
        Watched watched;
        for (int n = 0; n < 9; ++n)
            watched.add(passes.next());
        return *watched.error.estimate(watched.film);
    };
    const ErrorEstimate one = concurrency::run_on(1, estimate);
    const ErrorEstimate four = concurrency::run_on(4, estimate);
    EXPECT_EQ(one.relmse, four.relmse);
    EXPECT_EQ(one.relmse_high, four.relmse_high);
    EXPECT_EQ(one.rmse, four.rmse);
}

TEST(FilmError, MemoryIsFlat) {
    NoisyPasses passes(6);
    Watched watched;
    for (int n = 0; n < 3; ++n)
        watched.add(passes.next());
    EXPECT_EQ(watched.error.memory_bytes(), 60 * kPixels);
    for (int n = 0; n < 60; ++n)
        watched.add(passes.next());
    EXPECT_EQ(watched.error.memory_bytes(), 60 * kPixels);
}

/// A film of the host as a whole, watched from its first pass on or not.
std::unique_ptr<FileFilm> small_film(bool watched, int width = 9, int height = 7) {
    auto film = make(scene_of_size(width, height));
    film->estimate_errors(watched);
    return film;
}

void add_pass(FileFilm& film, unsigned pass) {
    const Samples samples = random_samples(film, std::size_t{film.width()} * film.height() * 2,
                                           pass, [](float u) { return Rgb(u, 1 + u, 2 * u); });
    film.add_pass({samples.positions, samples.radiance, 1, 1, samples.radiance, 1.0 + pass});
    film.end_pass();
}

TEST(FilmError, TheImageIsTheSameWithAndWithout) {
    const auto with = small_film(true), without = small_film(false);
    for (unsigned pass = 0; pass < 7; ++pass) {
        add_pass(*with, pass);
        add_pass(*without, pass);
    }
    EXPECT_EQ(with->image(), without->image());
    EXPECT_TRUE(with->error());
    EXPECT_FALSE(without->error());
}

TEST(FilmError, ARestoredFilmHasTheSameFigures) {
    const auto whole = small_film(true);
    for (unsigned pass = 0; pass < 20; ++pass)
        add_pass(*whole, pass);
    // 13 passes: within a batch.
    const auto first = small_film(true), second = small_film(true);
    for (unsigned pass = 0; pass < 13; ++pass)
        add_pass(*first, pass);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    second->state(archive);
    for (unsigned pass = 13; pass < 20; ++pass)
        add_pass(*second, pass);
    EXPECT_EQ(second->error()->relmse, whole->error()->relmse);
    EXPECT_EQ(second->error()->rmse_high, whole->error()->rmse_high);
    EXPECT_EQ(second->error()->passes, 20u);
}

TEST(FilmError, AFilmOfOnePixelIsAsWrongAsThatPixel) {
    const auto film = small_film(true, 1, 1);
    for (unsigned pass = 0; pass < 4; ++pass)
        add_pass(*film, pass);
    EXPECT_GT(film->error()->relmse, 0);
    EXPECT_EQ(film->error()->relmse, film->error()->relmse_whole);
}

TEST(FilmError, StateOfAnotherKindOfFilmIsRefused) {
    for (const bool watched : {false, true}) {
        const auto film = small_film(watched);
        for (unsigned pass = 0; pass < 4; ++pass)
            add_pass(*film, pass);
        MemoryArchive archive;
        film->state(archive);
        archive.restore();
        EXPECT_THROW(small_film(!watched)->state(archive), StateError);
    }
}

TEST(FilmError, ForgedVariancesAreRefused) {
    const FilmAccumulator film(3, 2, 1, box());
    PixelVariance variance(6);
    variance.end_pass(film, {1, 0});
    MemoryArchive archive;
    variance.state(archive);
    const std::vector<std::byte> sound = archive.content();
    constexpr float kNegative = -1;
    // The last float of the colours that are squares, before the flag of the second part.
    std::memcpy(archive.content().data() + sound.size() - 1 - sizeof(float), &kNegative,
                sizeof(float));
    archive.restore();
    EXPECT_THROW(PixelVariance(6).state(archive), StateError);
    archive.content() = sound;
    archive.restore();
    EXPECT_THROW(PixelVariance(8).state(archive), StateError);
    archive.restore();
    PixelVariance(6).state(archive);
}

}  // namespace
}  // namespace lxs::test::film_error_test
