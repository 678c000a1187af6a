// Where photons lose light, as a gather disc is not all surface: eye paths may bring it.
#pragma once

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"
#include "eye/eye_pass.h"

namespace aips {

/// What earlier passes told of gather discs. Const while a pass is traced.
class DiscGaps {
  public:
    virtual ~DiscGaps() = default;
    /// Share of their light that photons lose around a place of the film, as far as it is known:
    /// in [0, 1), or below 0 where no disc was found to have gaps.
    virtual float lost_share(Vec2 film) const = 0;
    /// Whether an eye path is to bring the light of `point` in the place of photons: true with the
    /// probability of what they lose there. `time` is that of rays, which are added to `rays`;
    /// `arena` is left as it was.
    virtual bool loses(const VisiblePoint& point, Vec2 film, float time, RandomStream& random,
                       Arena& arena, std::uint32_t& rays) const = 0;
};

}  // namespace aips
