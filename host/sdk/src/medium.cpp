// Attenuation, free flights and phase function.
#include "lxs/sdk/medium.h"

#include <algorithm>
#include <cmath>

#include "field_flight.h"
#include "lxs/sdk/frame.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

/// Probability of each channel to decide: by what it carries.
Rgb shares(const Rgb& carried) {
    const float sum = carried.x + carried.y + carried.z;
    return sum > 0 && std::isfinite(sum) ? carried / sum : Rgb(1.0f / 3);
}

/// Draws a channel and stretches `u` to [0, 1) again.
int choose_channel(const Rgb& share, float& u) {
    int channel = 0;
    while (channel < 2 && u >= share[channel])
        u -= share[channel++];
    // Rounding may have passed the last channel that has a share.
    while (channel > 0 && !(share[channel] > 0))
        --channel;
    u = clamp_to_unit(u / share[channel]);
    return channel;
}

/// Henyey & Greenstein 1941, normalized, for the cosine between the directions before and after.
float henyey_greenstein(float g, float cosine) {
    const float base = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * kPi * base * std::sqrt(base));
}

/// Inverse of its distribution function in the cosine.
float sample_cosine(float g, float u) {
    if (std::abs(g) < 1e-3f) return 1 - 2 * u - 1.5f * g * (4 * u * u - 4 * u);
    const float s = (1 - g * g) / (1 + g - 2 * g * u);
    return std::clamp((1 + g * g - s * s) / (2 * g), -1.0f, 1.0f);
}

/// A ray is met once: its own bits draw what it meets.
HashedNumbers numbers_of(const Vec3& origin, const Vec3& direction) {
    return HashedNumbers().about(origin).about(direction);
}

}  // namespace

void Medium::bound(const Bounds& bounds, const FieldJobs& jobs) {
    bounded_.emplace(field_, bounds, jobs);
    MediumCoefficients mean = bounded_->mean();
    mean.asymmetry = asymmetry_;
    const bool scattered = scatters();
    set_coefficients(mean);
    // What is too little to be met by a sample still may be there.
    if (scattered && !scatters()) scattering_ = Rgb(std::numeric_limits<float>::min());
}

Rgb Medium::transmittance(const Vec3& origin, const Vec3& direction, float distance) const {
    if (!bounded_) return transmittance(distance);
    Rgb passed(1.0f);
    bounded_->fly(origin, direction, distance, numbers_of(origin, direction),
                  [&](float, const MediumCoefficients& here, float majorant) {
                      passed *= Rgb(1.0f) - here.extinction() / majorant;
                      return is_black(passed);
                  });
    return passed;
}

void Medium::transmittance_steps(const Vec3& origin, const Vec3& direction, float length, float u,
                                 std::vector<TransmittanceStep>& steps) const {
    steps.assign(1, {});
    if (!bounded_) return;
    bounded_->fly(origin, direction, length, numbers_of(origin, direction).about(u),
                  [&](float distance, const MediumCoefficients& here, float majorant) {
                      const Rgb share = Rgb(1.0f) - (here.absorption + here.scattering) / majorant;
                      steps.push_back({distance, steps.back().passed * share});
                      return is_black(steps.back().passed);
                  });
}

Rgb Medium::emitted(const Vec3& origin, const Vec3& direction, float length) const {
    if (!emits_) return Rgb(0.0f);
    if (bounded_)
        return bounded_->emitted(origin, direction, length, numbers_of(origin, direction));
    const auto channel = [&](float emission, float extinction) {
        if (!(emission > 0)) return 0.0f;
        return emission *
               (extinction > 0 ? -std::expm1(-extinction * length) / extinction : length);
    };
    return {channel(emission_.x, extinction_.x), channel(emission_.y, extinction_.y),
            channel(emission_.z, extinction_.z)};
}

// Where light may collide it does with a probability p of what it carries and meets; weights of the
// channels are Kutz et al.'s, eq. 12 to 14.
Flight Medium::sample_flight(const Vec3& origin, const Vec3& direction, float segment,
                             const Rgb& carried, const Vec2& u) const {
    if (!bounded_) return sample_flight(segment, carried, u);
    const Rgb share = shares(carried);
    Flight flight;
    flight.distance = segment;
    HashedNumbers numbers = HashedNumbers().about(u.x).about(u.y);
    flight.collides = bounded_->fly(
        origin, direction, segment, HashedNumbers().about(u.y).about(u.x).about(1.0f),
        [&](float distance, const MediumCoefficients& here, float majorant) {
            const Rgb extinction = here.extinction();
            const Rgb weighed = share * flight.weight;
            const float all = weighed.x + weighed.y + weighed.z;
            const float p =
                all > 0 ? std::clamp(weighed.dot(extinction) / (all * majorant), 0.0f, 1.0f) : 1;
            if (numbers.next() < p) {
                flight.weight *= Rgb(1.0f) / (majorant * p);
                flight.distance = distance;
                return true;
            }
            flight.weight *= (Rgb(1.0f) - extinction / majorant) / (1 - p);
            return false;
        });
    return flight;
}

Rgb Medium::transmittance(float distance) const {
    // A channel without absorption stays clear over an infinite distance, where 0 * inf is NaN.
    const auto channel = [&](float extinction) {
        return extinction > 0 ? std::exp(-extinction * distance) : 1.0f;
    };
    return {channel(extinction_.x), channel(extinction_.y), channel(extinction_.z)};
}

Flight Medium::sample_flight(float segment, const Rgb& carried, const Vec2& u) const {
    const Rgb share = shares(carried);
    float u_channel = u.x;
    const float extinction = extinction_[choose_channel(share, u_channel)];
    Flight flight;
    const float distance = -std::log1p(-u.y) / extinction;  // infinite or NaN without extinction
    flight.collides = extinction > 0 && distance < segment;
    flight.distance = flight.collides ? distance : segment;
    flight.weight = transmittance(flight.distance);
    const Rgb density = flight.collides ? flight.weight * extinction_ : flight.weight;
    const float pdf = share.dot(density);
    flight.weight = pdf > 0 ? flight.weight / pdf : Rgb(0.0f);
    return flight;
}

Rgb Medium::phase(float cosine) const {
    // Most media turn all colours alike.
    if (asymmetry_ == Rgb(asymmetry_.x)) return Rgb(henyey_greenstein(asymmetry_.x, cosine));
    return {henyey_greenstein(asymmetry_.x, cosine), henyey_greenstein(asymmetry_.y, cosine),
            henyey_greenstein(asymmetry_.z, cosine)};
}

float Medium::phase_pdf(float cosine, const Rgb& carried) const {
    return shares(carried).dot(phase(cosine));
}

PhaseSample Medium::sample_phase(const Vec3& direction, const Rgb& carried, const Vec2& u) const {
    const Rgb share = shares(carried);
    Vec2 rest = u;
    const int channel = choose_channel(share, rest.x);
    const float cosine = sample_cosine(asymmetry_[channel], rest.x);
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    const float angle = 2 * kPi * rest.y;
    PhaseSample sample;
    sample.direction =
        Frame(direction).to_world({sine * std::cos(angle), sine * std::sin(angle), cosine});
    sample.direction.normalize();
    const Rgb density = phase(cosine);
    sample.pdf = share.dot(density);
    sample.weight = density / sample.pdf;
    return sample;
}

}  // namespace lxs
