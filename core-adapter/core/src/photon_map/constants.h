// Tuned constants of grids over points: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aips {}  // namespace aips
