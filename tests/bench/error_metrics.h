// Error of an image against two independent references, whose own noise cancels.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstddef>

namespace bench {

/// An image of linear radiance: R, G, B in 32-bit floats.
using Image = OIIO::ImageBuf;

/// Share of the pixels that are reported apart: the worst 0.1 %.
inline constexpr double kWorstShare = 0.001;

/// The pixels whose (I-R1)(I-R2) / (R1 R2 + epsilon) is of the largest magnitude.
struct WorstPixels {
    std::size_t pixels = 0;  ///< kWorstShare of all, at least one
    double relmse = 0;       ///< mean over these pixels alone
    double share = 0;        ///< of the sum over all pixels; 0 if that sum is not positive
};

/// Averages are over all pixels and channels, nothing trimmed.
struct ImageError {
    double mse = 0;          ///< mean of (I-R1)(I-R2), radiance^2; noise may make it negative
    double rmse = 0;         ///< root of mse, 0 where that is negative
    double relmse = 0;       ///< mean of (I-R1)(I-R2) / (R1 R2 + epsilon)
    double relmse_rest = 0;  ///< of all pixels but the worst; 0 if there are no others
    double epsilon = 0;      ///< radiance^2
    WorstPixels worst;
};

/// All three images must have the same size. Throws std::invalid_argument otherwise.
ImageError measure_error(const Image& image, const Image& first, const Image& second);

/// (a-first)(a-second), pixel by pixel.
Image error_product(const Image& a, const Image& first, const Image& second);

/// (0.01 x mean luminance of the references)^2; the smallest normal float where they are black.
double relative_epsilon(const Image& first, const Image& second);

/// `squares` / (first second + epsilon), pixel by pixel.
Image relative_to(const Image& squares, const Image& first, const Image& second, double epsilon);

/// Mean over pixels and channels.
double mean_value(const Image& image);

/// Mean over pixels of Rec. 709 luminance.
double mean_luminance(const Image& image);

}  // namespace bench
