// Protects the film's splats: sums over density, normalised by the filter's integral over the film,
// kept apart from the means of samples.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "film_samples.h"
#include "filter_integral.h"
#include "lxs/imaging/imaging.h"
#include "run_on_threads.h"
#include "scene_options.h"

namespace lxs::test::splat_test {
namespace {

/// Splats per pixel and axis that divide the tables of filters with radius 2 and 4.
constexpr int kExact = 32;
constexpr const char* kFilters[] = {"blackmanharris", "box",  "catmullrom", "gaussian",
                                    "mitchell",       "sinc", "triangle"};

std::unique_ptr<FileFilm> make(const SceneContents& contents) {
    RecordedDiagnostics diagnostics;
    return make_film(contents, diagnostics);
}

std::unique_ptr<FileFilm> film_with(const char* filter, int width, int height) {
    SceneContents contents = scene_of_size(width, height);
    set_option(contents, "PixelFilter", filter, {});
    return make(contents);
}

struct Splats {
    std::vector<Vec2> positions;
    std::vector<Rgb> radiance;

    PassSplats pass(double samples, std::uint32_t groups = 1) const {
        return {positions, radiance, groups, samples};
    }
};

/// `fine` x `fine` splats in every pixel, on a regular grid.
Splats even_splats(const Film& film, int fine, const Rgb& radiance) {
    Splats splats;
    const int columns = static_cast<int>(film.width()) * fine;
    const int rows = static_cast<int>(film.height()) * fine;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            splats.positions.emplace_back(
                (static_cast<float>(x) + 0.5f) / static_cast<float>(fine),
                (static_cast<float>(y) + 0.5f) / static_cast<float>(fine));
        }
    }
    splats.radiance.assign(splats.positions.size(), radiance);
    return splats;
}

Splats random_splats(const Film& film, std::size_t count, unsigned seed) {
    Samples samples = random_samples(film, count, seed, [](float unit) { return Rgb(unit); });
    return {std::move(samples.positions), std::move(samples.radiance)};
}

double sum_of(const std::vector<Rgb>& image) {
    double sum = 0;
    for (const Rgb& pixel : image)
        sum += pixel.y;
    return sum;
}

// A sum of table cells, cell by cell, against the summed-area table.
TEST(FilterIntegral, EqualsTheSumOverTheTable) {
    const PixelFilter filter(2, 1.6, [](double x, double y) { return 3 - x - x * y / 2; });
    const FilterIntegral integral(filter);
    const auto brute = [&](double left, double right, double up, double down) {
        constexpr int kSteps = 1280;  // divides each cell of the table
        double sum = 0;
        const double dx = 4.0 / kSteps, dy = 3.2 / kSteps;
        for (int j = 0; j < kSteps; ++j) {
            for (int i = 0; i < kSteps; ++i) {
                const double x = -2 + (i + 0.5) * dx, y = -1.6 + (j + 0.5) * dy;
                if (x < -left || x > right || y < -up || y > down) continue;
                sum += dx * dy * filter.weight(static_cast<float>(x), static_cast<float>(y));
            }
        }
        return sum;
    };
    const double bounds[][4] = {{9, 9, 9, 9}, {0.5, 9, 9, 9}, {0.5, 1.5, 0.75, 9}, {0, 2, 1.6, 0}};
    for (const auto& [left, right, up, down] : bounds) {
        const double expected = brute(left, right, up, down);
        EXPECT_NEAR(integral.over(left, right, up, down), expected, 1e-3 * expected);
    }
}

// Without the filter's integral over the film, corner pixels would show a quarter of the constant.
// The grid meets each step of the filters' tables evenly and so integrates them exactly.
TEST(FilmSplats, EvenDensityGivesAConstantUpToTheBorders) {
    for (const char* filter : kFilters) {
        const auto film = film_with(filter, 13, 9);
        const Splats splats = even_splats(*film, kExact, Rgb(0.25f, 3.0f, 1e4f));
        film->add_splats(splats.pass(static_cast<double>(splats.positions.size())));
        for (const Rgb& pixel : film->image()) {
            EXPECT_NEAR(pixel.x, 0.25, 1e-5) << filter;
            EXPECT_NEAR(pixel.y, 3.0, 1e-4) << filter;
            EXPECT_NEAR(pixel.z, 1e4, 0.5) << filter;
        }
        EXPECT_EQ(film->refused_samples(), 0u);
    }
}

// Sum of the image = pixels * mean of the splats, under every filter; borders lose nothing. 40 000
// splats of mean 1/2 with a fixed seed: the relative standard error, the filter's share in it
// included, is below 0.4 %, so that 2 % is five of them.
TEST(FilmSplats, EnergyIsKept) {
    for (const char* filter : kFilters) {
        const auto film = film_with(filter, 12, 8);
        const Splats splats = random_splats(*film, 40000, 5);
        film->add_splats(splats.pass(40000));
        EXPECT_NEAR(sum_of(film->image()) / (12 * 8 * 0.5), 1, 0.02) << filter;
    }
}

