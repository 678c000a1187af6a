// Protects the error figures: closed forms on synthetic images, and that the references' own noise
// does not count.
#include "error_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "synthetic_image.h"

namespace bench::test::error_metrics_test {
namespace {

TEST(ErrorMetrics, ConstantOffsetHasTheClosedForm) {
    const Image truth = synthetic_image(20, 10, [](int, int) { return 2; });
    const Image image = synthetic_image(20, 10, [](int, int) { return 2.5; });
    const ImageError error = measure_error(image, truth, truth);
    EXPECT_NEAR(error.mse, 0.25, 1e-6);
    EXPECT_NEAR(error.rmse, 0.5, 1e-6);
    EXPECT_NEAR(error.epsilon, 4e-4, 1e-9);  // (0.01 x 2)^2
    EXPECT_NEAR(error.relmse, 0.25 / (4 + 4e-4), 1e-6);
    EXPECT_NEAR(error.relmse_rest, error.relmse, 1e-6);
    EXPECT_EQ(error.worst.pixels, 1u);
    EXPECT_NEAR(error.worst.share, 1.0 / 200, 1e-6);
}

TEST(ErrorMetrics, RelativeErrorDividesEachPixelByItsOwnReferences) {
    const auto value = [](int x, int) { return x < 5 ? 1.0 : 10.0; };
    const Image truth = synthetic_image(10, 10, value);
    const Image image = synthetic_image(10, 10, [&](int x, int y) { return 1.1 * value(x, y); });
    const ImageError error = measure_error(image, truth, truth);
    const double epsilon = std::pow(0.01 * 5.5, 2);
    EXPECT_NEAR(error.relmse, (0.01 / (1 + epsilon) + 1 / (100 + epsilon)) / 2, 1e-6);
    EXPECT_NEAR(error.mse, (0.01 + 1) / 2, 1e-5);
}

TEST(ErrorMetrics, WorstThousandthIsReportedApartAndNothingIsTrimmed) {
    const Image truth = synthetic_image(100, 40, [](int, int) { return 1; });
    // 4 of 4000 pixels are off by 10, the others by 0.1.
    const Image image =
        synthetic_image(100, 40, [](int x, int y) { return y == 7 && x < 4 ? 11.0 : 1.1; });
    const ImageError error = measure_error(image, truth, truth);
    EXPECT_EQ(error.worst.pixels, 4u);
    EXPECT_NEAR(error.worst.relmse, 100 / 1.0001, 1e-3);
    EXPECT_NEAR(error.relmse, (4 * 100 + 3996 * 0.01) / 4000 / 1.0001, 1e-5);
    EXPECT_NEAR(error.worst.share, 400 / (400 + 39.96), 1e-5);
    EXPECT_NEAR(error.relmse_rest, 0.01 / 1.0001, 1e-5);
}

TEST(ErrorMetrics, NoiseOfTheReferencesCancels) {
    // Offset 0.1 against references with noise of deviation 0.3, in 20 trials. The error must be
    // that of the image alone: a z-test of the mean mse, two-sided, significance 1e-4 (z = 3.89).
    constexpr int kTrials = 20;
    constexpr double kOffset = 0.1, kDeviation = 0.3;
    std::mt19937 random(7);
    std::vector<double> errors;
    double naive = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        const Image image = synthetic_image(64, 64, [](int, int) { return 5 + kOffset; });
        const Image first = noisy_image(64, 64, 5, kDeviation, random);
        const Image second = noisy_image(64, 64, 5, kDeviation, random);
        errors.push_back(measure_error(image, first, second).mse);
        naive += measure_error(image, first, first).mse / kTrials;
    }
    double mean = 0, squares = 0;
    for (const double error : errors)
        mean += error / kTrials;
    for (const double error : errors)
        squares += (error - mean) * (error - mean);
    const double deviation_of_mean = std::sqrt(squares / (kTrials - 1) / kTrials);
    EXPECT_LT(std::abs(mean - kOffset * kOffset), 3.89 * deviation_of_mean);
    EXPECT_LT(deviation_of_mean, 0.05 * kOffset * kOffset);  // the test has power
    // With one reference twice, its variance would count.
    EXPECT_NEAR(naive, kOffset * kOffset + kDeviation * kDeviation, 0.005);
}

TEST(ErrorMetrics, BlackReferencesAndNegativeEstimatesStayFinite) {
    const Image black = synthetic_image(4, 4, [](int, int) { return 0; });
    const Image low = synthetic_image(4, 4, [](int, int) { return 0.5; });
    const Image high = synthetic_image(4, 4, [](int, int) { return 1.5; });
    EXPECT_TRUE(std::isfinite(measure_error(black, black, black).relmse));
    const Image between = synthetic_image(4, 4, [](int, int) { return 1; });
    const ImageError error = measure_error(between, low, high);
    EXPECT_NEAR(error.mse, -0.25, 1e-6);
    EXPECT_EQ(error.rmse, 0);
    EXPECT_EQ(error.worst.share, 0);
}

TEST(ErrorMetrics, ImagesOfOtherSizesAreRefused) {
    const Image small = synthetic_image(4, 4, [](int, int) { return 1; });
    const Image large = synthetic_image(5, 4, [](int, int) { return 1; });
    EXPECT_THROW(measure_error(small, large, large), std::invalid_argument);
    EXPECT_THROW(measure_error(small, small, large), std::invalid_argument);
}

}  // namespace
}  // namespace bench::test::error_metrics_test
