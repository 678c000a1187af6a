// The three wavelengths of each pass.
#pragma once

#include <cstdint>
#include <vector>

#include "lux_view.h"

namespace aips::luxrender {

/// Draws wavelengths by the eye's sensitivity, in three strata at offsets that follow a Sobol'
/// sequence from pass to pass, so that the tint of single passes fades fast. Other seeds have other
/// sequences.
class PassWavelengths {
  public:
    PassWavelengths(const LuxView& view, std::uint64_t seed);

    struct Drawn {
        Triple nanometres;   ///< the longest first
        Triple per_density;  ///< LuxView::set_wavelengths
    };
    Drawn of_pass(std::uint64_t pass) const;

  private:
    std::uint32_t scramble_;
    float shortest_, step_;           ///< nanometres
    std::vector<double> cumulative_;  ///< of the density at the end of each step; the last is 1
};

}  // namespace aips::luxrender
