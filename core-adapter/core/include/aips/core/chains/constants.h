// Tuned constants of chains on photon paths: each with its unit, what it balances, which experiment
// chose it, and what supports it. docs/build-on/constants.md is made from these comments.
#pragma once

namespace aips {

/// Share of the mutations that is accepted: their size is steered to it. Unit: share of 1.
/// Balances: long steps against steps that are taken.
/// Chosen by: reasoning: what a random walk in many dimensions does best with (Roberts et al.
///   1997).
/// Supported by: no measurement.
inline constexpr double kMutationAcceptance = 0.234;

}  // namespace aips
