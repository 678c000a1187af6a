// Tells whether a host keeps the contracts of docs/build-on/host-conventions.md: emission, sampling
// and density of every light and Bsdf agree, surfaces are sound, memory and lobes are what facts()
// says.
//
// Where chance is involved, a finding needs two estimates of the same number that lie further apart
// than bounded samples do with a probability of 1e-8 (empirical Bernstein bounds, Maurer & Pontil
// 2009), and a difference that matters. So a healthy host is left alone, and a fault of a few
// percent may go unseen.
#pragma once

#include <string>
#include <vector>

#include "aips/adapter/scene.h"

namespace aips {

/// How much is looked at: time and memory are bounded by these counts. The defaults take a second
/// or two for a scene of a few dozen materials and lights.
struct HostValidationSettings {
    std::uint64_t seed = 0;             ///< same scene, same seed: same findings
    float time = 0;                     ///< of all rays, within the shutter interval
    std::uint32_t rays = 20'000;        ///< shot through the scene to meet its surfaces
    std::uint32_t samples = 4096;       ///< drawn from each density at each place
    std::uint32_t places = 4;           ///< where each material and each light is asked
    std::uint32_t most_materials = 64;  ///< asked, evenly spread over those met
    std::uint32_t most_lights = 64;     ///< asked, evenly spread
};

/// One contradiction in a host.
struct HostFinding {
    std::string subject;   ///< 'light 3 "area"', 'material 2 "glass"' or "scene"
    std::string check;     ///< what was compared, in a word or two: "power", "lobes", "memory", ...
    std::string found;     ///< with figures
    std::string expected;  ///< in its place
    /// Bound of the probability that chance brings a sound host this finding; 0: no chance involved
    double chance = 0;
};

/// 'light 3 "area": power: found ..., expected ...', and by which chance.
std::string to_string(const HostFinding& finding);

/// All that is found, the scene's first, then materials and lights by number; empty for a sound
/// host. Each cause is reported once, where it is nearest to. Uses one thread.
std::vector<HostFinding> validate_host(const Scene& scene,
                                       const HostValidationSettings& settings = {});

}  // namespace aips
