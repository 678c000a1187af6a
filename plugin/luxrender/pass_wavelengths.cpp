// The three wavelengths of each pass.
#include "pass_wavelengths.h"

#include <algorithm>

#include "aips/core/sampling/low_discrepancy.h"

namespace aips::luxrender {
namespace {

constexpr unsigned kSteps = 340;
/// Share of the density that is even over all wavelengths: bounds the weight of the eye's ends,
/// where what lamps and surfaces do may be large and the eye's sensitivity is next to nothing.
constexpr double kEvenShare = 0.1;
/// Of the Sobol' sequence whose first four place SobolSampler's samples in film and lens: a pass's
/// wavelengths and its places are spread evenly together.
constexpr unsigned kDimension = 4;

}  // namespace

PassWavelengths::PassWavelengths(const LuxView& view, std::uint64_t seed)
    : scramble_(hash_bits(std::uint32_t(seed) ^ hash_bits(std::uint32_t(seed >> 32)))),
      shortest_(view.shortest_wavelength()),
      step_((view.longest_wavelength() - shortest_) / kSteps),
      cumulative_(kSteps) {
    double sum = 0;
    for (unsigned i = 0; i < kSteps; ++i)
        cumulative_[i] = sum += view.sensitivity(shortest_ + (float(i) + 0.5f) * step_);
    for (unsigned i = 0; i < kSteps; ++i) {
        const double by_eye = sum > 0 ? cumulative_[i] / sum * (1 - kEvenShare) : 0;
        const double even = (i + 1.0) / kSteps;
        cumulative_[i] = sum > 0 ? by_eye + kEvenShare * even : even;
    }
    cumulative_.back() = 1;
}

PassWavelengths::Drawn PassWavelengths::of_pass(std::uint64_t pass) const {
    const double offset = sobol_owen(pass, kDimension, scramble_);
    Drawn drawn;
    for (unsigned k = 0; k < 3; ++k) {
        const double u = (double(2 - k) + offset) / 3;
        const auto at = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u);
        const auto i = static_cast<std::size_t>(at - cumulative_.begin());
        const double before = i > 0 ? cumulative_[i - 1] : 0;
        const double share = cumulative_[i] - before;
        drawn.nanometres.v[k] = shortest_ + step_ * float(double(i) + (u - before) / share);
        drawn.per_density.v[k] = float(step_ / share / 3);
    }
    return drawn;
}

}  // namespace aips::luxrender
