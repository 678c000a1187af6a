// What an image knows of its own error.
#pragma once

#include <cstdint>

namespace lxs {

/// Estimated from the passes alone, by the definitions of docs/measured/method.md.
struct ErrorEstimate {
    /// Of all pixels but those 0.1 % whose own is largest, at least one: single pixels that a
    /// bright path has met decide the figure of the whole.
    double relmse = 0;
    double relmse_low = 0, relmse_high = 0;  ///< where the true one lies in 19 of 20 images
    double relmse_of_bias = 0;               ///< the part of relmse that bias is known to have
    double relmse_whole = 0;                 ///< of all pixels
    double rmse = 0;                         ///< without its own worst 0.1 %, radiance
    double rmse_low = 0, rmse_high = 0;
    double rmse_of_bias = 0;   ///< of bias alone
    double rmse_whole = 0;     ///< of all pixels
    std::uint64_t passes = 0;  ///< that it was estimated after
    /// About as many independent squares as each pixel's variance rests on.
    double degrees_of_freedom = 1;

    /// Square root of relmse: the error of a typical pixel as share of its brightness. This is the
    /// unit of "haltthreshold" and of --target-error.
    double relative() const;
};

}  // namespace lxs
