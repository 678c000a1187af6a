// One figure for a whole image: its estimated error.
#include "lxs/imaging/error_figures.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lxs {
namespace {

/// Share of mean luminance below which a pixel counts as black. docs/measured/method.md.
constexpr double kBlack = 0.01;
/// Share of the pixels that relMSE leaves out, the worst. docs/measured/method.md.
constexpr double kWorst = 0.001;
/// Standard deviations on either side of a 95 % interval.
constexpr double kInterval = 1.96;

/// What the estimate itself may be wrong by, beyond chance. Unit: standard deviation of the log of
/// relMSE. Balances: intervals that hold the true error against intervals that say nothing. Chosen
/// by: the table of ratios to true errors. Supported by:
/// docs/notebook/2026-11-26-error-estimate.md.
constexpr double kModelError = 0.2;
/// Pixels that err together: those that one sample reaches through the pixel filter, and a photon's
/// search disk. Unit: pixels. Balances: as above. Chosen by: the filter of two pixels' width and
/// radii of one or two. Supported by: the same page.
constexpr double kPixelsTogether = 12;

/// Pixels to either side whose mean stands for what is around one. Unit: pixels. Balances: pixels
/// enough that single bright paths do not matter against those of another surface. Chosen by: how
/// often the estimate is within 1.5 of the true one, 73 % with 4, 67 % with 2, 52 % with the median
/// of 2. Supported by: the same page.
constexpr std::uint32_t kReach = 4;

template <class Work>
void for_rows(std::uint32_t height, const Work& work) {
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height), [&](const auto& rows) {
        for (std::uint32_t y = rows.begin(); y != rows.end(); ++y)
            work(y);
    });
}

/// Sums of up to 2 kReach + 1 pixels in a row; in a fixed order.
std::vector<Imath::V3d> sums_along_rows(const std::vector<Rgb>& image, std::uint32_t width,
                                        std::uint32_t height) {
    std::vector<Imath::V3d> sums(image.size(), Imath::V3d(0.0));
    for_rows(height, [&](std::uint32_t y) {
        const std::size_t row = std::size_t{y} * width;
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::uint32_t last = std::min(x + kReach, width - 1);
            for (std::uint32_t i = x - std::min(x, kReach); i <= last; ++i)
                sums[row + x] += Imath::V3d(image[row + i]);
        }
    });
    return sums;
}

/// Per pixel the mean of those around it, itself left out.
std::vector<Rgb> means_around(const std::vector<Rgb>& image, std::uint32_t width,
                              std::uint32_t height) {
    const std::vector<Imath::V3d> sums = sums_along_rows(image, width, height);
    std::vector<Rgb> means(image.size(), Rgb(0.0f));
    for_rows(height, [&](std::uint32_t y) {
        const std::uint32_t top = y - std::min(y, kReach);
        const std::uint32_t rows = std::min(y + kReach, height - 1) - top + 1;
        for (std::uint32_t x = 0; x < width; ++x) {
            Imath::V3d sum(0.0);
            for (std::uint32_t row = top; row < top + rows; ++row)
                sum += sums[std::size_t{row} * width + x];
            const std::uint32_t left = x - std::min(x, kReach);
            const std::uint32_t columns = std::min(x + kReach, width - 1) - left + 1;
            const std::size_t i = std::size_t{y} * width + x;
            const double others = static_cast<double>(columns) * rows - 1;
            if (others > 0) means[i] = Rgb((sum - Imath::V3d(image[i])) / others);
        }
    });
    return means;
}

/// The true value as far as it can be told: drawn from `value` towards `around` by as much as noise
/// explains of their difference (James and Stein's estimator, cut at zero, for twice the variance:
/// that of a pixel that one bright path has met is known to no better than that).
double believed(double value, double variance, double around) {
    const double difference = value - around;
    const double square = difference * difference;
    return square > 2 * variance ? around + difference * (1 - 2 * variance / square) : around;
}

struct PixelError {
    float relative = 0, squared = 0;  ///< of relMSE and MSE
};

