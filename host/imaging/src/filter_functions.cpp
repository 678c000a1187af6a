// Pixel filters as functions of the distance from the pixel's centre.
#include "filter_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lxs {

double mitchell_1d(double x, double b, double c) {
    // Mitchell & Netravali 1988, equation 8.
    const double d = std::abs(x);
    if (d >= 2) return 0;
    if (d >= 1) {
        return ((-b - 6 * c) * d * d * d + (6 * b + 30 * c) * d * d + (-12 * b - 48 * c) * d +
                (8 * b + 24 * c)) /
               6;
    }
    return ((12 - 9 * b - 6 * c) * d * d * d + (-18 + 12 * b + 6 * c) * d * d + (6 - 2 * b)) / 6;
}

double supersampled_mitchell_1d(double x, double b, double c) {
    constexpr double kShift = 4.0 / 3;
    const double middle = (76 - 16 * b + 8 * c) / 81;
    const double side = (1 - middle) / 2;
    return side * mitchell_1d(x - kShift, b, c) + middle * mitchell_1d(x, b, c) +
           side * mitchell_1d(x + kShift, b, c);
}

double gaussian_1d(double x, double radius, double alpha) {
    return std::max(0.0, std::exp(-alpha * x * x) - std::exp(-alpha * radius * radius));
}

double triangle_1d(double x, double radius) {
    return std::max(0.0, radius - std::abs(x));
}

double blackman_harris_1d(double x, double radius) {
    if (std::abs(x) >= radius) return 0;
    // Harris 1978, table 1, minimum 4-sample Blackman-Harris.
    constexpr double kA0 = 0.35875, kA1 = 0.48829, kA2 = 0.14128, kA3 = 0.01168;
    const double t = std::numbers::pi * (x / radius);
    return kA0 + kA1 * std::cos(t) + kA2 * std::cos(2 * t) + kA3 * std::cos(3 * t);
}

double lanczos_sinc_1d(double x, double radius, double tau) {
    const double t = std::numbers::pi * std::abs(x / radius);
    if (t >= std::numbers::pi) return 0;
    if (t < 1e-6) return 1;
    return std::sin(t * tau) / (t * tau) * (std::sin(t) / t);
}

}  // namespace lxs
