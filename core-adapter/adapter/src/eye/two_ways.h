// The two ways that a specular surface offers.
#pragma once

#include <algorithm>
#include <cmath>

#include "aips/core/base/vector.h"

namespace aips {

/// A choice between them: the first one where u_lobe < first.
struct TwoWays {
    float first, u_lobe;
    Vec2 u;

    bool takes_first() const { return u_lobe < first; }
    /// Probability of the way that is taken.
    float share() const { return takes_first() ? first : 1 - first; }
    float other_share() const { return takes_first() ? 1 - first : first; }
    /// A number for u_lobe that takes the other way.
    float other() const {
        const float within = takes_first() ? u_lobe / first : (u_lobe - first) / (1 - first);
        return takes_first() ? std::min(first + within * (1 - first), 0x1.fffffep-1f)
                             : std::min(within * first, std::nextafter(first, 0.0f));
    }
};

}  // namespace aips
