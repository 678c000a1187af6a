// What a rough fibre does to light: values and sampling.
#include "fibre_lobe.h"

#include <algorithm>
#include <cmath>

#include "directions.h"
#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"

namespace lxs::shading {
namespace {

/// How closely what goes through a fibre goes on in its direction: mean cosine of the azimuth.
constexpr float kForward = 0.6f;

template <std::size_t N>
float polynomial(const float (&coefficients)[N], float x) {
    float sum = 0;
    for (std::size_t i = N; i-- > 0;)
        sum = sum * x + coefficients[i];
    return sum;
}

/// exp(-x) I0(x), I0 being the modified Bessel function, for x >= 0; relative error below 2e-6
/// (Abramowitz & Stegun 1964, 9.8.1 and 9.8.2).
float scaled_bessel_i0(float x) {
    constexpr float kSmall[] = {1.0f,       3.5156229f, 3.0899424f, 1.2067492f,
                                0.2659732f, 0.0360768f, 0.0045813f};
    constexpr float kLarge[] = {0.39894228f,  0.01328592f, 0.00225319f,  -0.00157565f, 0.00916281f,
                                -0.02057706f, 0.02635537f, -0.01647633f, 0.00392377f};
    constexpr float kBorder = 3.75f;
    const float t = x / kBorder;
    if (t < 1) return std::exp(-x) * polynomial(kSmall, t * t);
    return polynomial(kLarge, 1 / t) / std::sqrt(x);
}

/// Cosine of the angle to the plane that is perpendicular to the fibre.
float cosine_of(float sine) {
    return std::sqrt(std::max(0.0f, 1 - sine * sine));
}

/// Azimuth with the density that FibreLobe::around has.
float sample_around(float through, float u) {
    if (u >= through) {
        const float rest = (u - through) / (1 - through);
        return 2 * std::asin(std::clamp(2 * rest - 1, -1.0f, 1.0f));
    }
    constexpr float kRatio = (1 - kForward) / (1 + kForward);
    return kPi + 2 * std::atan(kRatio * std::tan(kPi * (u / through - 0.5f)));
}

}  // namespace

FibreLobe::FibreLobe(float variance, float through)
    : variance_(variance),
      through_(through),
      tail_(std::exp(-2 / variance)),
      scale_(1 / (variance * (1 - tail_))) {}

// d'Eon et al.'s csch(1/v) / (2v) exp(-sin sin / v) I0(cos cos / v), its large factors cancelled.
float FibreLobe::along(float sine_a, float cosine_a, float sine_b, float cosine_b) const {
    const float cosines = cosine_a * cosine_b;
    const float exponent = (cosines - sine_a * sine_b - 1) / variance_;
    return scale_ * std::exp(std::min(exponent, 0.0f)) * scaled_bessel_i0(cosines / variance_);
}

float FibreLobe::around(float cosine) const {
    // A smooth surface of a cylinder: cos(phi / 2) / 4.
    const float reflected = 0.25f * std::sqrt(std::max(0.0f, 0.5f * (1 + cosine)));
    // The wrapped Cauchy distribution about pi.
    constexpr float kSquare = kForward * kForward;
    const float passed = 0.5f * kInvPi * (1 - kSquare) / (1 + kSquare + 2 * kForward * cosine);
    return (1 - through_) * reflected + through_ * passed;
}

float FibreLobe::value(const Vec3& tangent, const Vec3& a, const Vec3& b) const {
    const float sine_a = tangent.dot(a), sine_b = tangent.dot(b);
    const float cosine_a = cosine_of(sine_a), cosine_b = cosine_of(sine_b);
    const float cosines = cosine_a * cosine_b;
    const float azimuth =
        cosines > kMinCosine ? std::clamp((a.dot(b) - sine_a * sine_b) / cosines, -1.0f, 1.0f) : 0;
    return along(sine_a, cosine_a, sine_b, cosine_b) * around(azimuth);
}

Vec3 FibreLobe::sample(const Vec3& tangent, const Vec3& a, const Vec2& u, float u_around) const {
    const float sine_a = std::clamp(tangent.dot(a), -1.0f, 1.0f), cosine_a = cosine_of(sine_a);
    // A von Mises-Fisher draw about the mirrored direction, of which the inclination counts.
    const float least = std::max(u.x, 0x1p-25f);  // a zero stands for the first of 2^24 steps
    const float c = std::clamp(1 + variance_ * std::log(least + (1 - least) * tail_), -1.0f, 1.0f);
    const float turned = cosine_of(c) * sine_cosine_of_turn(u.y).cosine;
    const float sine_b = std::clamp(turned * cosine_a - c * sine_a, -1.0f, 1.0f);
    const Frame fibre(tangent, a);
    const float azimuth = sample_around(through_, u_around), cosine_b = cosine_of(sine_b);
    const Vec3 across = fibre.s * std::cos(azimuth) + fibre.t * std::sin(azimuth);
    return (across * cosine_b + tangent * sine_b).normalized();
}

}  // namespace lxs::shading