std::vector<PixelError> pixel_errors(const UncertainImage& image, double epsilon) {
    const std::vector<Rgb> around = means_around(image.value, image.width, image.height);
    std::vector<PixelError> errors(image.value.size());
    for_rows(image.height, [&](std::uint32_t y) {
        for (std::size_t i = std::size_t{y} * image.width; i < std::size_t{y + 1} * image.width;
             ++i) {
            double relative = 0, squared = 0;
            for (int c = 0; c < 3; ++c) {
                const double variance = image.variance[i][c];
                const double truth = believed(image.value[i][c], variance, around[i][c]);
                relative += variance / (truth * truth + epsilon) / 3;
                squared += variance / 3;
            }
            errors[i] = {static_cast<float>(relative), static_cast<float>(squared)};
        }
    });
    return errors;
}

struct Sums {
    double sum = 0, squares = 0;
    void add(double value) {
        sum += value;
        squares += value * value;
    }
    /// Factor of the interval's ends: chance, as far as squares tell it of pixels that err each by
    /// itself, or some together, and what no chance explains.
    double factor(double degrees_of_freedom) const {
        if (!(sum > 0)) return 1;
        // Of each pixel's squared error, and of its estimate, both about a chi square.
        const double of_one = 2 * (1 + degrees_of_freedom) / (2 + degrees_of_freedom);
        const double chance = kPixelsTogether * of_one * squares / (sum * sum);
        return std::exp(kInterval * std::sqrt(kModelError * kModelError + std::min(chance, 4.0)));
    }
};

/// Of the relative errors but for the `worst` greatest; in the pixels' order, whatever order
/// nth_element leaves.
Sums without_worst(const std::vector<PixelError>& errors, std::size_t worst) {
    std::vector<float> relative(errors.size());
    std::transform(errors.begin(), errors.end(), relative.begin(),
                   [](const PixelError& error) { return error.relative; });
    const std::size_t kept = errors.size() - worst;
    const auto end = relative.begin() + static_cast<std::ptrdiff_t>(kept);
    std::nth_element(relative.begin(), end, relative.end());
    const float limit = worst > 0 ? *end : std::numeric_limits<float>::infinity();
    Sums rest;
    std::size_t below = 0;
    for (const PixelError& error : errors) {
        if (!(error.relative < limit)) continue;
        rest.add(error.relative);
        ++below;
    }
    for (std::size_t equal = below; equal < kept; ++equal)
        rest.add(limit);
    return rest;
}

}  // namespace

double ErrorEstimate::relative() const {
    return std::sqrt(relmse);
}

ErrorEstimate estimate_error(const UncertainImage& image) {
    double mean = 0;
    for (const Rgb& value : image.value)
        mean += double{luminance(value)};
    const auto pixels = static_cast<double>(image.value.size());
    mean /= pixels;
    // An image that is all black has no error that would be relative to anything.
    const double epsilon = mean > 0 ? kBlack * kBlack * mean * mean : 1;
    const std::vector<PixelError> errors = pixel_errors(image, epsilon);
    Sums squared;
    double whole = 0;
    for (const PixelError& error : errors) {
        whole += error.relative;
        squared.add(error.squared);
    }
    // A film of a single pixel keeps it.
    const std::size_t worst =
        std::min(std::max<std::size_t>(1, static_cast<std::size_t>(kWorst * pixels)),
                 image.value.size() - 1);
    const Sums rest = without_worst(errors, worst);
    const double rest_factor = rest.factor(image.degrees_of_freedom);
    const double rmse_factor = std::sqrt(squared.factor(image.degrees_of_freedom));
    ErrorEstimate estimate;
    estimate.degrees_of_freedom = image.degrees_of_freedom;
    estimate.relmse = rest.sum / (pixels - static_cast<double>(worst));
    estimate.relmse_low = estimate.relmse / rest_factor;
    estimate.relmse_high = estimate.relmse * rest_factor;
    estimate.relmse_whole = whole / pixels;
    estimate.rmse = std::sqrt(squared.sum / pixels);
    estimate.rmse_low = estimate.rmse / rmse_factor;
    estimate.rmse_high = estimate.rmse * rmse_factor;
    return estimate;
}

}  // namespace lxs
