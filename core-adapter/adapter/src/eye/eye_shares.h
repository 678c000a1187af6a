// From which visible points eye paths go on, and for which share of the light there.
#pragma once

#include <cstdint>

#include "aips/core/tables/share_table.h"
#include "eye/constants.h"

namespace aips {

/// Const while a pass is traced; whoever learns from passes changes it in between.
struct EyeShares {
    explicit EyeShares(const Bounds& scene) : table(scene) {}

    /// Whether eye path `path` of pass `pass` goes on even where it has no share, to tell what it
    /// would bring.
    bool explores(std::uint64_t pass, std::uint32_t path) const {
        const std::uint64_t stride = pass < kFirstExploringPasses ? kFirstExplorers
                                     : pass < kExploringPasses    ? kExplorers
                                                                  : kLateExplorers;
        return (pass + path) % stride == 0;
    }
    /// The eye's share at a place on the side that `normal` shows.
    float at(Vec3 position, Vec3 normal) const { return any ? table.at(position, normal) : 0; }

    ShareTable table;
    /// Passes before the present shares were set. Numbers that are stratified over passes start
    /// anew there: points that keep away from those that were learned from are not independent of
    /// what was learned.
    std::uint64_t passes_before = 0;

    bool any = false;  ///< whether some share is above 0
};

}  // namespace aips
