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

/// Least size of mutations. Unit: inverse of the power of a step, less 1.
/// Balances: narrow peaks against a chain that freezes.
/// Chosen by: reasoning: half of all steps are still above 2^-33 of the range.
/// Supported by: no measurement.
inline constexpr double kLeastMutation = 1.0 / 32;

/// Greatest size of mutations. Unit: inverse of the power of a step, less 1.
/// Balances: wide steps against steps that know nothing of where the chain is.
/// Chosen by: reasoning: at this size mutations are close to independent draws.
/// Supported by: no measurement.
inline constexpr double kGreatestMutation = 8;

}  // namespace aips
