// Tuned constants of the pass loop: each with its unit, what it balances, which experiment chose
// it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

namespace aips {}  // namespace aips
