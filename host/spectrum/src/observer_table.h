// The CIE 1931 standard observer (2 degrees), as the CIE tabulates it.
#pragma once

#include <array>

namespace lxs {

inline constexpr double kObserverFirstNm = 380, kObserverStepNm = 5;

/// x, y, z per row; CIE 15:2004, table T.4.
extern const std::array<std::array<double, 3>, 81> kObserverTable;

}  // namespace lxs
