// The emitter paths of a pass, and a pass's searches for images that they may be drawn through.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/core/base/cache_line.h"
#include "eye/eye_pass.h"

namespace aips {

/// What the emitter paths of a pass met, black ones left out.
struct alignas(kCacheLine) EmitterSplats {
    std::vector<Vec2> positions;  ///< pixels
    std::vector<Rgb> radiance;    ///< [splat * groups + group], as FilmSplats has it
    std::uint64_t paths = 0, rays = 0;
    /// Luminances of these by light, if the settings ask for transport statistics.
    LuminanceByLight light;

    std::size_t memory_bytes() const {
        return positions.capacity() * sizeof(Vec2) + radiance.capacity() * sizeof(Rgb);
    }
};

/// Draws the paths of `input.emitters` for pass number `pass`; `splats` is refilled, its memory
/// reused. The result does not depend on the number of threads.
void trace_emitter_paths(const EyePassInput& input, std::uint64_t pass, float time,
                         InvalidSampleFilter& filter, EmitterSplats& splats);

/// What searches found, in their order.
struct alignas(kCacheLine) EmitterFindings {
    std::vector<EmitterImage> images;
    std::uint64_t rays = 0;
};

/// Searches `count` times, from anywhere on the film. No two rounds of a render have the same
/// number.
EmitterFindings search_emitters(const EyePassInput& input, std::uint64_t round, std::uint32_t count,
                                float time, InvalidSampleFilter& filter);

}  // namespace aips
