// Distances on a segment within a medium.
#include "eye/volume_beam.h"

#include <algorithm>
#include <limits>

namespace aips {

SegmentExponential::SegmentExponential(Rgb extinction, Rgb scattering, float length)
    : length_(length) {
    float rate = std::numeric_limits<float>::max();
    if (scattering.r > 0) rate = std::min(rate, extinction.r);
    if (scattering.g > 0) rate = std::min(rate, extinction.g);
    if (scattering.b > 0) rate = std::min(rate, extinction.b);
    // Below this a uniform density is the same in single precision, and free of 0 / 0.
    constexpr float kThin = 1e-6f;
    rate_ = std::max(rate, kThin / length);
    mass_ = -std::expm1(-rate_ * length);
}

float SegmentExponential::sample(float u) const {
    return std::min(-std::log1p(-u * mass_) / rate_, length_);
}

float SegmentExponential::pdf(float t) const {
    return rate_ * std::exp(-rate_ * t) / mass_;
}

}  // namespace aips
