// The mock host's medium. Channels decide alike, whatever the path carries.
#include "mock_media.h"

#include <algorithm>
#include <cmath>

#include "aips/core/sampling/sampling.h"
#include "mock_scene.h"

namespace mock {
namespace {

double mean(aips::Rgb c) {
    return (double(c.r) + double(c.g) + double(c.b)) / 3;
}

}  // namespace

aips::Rgb Fog::transmittance(float distance) const {
    const aips::Rgb e = extinction();
    return {std::exp(-e.r * distance), std::exp(-e.g * distance), std::exp(-e.b * distance)};
}

aips::Flight Media::sample_flight(const void*, const aips::Ray&, float segment,
                                  aips::Rgb /*carried*/, aips::Vec2 u) const {
    const aips::Rgb extinction = fog_.extinction();
    const float rates[] = {extinction.r, extinction.g, extinction.b};
    const float rate = rates[std::min(int(u.x * 3), 2)];
    const float distance = rate > 0 ? -std::log(1 - u.y) / rate : segment;
    aips::Flight flight;
    flight.collides = distance < segment;
    flight.distance = flight.collides ? distance : segment;
    const aips::Rgb passed = fog_.transmittance(flight.distance);
    const double pdf = flight.collides ? mean(extinction * passed) : mean(passed);
    flight.weight = passed * float(1 / pdf);
    return flight;
}

/// Henyey & Greenstein 1941.
aips::Rgb Media::phase(const void*, float cosine) const {
    const float g = fog_.asymmetry, base = 1 + g * g - 2 * g * cosine;
    const float value = (1 - g * g) / (4 * aips::kPi * base * std::sqrt(base));
    return {value, value, value};
}

aips::PhaseSample Media::sample_phase(const void*, aips::Vec3 direction, aips::Rgb /*carried*/,
                                      aips::Vec2 u) const {
    const float g = fog_.asymmetry;
    float cosine = 2 * u.x - 1;
    if (g != 0) {
        const float s = (1 - g * g) / (1 + g * cosine);
        cosine = (1 + g * g - s * s) / (2 * g);
    }
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    const float angle = 2 * aips::kPi * u.y;
    const aips::Frame frame(direction);
    return {frame.to_world({sine * std::cos(angle), sine * std::sin(angle), cosine}), aips::kWhite};
}

aips::Rgb Media::visibility(const void*, aips::Vec3 from, const aips::DirectSample& light,
                            float time) const {
    return scene_.visibility_from(from, light, time);
}

}  // namespace mock
