// One figure for a whole image: its estimated error.
#include "lxs/imaging/error_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "for_rows.h"
#include "means_around.h"

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
/// by: the table of ratios to true errors.
constexpr double kModelError = 0.2;
/// Pixels that err together: those that one sample reaches through the pixel filter, and a photon's
/// search disk. Unit: pixels. Balances: as above. Chosen by: the filter of two pixels' width and
/// radii of one or two. Supported by: the same page.
constexpr double kPixelsTogether = 12;

/// The true value as far as it can be told: drawn from `value` towards `around` by as much as noise
/// explains of their difference (James and Stein's estimator, cut at zero, for twice the variance:
/// that of a pixel that one bright path has met is known to no better than that).
double believed(double value, double variance, double around) {
    const double difference = value - around;
    const double square = difference * difference;
    return square > 2 * variance ? around + difference * (1 - 2 * variance / square) : around;
}

/// What one pixel adds to relMSE, and to MSE.
struct PixelError {
    float relative = 0, squared = 0;
};

/// What pixels of an image add.
struct PixelErrors {
    std::vector<PixelError> noise;
    std::vector<PixelError> bias;  ///< by chance below zero; empty if it isn't known
};

PixelErrors pixel_errors(const UncertainImage& image, double epsilon) {
    const std::vector<Rgb> around = means_around(image.value, image.width, image.height);
    const bool biased = !image.squared_bias.empty();
    PixelErrors errors;
    errors.noise.resize(image.value.size());
    if (biased) errors.bias.resize(image.value.size());
    for_rows(image.height, [&](std::uint32_t y) {
        for (std::size_t i = std::size_t{y} * image.width; i < std::size_t{y + 1} * image.width;
             ++i) {
            double relative = 0, squared = 0, relative_bias = 0, squared_bias = 0;
            for (int c = 0; c < 3; ++c) {
                const double variance = image.variance[i][c];
                const double truth = believed(image.value[i][c], variance, around[i][c]);
                const double share = 1 / (3 * (truth * truth + epsilon));
                relative += share * variance;
                squared += variance / 3;
                if (!biased) continue;
                relative_bias += share * image.squared_bias[i][c];
                squared_bias += image.squared_bias[i][c] / 3.0;
            }
            errors.noise[i] = {static_cast<float>(relative), static_cast<float>(squared)};
            if (biased)
                errors.bias[i] = {static_cast<float>(relative_bias),
                                  static_cast<float>(squared_bias)};
        }
    });
    return errors;
}

using Figure = float PixelError::*;

/// Numbers of the pixels but for the `worst` whose size is greatest, in the pixels' order.
template <class Size>
std::vector<std::size_t> all_but(std::size_t worst, std::size_t pixels, const Size& size) {
    std::vector<float> sizes(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        sizes[i] = size(i);
    const std::size_t kept = pixels - worst;
    const auto end = sizes.begin() + static_cast<std::ptrdiff_t>(kept);
    std::nth_element(sizes.begin(), end, sizes.end());
    const float limit = worst > 0 ? *end : std::numeric_limits<float>::infinity();
    std::size_t equal = kept;  // that are kept of those at the limit, the first ones
    for (std::size_t i = 0; i < pixels; ++i)
        equal -= size(i) < limit ? 1 : 0;
    std::vector<std::size_t> numbers;
    numbers.reserve(kept);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (size(i) > limit || (size(i) == limit && equal == 0)) continue;
        equal -= size(i) == limit ? 1 : 0;
        numbers.push_back(i);
    }
    return numbers;
}

/// A mean over pixels, and the variance of what is told of it, as far as squares tell it of pixels
/// that err each by itself, or some together.
struct Told {
    double mean = 0, variance = 0;
};

/// Without the pixels that are farthest from zero. `of_one`: variance of what one pixel tells, as
/// share of its square.
Told told_by(const std::vector<PixelError>& errors, Figure figure, std::size_t worst,
             double of_one) {
    if (errors.empty()) return {};
    double sum = 0, squares = 0;
    for (const std::size_t i : all_but(
             worst, errors.size(), [&](std::size_t j) { return std::abs(errors[j].*figure); })) {
        const double error = errors[i].*figure;
        sum += error;
        squares += error * error;
    }
    const auto kept = static_cast<double>(errors.size() - worst);
    return {sum / kept, kPixelsTogether * of_one * squares / (kept * kept)};
}

/// A squared error, and the factor either way within which the true one lies.
struct Figures {
    double error = 0, of_bias = 0, factor = 1;
};

Figures figures_of(const PixelErrors& errors, Figure figure, std::size_t worst,
                   const UncertainImage& image, double known_bias) {
    // Of each pixel's squared error, and of its estimate, both about a chi square.
    const double freedom = image.degrees_of_freedom;
    const Told noise = told_by(errors.noise, figure, worst, 2 * (1 + freedom) / (2 + freedom));
    Told bias = told_by(errors.bias, figure, worst, 1);
    // As far as it is no chance: James and Stein's estimator, as for pixels.
    if (bias.mean > 0) bias.mean *= std::max(1 - bias.variance / (bias.mean * bias.mean), 0.0);
    if (errors.bias.empty()) bias.mean = known_bias;
    Figures figures;
    figures.of_bias = std::max(bias.mean, 0.0);
    figures.error = noise.mean + figures.of_bias;
    if (!(figures.error > 0)) return figures;
    const double chance = (noise.variance + bias.variance) / (figures.error * figures.error);
    figures.factor =
        std::exp(kInterval * std::sqrt(kModelError * kModelError + std::min(chance, 4.0)));
    return figures;
}

double mean_of(const std::vector<PixelError>& errors, Figure figure) {
    double sum = 0;
    for (const PixelError& error : errors)
        sum += double{error.*figure};
    return sum / static_cast<double>(errors.size());
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
    const PixelErrors errors = pixel_errors(image, epsilon);
    // A film of a single pixel keeps it.
    const std::size_t worst =
        std::min(std::max<std::size_t>(1, static_cast<std::size_t>(kWorst * pixels)),
                 image.value.size() - 1);
    const Figures relative =
        figures_of(errors, &PixelError::relative, worst, image, image.relmse_of_bias);
    const Figures squared =
        figures_of(errors, &PixelError::squared, worst, image, image.mse_of_bias);
    ErrorEstimate estimate;
    estimate.degrees_of_freedom = image.degrees_of_freedom;
    estimate.relmse = relative.error;
    estimate.relmse_of_bias = relative.of_bias;
    estimate.relmse_low = relative.error / relative.factor;
    estimate.relmse_high = relative.error * relative.factor;
    estimate.relmse_whole = mean_of(errors.noise, &PixelError::relative) + relative.of_bias;
    const double factor = std::sqrt(squared.factor);
    estimate.rmse = std::sqrt(squared.error);
    estimate.rmse_of_bias = std::sqrt(squared.of_bias);
    estimate.rmse_low = estimate.rmse / factor;
    estimate.rmse_high = estimate.rmse * factor;
    estimate.rmse_whole = std::sqrt(mean_of(errors.noise, &PixelError::squared) + squared.of_bias);
    return estimate;
}

}  // namespace lxs
