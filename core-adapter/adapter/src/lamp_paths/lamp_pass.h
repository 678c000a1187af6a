// The lamp paths of a pass, and a pass's searches for images that they may be drawn through.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/core/base/cache_line.h"
#include "eye/eye_pass.h"

namespace aips {

/// What the lamp paths of a pass met, black ones left out.
struct alignas(kCacheLine) LampSplats {
    std::vector<Vec2> positions;  ///< pixels
    std::vector<Rgb> radiance;    ///< [splat * groups + group], as FilmSplats has it
    std::uint64_t paths = 0, rays = 0;
    LuminanceByLight light;  ///< luminances of these by light, if the settings ask for an account

    std::size_t memory_bytes() const {
        return positions.capacity() * sizeof(Vec2) + radiance.capacity() * sizeof(Rgb);
    }
};

/// Draws the paths of `input.lamps` for pass number `pass`; `splats` is refilled, its memory
/// reused. The result does not depend on the number of threads.
void trace_lamp_paths(const EyePassInput& input, std::uint64_t pass, float time, Refusals& refusals,
                      LampSplats& splats);

/// What searches found, in their order.
struct alignas(kCacheLine) LampFindings {
    std::vector<LampImage> images;
    std::uint64_t rays = 0;
};

/// Searches `count` times, from anywhere on the film. No two rounds of a render have the same
/// number.
LampFindings search_lamps(const EyePassInput& input, std::uint64_t round, std::uint32_t count,
                          float time, Refusals& refusals);

}  // namespace aips
