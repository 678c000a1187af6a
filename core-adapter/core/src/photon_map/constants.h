// Tuned constants of grids over points: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

namespace aips {

/// Points in a row of cells that a segment crosses: with fewer, finding the ends of the rows takes
/// the time. Unit: points. Balances: points looked at in vain against rows. Chosen by: measurement
/// (4, 12, 24). Supported by: five scenes with media (4 up to 15 % slower; 24 within 4 %).
inline constexpr double kPointsOfARow = 12;

}  // namespace aips
