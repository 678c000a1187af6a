// Protects the layer of bias: the mean of what passes say of it, signed; its square in the film's
// error, less the noise of the estimate; the same after a pause; nothing of it where no photon was.
#include <gtest/gtest.h>

#include <random>

#include "film_bias.h"
#include "film_samples.h"
#include "memory_archive.h"

namespace lxs::test::film_bias_test {
namespace {

constexpr int kSide = 64;
constexpr std::size_t kPixels = std::size_t{kSide} * kSide;

std::unique_ptr<FileFilm> film_with_bias() {
    SceneContents scene = scene_of_size(kSide, kSide);
    scene.options["Film"].parameters.values.push_back(
        {"string", "layers", std::vector<std::string>{"bias"}, place(2, 5), {}});
    auto film = make(scene);
    film->estimate_errors(true);
    return film;
}

/// Adds passes of an image of 10 with noise of deviation 1, `bias` among it, which discs tell with
/// noise of deviation `noise`.
void add_passes(FileFilm& film, int from, int to, float bias, float noise) {
    std::vector<Vec2> positions;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x)
            positions.emplace_back(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    }
    for (int pass = from; pass < to; ++pass) {
        std::mt19937 generator(static_cast<unsigned>(pass));
        std::normal_distribution<float> normal;
        std::vector<Rgb> image(kPixels), half(kPixels), whole(kPixels);
        for (std::size_t i = 0; i < kPixels; ++i) {
            image[i] = Rgb(10 + bias + normal(generator));
            half[i] = Rgb(100 + noise / 2 * normal(generator));
            whole[i] = Rgb(100 + bias / 2);
        }
        film.add_pass({positions, image});
        film.add_bias({positions, half, 1, 1.0 + pass % 2, whole, 1.0 + pass % 2});
        film.end_pass();
    }
}

double mean_of(const HeldLayer& layer) {
    double sum = 0;
    for (const float value : layer.values)
        sum += double{value} / static_cast<double>(layer.values.size());
    return sum;
}

TEST(FilmBias, TheLayerIsTheMeanOverPasses) {
    for (const float bias : {-3.0f, 0.0f, 2.0f}) {
        const auto film = film_with_bias();
        add_passes(*film, 0, 10, bias, 1);
        // 4 standard errors of 10 x 4096 numbers, weighted; significance 1e-4.
        EXPECT_NEAR(mean_of(film->held_layer("bias")), double{bias}, 4 * 1.1 / std::sqrt(40960.0));
    }
}

TEST(FilmBias, TheErrorHasTheSquareOfTheBiasWithoutItsNoise) {
    for (const float bias : {0.0f, 0.5f}) {
        const auto film = film_with_bias();
        add_passes(*film, 0, 16, bias, 2);
        const ErrorEstimate error = *film->error();
        const double squared = double{bias} * double{bias};
        // The noise of a pixel's bias has the square 0.25: ten times what may be left of it.
        EXPECT_NEAR(error.rmse_of_bias * error.rmse_of_bias, squared, 0.025);
        EXPECT_NEAR(error.rmse * error.rmse, squared + 1.0 / 16, 0.03);
        EXPECT_NEAR(error.relmse_of_bias, squared / (10.5 * 10.5), 0.025 / 100);
        EXPECT_GT(error.relmse, error.relmse_of_bias);
    }
}

TEST(FilmBias, IntegratorsWithoutPhotonsHaveNone) {
    const auto film = film_with_bias();
    const Samples samples = random_samples(*film, kPixels, 1, [](float u) { return Rgb(1 + u); });
    for (int pass = 0; pass < 5; ++pass) {
        film->add_pass({samples.positions, samples.radiance});
        film->end_pass();
    }
    EXPECT_EQ(mean_of(film->held_layer("bias")), 0);
    EXPECT_EQ(film->error()->relmse_of_bias, 0);
}

TEST(FilmBias, IsKeptBetweenRuns) {
    const auto whole = film_with_bias(), first = film_with_bias(), second = film_with_bias();
    add_passes(*whole, 0, 11, 1, 1);
    add_passes(*first, 0, 5, 1, 1);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    second->state(archive);
    add_passes(*second, 5, 11, 1, 1);
    EXPECT_EQ(second->held_layer("bias").values, whole->held_layer("bias").values);
    EXPECT_EQ(second->error()->relmse, whole->error()->relmse);
    EXPECT_EQ(second->error()->rmse_of_bias, whole->error()->rmse_of_bias);
}

TEST(FilmBias, MemoryIsFlat) {
    FilmBias bias(kSide, kSide);
    const std::vector<Vec2> positions(kPixels, Vec2(3.5f, 4.5f));
    const std::vector<Rgb> light(kPixels, Rgb(1.0f));
    std::size_t bytes = 0;
    for (int pass = 0; pass < 40; ++pass) {
        bias.add({positions, light, 1, 1, light, 1});
        bias.end_pass();
        if (pass == 2) bytes = bias.memory_bytes();
    }
    EXPECT_EQ(bias.memory_bytes(), bytes);
}

}  // namespace
}  // namespace lxs::test::film_bias_test
