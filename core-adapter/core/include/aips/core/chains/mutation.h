// Small steps in primary sample space, and their size that adapts itself.
// Source: Hachisuka & Jensen 2011, "Robust Adaptive Photon Tracing using Photon Path Visibility",
// sections 4.2 and 4.3.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "aips/core/base/state_archive.h"
#include "aips/core/chains/constants.h"

namespace aips {

/// A primary coordinate in [0, 1) as a fraction of 32 bits: it wraps around exactly.
using Coordinate = std::uint32_t;

/// Moves a coordinate by +-xi^exponent with equal probability (xi uniform in (0, 1), `exponent` at
/// least 1), around the circle [0, 1). The density of a step depends on its length alone, so the
/// kernel is symmetric. `bits`: 32 random bits, which give xi and the sign.
inline Coordinate mutate(Coordinate x, std::uint32_t bits, float exponent) {
    const float xi = (float(bits >> 9) + 0.5f) * 0x1p-23f;
    // Through 64 bits: a power rounded up to 1 is a full turn.
    const auto step = Coordinate(std::uint64_t(std::pow(xi, exponent) * 0x1p32f));
    return bits & 1 ? x + step : x - step;
}

/// The size of mutations: steered so that a share kGoal of them is accepted.
class MutationSize {
  public:
    static constexpr double kGoal = kMutationAcceptance;
    /// At the floor half of all steps are still above 2^-33 of the range, at the cap steps are
    /// close to independent draws.
    static constexpr double kFloor = 1.0 / 32, kCap = 8;

    double size() const { return size_; }
    /// Exponent of `mutate`: 1 / size + 1.
    float exponent() const { return float(1 / size_ + 1); }
    /// Steps learned from so far.
    std::uint64_t steps() const { return steps_; }

    /// Learns from the share of mutations accepted, in [0, 1], over `steps` (> 0) steps with the
    /// size as it is: size += gain * (share - goal), the gain being the sum of 1 / i over the steps
    /// i since the start. The gains fade, so that the size settles (diminishing adaptation).
    void learn(double share, std::uint64_t steps) {
        const double gain = std::log1p(double(steps) / (double(steps_) + 0.5));  // ~ harmonic sum
        size_ = std::clamp(size_ + gain * (share - kGoal), kFloor, kCap);
        steps_ += steps;
    }

    /// Saves or restores what was learned.
    void state(StateArchive& archive) {
        archive.value(size_);
        StateArchive::check(size_ >= kFloor && size_ <= kCap, "mutations of an unknown size");
        archive.value(steps_);
    }

  private:
    double size_ = 1;
    std::uint64_t steps_ = 0;
};

}  // namespace aips