TEST(FilmSplats, BrightnessIsDensityTimesRadianceOverSamples) {
    const auto film = make(scene_of_size(4, 3));
    const Splats splats{{Vec2(1.2f, 2.5f), Vec2(1.7f, 2.1f)}, {Rgb(2.0f), Rgb(4.0f)}};
    film->add_splats(splats.pass(24));  // 2 of 24 samples: the rest black
    const std::vector<Rgb> image = film->image();
    for (std::size_t i = 0; i < image.size(); ++i)
        EXPECT_FLOAT_EQ(image[i].x, i == 2 * 4 + 1 ? 6.0f * 12 / 24 : 0.0f) << i;
    film->add_splats({{}, {}, 1, 24});  // as many samples again, all black
    EXPECT_FLOAT_EQ(film->image()[9].x, 1.5f);
}

TEST(FilmSplats, AreAddedToTheMeanOfSamples) {
    const auto film = film_with("triangle", 6, 5);
    const Splats even = even_splats(*film, kExact, Rgb(2.0f));
    for (int pass = 0; pass < 3; ++pass) {
        film->add_pass({even.positions, even.radiance, 1, 5.0});
        film->add_splats(even.pass(static_cast<double>(even.positions.size())));
    }
    for (const Rgb& pixel : film->image())
        EXPECT_NEAR(pixel.x, 4, 1e-4);
    film->clear();
    EXPECT_EQ(sum_of(film->image()), 0);
    film->add_splats(even.pass(static_cast<double>(even.positions.size())));
    EXPECT_NEAR(film->image().front().x, 2, 1e-4) << "cleared splats must not come back";
}

TEST(FilmSplats, LightGroupsStayApart) {
    SceneContents contents = scene_of_size(5, 4);
    contents.light_groups = {"default", "sun"};
    const auto film = make(contents);
    const TemporaryFolder folder;
    Splats splats = even_splats(*film, 1, Rgb(1.0f));
    std::vector<Rgb> both;
    for (std::size_t i = 0; i < splats.positions.size(); ++i) {
        both.emplace_back(1.0f);
        both.emplace_back(0, 3, 0);
    }
    splats.radiance = both;
    film->add_splats(splats.pass(20, 2));
    for (const Rgb& pixel : film->image())
        EXPECT_EQ(pixel, Rgb(1, 4, 1));
    EXPECT_THROW(film->add_splats(splats.pass(20, 1)), std::invalid_argument);
    EXPECT_THROW(film->add_splats(splats.pass(0, 2)), std::invalid_argument);
}

TEST(FilmSplats, BadSplatsAreRefusedAndCounted) {
    const auto film = make(scene_of_size(2, 2));
    Splats splats = even_splats(*film, 1, Rgb(2.0f));
    splats.positions.insert(splats.positions.end(), 3, Vec2(0.5f, 0.5f));
    splats.radiance.emplace_back(std::nanf(""));
    splats.radiance.emplace_back(std::numeric_limits<float>::infinity());
    splats.radiance.emplace_back(-1.0f);
    film->add_splats(splats.pass(4));
    EXPECT_EQ(film->refused_samples(), 3u);
    for (const Rgb& pixel : film->image())
        EXPECT_EQ(pixel.x, 2.0f);
}

TEST(FilmSplats, SameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        concurrency::run_on(threads, [&] {
            const auto film = film_with("mitchell", 64, 48);
            for (unsigned pass = 0; pass < 4; ++pass)
                film->add_splats(random_splats(*film, 5000, pass).pass(6000));
            images.push_back(film->image());
        });
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
}

TEST(FilmSplats, MemoryDoesNotGrowWithPassesAndIsNotTakenWithoutSplats) {
    const auto film = film_with("mitchell", 32, 32);
    const std::size_t without = film->memory_bytes();
    const Splats splats = even_splats(*film, 1, Rgb(1.0f));
    film->add_splats(splats.pass(1024));
    const std::size_t with = film->memory_bytes();
    // Sums of colours; and of what is displayed, as the filter has lobes, weights and colours.
    EXPECT_EQ(with - without, std::size_t{32} * 32 * (3 * sizeof(double) + 4 * sizeof(float)));
    for (int pass = 0; pass < 50; ++pass)
        film->add_splats(splats.pass(1024));
    EXPECT_EQ(film->memory_bytes(), with);
}

/// Splats that come with each pass are tinted by its wavelengths as its samples are.
TEST(FilmSplats, WavelengthsOfPassesBecomeColours) {
    const auto film = film_with("box", 3, 2);
    const Rgb grey(0.5f);
    for (std::uint64_t pass = 0; pass < 3; ++pass) {
        const Wavelengths wavelengths = wavelengths_of_pass(5, pass);
        film->set_wavelengths(wavelengths);
        const Splats splats = even_splats(*film, 1, wavelengths.values_of(grey));
        film->add_pass({splats.positions, splats.radiance, 1, 1});
        film->add_splats(splats.pass(6));
        for (const Rgb& pixel : film->image()) {
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixel[c], 1, 1e-6) << pass;
        }
    }
}

}  // namespace
}  // namespace lxs::test::splat_test
