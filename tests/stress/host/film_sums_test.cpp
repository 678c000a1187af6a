// Protects: the film's means are true after 1e9 samples, splats and passes. Its sums are plain ones
// in double precision: of n terms of one sign they are off by n 2^-53 at most, and the image, in
// single precision, by 2^-24 more. A sum in single precision breaks that in the short form already.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "film_accumulator.h"
#include "stress_case.h"

namespace film_sums_test {
namespace {

using namespace lxs;
using namespace stress;

constexpr std::size_t kSamples = 999;  // no sum near a whole number

PixelFilter box_filter() {
    return {0.5, 0.5, [](double, double) { return 1.0; }};
}

/// Relative error of a film of one pixel, whose mean should be `expected`.
double error_of(const FilmAccumulator& film, double expected) {
    Rgb value;
    film.resolve_total({&value, 1});
    return std::abs(double(value.x) / expected - 1);
}

void record_error(std::string_view what, double terms, double error) {
    const double most = 2 * terms * 0x1p-53 + 0x1p-24;
    std::ostringstream tried, figure;
    tried << what << ", " << terms << " terms";
    figure << "relative error " << error << " of at most " << most;
    record(tried.str(), figure.str());
    EXPECT_LE(error, most);
}

TEST(StressFilm, MeansOfSamplesOverPasses) {
    const int passes = sized(20'000, 1'000'000);
    FilmAccumulator film(1, 1, 1, box_filter());
    const std::vector<Vec2> positions(kSamples, Vec2(0.5f, 0.5f));
    const std::vector<Rgb> dark(kSamples, Rgb(0.1f)), light(kSamples, Rgb(0.7f));
    double sum = 0, weights = 0;
    for (int pass = 0; pass < passes; ++pass) {
        // Weights as photon mappers give: counts of photon paths.
        const double weight = 1e6 + pass % 7;
        const auto& radiance = pass % 2 ? light : dark;
        film.add({positions, radiance, 1, weight});
        sum += weight * double(radiance[0].x);
        weights += weight;
    }
    record_error("samples of one pixel in " + std::to_string(passes) + " passes",
                 double(kSamples) * passes, error_of(film, sum / weights));
}

TEST(StressFilm, MeansOfSplats) {
    const int calls = sized(20'000, 1'000'000);
    FilmAccumulator film(1, 1, 1, box_filter());
    const std::vector<Vec2> positions(kSamples, Vec2(0.5f, 0.5f));
    const std::vector<Rgb> radiance(kSamples, Rgb(0.3f));
    for (int call = 0; call < calls; ++call)
        film.add_splats({positions, radiance, 1, double(kSamples)});
    record_error("splats of one pixel in " + std::to_string(calls) + " calls",
                 double(kSamples) * calls, error_of(film, double(0.3f)));
}

}  // namespace
}  // namespace film_sums_test
