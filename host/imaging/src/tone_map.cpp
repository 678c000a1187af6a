// From linear radiance to 8-bit display values.
#include "tone_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lxs {
namespace {

using Kernel = ToneMapSettings::Kernel;
using Clamp = ToneMapSettings::Clamp;

/// Linear value that a display of this gamma shows at code 118 of 255, LuxRender's middle grey.
double middle_grey(double gamma) {
    return std::pow(118.0 / 255.0, gamma);
}

/// Statistics of the pixels that are not black, so that empty borders don't brighten the rest.
struct ImageStatistics {
    double mean = 0;                 ///< arithmetic mean of luminance
    double log_mean = 0;             ///< geometric mean of luminance
    double log_mean_of_visible = 0;  ///< the same, what is below 1e-6 taken for that
    double maximum = 0;              ///< of luminance

    ImageStatistics(std::span<const Rgb> image, const Imath::V3d& weights) {
        constexpr double kLeastVisible = 1e-6;
        double sum = 0, log_sum = 0, log_sum_of_visible = 0;
        std::size_t count = 0;
        for (const Rgb& c : image) {
            const double y = weights.dot(Imath::V3d(c));
            if (!(y > 0)) continue;
            maximum = std::max(maximum, y);
            sum += y;
            log_sum += std::log(y);
            log_sum_of_visible += std::log(std::max(y, kLeastVisible));
            ++count;
        }
        if (count == 0) return;
        mean = sum / static_cast<double>(count);
        log_mean = std::exp(log_sum / static_cast<double>(count));
        log_mean_of_visible = std::exp(log_sum_of_visible / static_cast<double>(count));
    }
};

/// A tone curve: output = input * scale * (1 + y / white^2) / (1 + y) for y = luminance * key, or
/// plainly input * scale when `key` is 0.
struct ToneCurve {
    double scale = 1;
    double key = 0;
    double inverse_white_squared = 0;

    double factor(double y) const {
        const double l = y * key;
        return scale * (1 + l * inverse_white_squared) / (1 + l);
    }
};

double linear_scale(const ToneMapSettings& s) {
    // LuxRender's exposure rule: the energy time * speed / f-number^2 against middle grey.
    return s.linear_exposure / (s.linear_fstop * s.linear_fstop) * s.linear_sensitivity * 0.065 *
           middle_grey(s.linear_gamma);
}

double contrast_scale(double display_adaptation, double world_adaptation) {
    // Ward 1994: equal visibility of contrasts on a display of 100 cd m^-2.
    constexpr double kDisplayMaximum = 100;
    const double quotient =
        (1.219 + std::pow(display_adaptation, 0.4)) / (1.219 + std::pow(world_adaptation, 0.4));
    return std::pow(quotient, 2.5) / kDisplayMaximum;
}

ToneCurve reinhard_curve(const ToneMapSettings& s, double log_mean) {
    // Reinhard et al. 2002, equations 1, 2 and 4, with the lower of their key values. LuxRender
    // divides by "prescale".
    constexpr double kKey = 0.1;
    const double scale = kKey / log_mean;
    ToneCurve curve{.scale = scale * s.reinhard_postscale, .key = scale / s.reinhard_prescale};
    curve.inverse_white_squared = 1 / (s.reinhard_burn * s.reinhard_burn);
    return curve;
}

ToneCurve make_curve(std::span<const Rgb> image, const ToneMapSettings& s) {
    const ImageStatistics statistics(image, s.luminance_weights);
    if (!(statistics.mean > 0)) return {};
    switch (s.kernel) {
        case Kernel::AutoLinear:
            return {.scale = 1.25 / statistics.mean * middle_grey(s.gamma)};
        case Kernel::Linear:
            return {.scale = linear_scale(s)};
        case Kernel::Reinhard:
            return reinhard_curve(s, statistics.log_mean_of_visible);
        case Kernel::Contrast:
            return {.scale = contrast_scale(s.contrast_ywa, statistics.log_mean)};
        case Kernel::MaxWhite:
            return {.scale = 1 / statistics.maximum};
        case Kernel::NonLinear: {
            // Reinhard's curve on the unscaled luminance, its mean becoming white.
            const double white = statistics.log_mean;
            return {.scale = 1, .key = 1, .inverse_white_squared = 1 / (white * white)};
        }
    }
    return {};
}

using Colour = std::array<double, 3>;

/// `c`, brighter than 1 in some channel, so far towards grey that the brightest is 1.
Colour towards_grey(const Colour& c, double brightest, double grey) {
    const double t = brightest > grey ? (1 - grey) / (brightest - grey) : 0;
    return {grey + t * (c[0] - grey), grey + t * (c[1] - grey), grey + t * (c[2] - grey)};
}

/// As LuxRender's ColorSystem::Limit.
Colour clamp_to_display(const Colour& c, const ToneMapSettings& s) {
    const double brightest = std::max({c[0], c[1], c[2]});
    Colour fit = c;
    if (brightest > 1 && s.clamp == Clamp::Darken) {
        for (double& channel : fit)
            channel /= brightest;
    } else if (brightest > 1 && s.clamp == Clamp::Hue) {
        fit = towards_grey(c, brightest, 1.0 / 3);
    } else if (brightest > 1 && s.clamp == Clamp::Luminance) {
        const double y = s.luminance_weights.dot(Imath::V3d(c[0], c[1], c[2]));
        fit = towards_grey(c, brightest, std::min(y, 1.0));
    }
    for (double& channel : fit)
        channel = std::clamp(channel, 0.0, 1.0);
    return fit;
}

std::uint8_t encode(double value, double inverse_gamma) {
    return static_cast<std::uint8_t>(std::floor(255 * std::pow(value, inverse_gamma) + 0.5));
}

}  // namespace

std::string_view name(Kernel kernel) {
    switch (kernel) {
        case Kernel::AutoLinear:
            return "autolinear";
        case Kernel::Linear:
            return "linear";
        case Kernel::Reinhard:
            return "reinhard";
        case Kernel::Contrast:
            return "contrast";
        case Kernel::MaxWhite:
            return "maxwhite";
        case Kernel::NonLinear:
            return "nonlinear";
    }
    return {};
}

std::vector<std::uint8_t> tone_map(std::span<const Rgb> image, const ToneMapSettings& settings) {
    const ToneCurve curve = make_curve(image, settings);
    const double exposure = std::exp2(settings.exposure_stops);
    const double inverse_gamma = 1 / settings.gamma;
    std::vector<std::uint8_t> bytes(3 * image.size());
    const auto convert = [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const Rgb& in = image[i];
            const double f =
                exposure * curve.factor(settings.luminance_weights.dot(Imath::V3d(in)));
            Colour mapped{f * in.x, f * in.y, f * in.z};
            if (settings.response) mapped = settings.response->map(mapped);
            const Colour c = clamp_to_display(mapped, settings);
            for (std::size_t channel = 0; channel < c.size(); ++channel)
                bytes[3 * i + channel] = encode(c[channel], inverse_gamma);
        }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, image.size(), 4096), convert);
    return bytes;
}

}  // namespace lxs
