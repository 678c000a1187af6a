// Linear RGB radiometric quantities with Rec. 709 primaries.
#pragma once

#include <algorithm>
#include <cmath>

namespace aips {

/// Radiance, power or reflectance per channel; the unit is named where it is used.
struct Rgb {
    float r = 0, g = 0, b = 0;
    bool operator==(const Rgb&) const = default;
};

inline constexpr Rgb kWhite{1, 1, 1};

inline Rgb operator+(Rgb a, Rgb b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
inline Rgb operator-(Rgb a, Rgb b) {
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
inline Rgb operator*(Rgb a, Rgb b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
inline Rgb operator*(Rgb a, float s) {
    return {a.r * s, a.g * s, a.b * s};
}
inline Rgb operator*(float s, Rgb a) {
    return a * s;
}
inline Rgb operator/(Rgb a, float s) {
    return a * (1.0f / s);
}
inline Rgb& operator+=(Rgb& a, Rgb b) {
    return a = a + b;
}
inline Rgb& operator*=(Rgb& a, Rgb b) {
    return a = a * b;
}
inline Rgb& operator*=(Rgb& a, float s) {
    return a = a * s;
}

/// Rec. 709 luminance.
inline float luminance(Rgb c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}
inline float max_component(Rgb c) {
    return std::max({c.r, c.g, c.b});
}
inline bool is_black(Rgb c) {
    return c.r == 0 && c.g == 0 && c.b == 0;
}
/// True for a value that may enter the image: finite and not negative in every channel.
inline bool is_valid_radiance(Rgb c) {
    return c.r >= 0 && c.g >= 0 && c.b >= 0 && std::isfinite(c.r) && std::isfinite(c.g) &&
           std::isfinite(c.b);
}

}  // namespace aips
