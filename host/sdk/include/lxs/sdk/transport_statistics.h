// What an integrator tells of a render for its user: what became of the light of each emitter and
// of the photons that met each material, what was left out, where time went. Plain data.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lxs/sdk/bsdf.h"

namespace lxs {

/// Of one light. Luminances are means over the image, as far as they can be told apart by light.
struct LightStatistics {
    std::uint64_t photon_paths = 0;
    std::uint64_t counted_paths = 0;  ///< of these, those that left light where the camera sees
    double seen = 0;                  ///< luminance seen directly, by shadow rays or by eye paths
    double photons = 0;               ///< luminance that photons brought
};

/// Of the photons that met one material: each of the hits is in one of the five counts below it.
struct MaterialStatistics {
    std::uint64_t hits = 0;
    std::uint64_t taken = 0;        ///< where the camera sees
    std::uint64_t unseen = 0;       ///< would be taken, but nothing near is seen
    std::uint64_t direct = 0;       ///< straight from a light: left to shadow rays
    std::uint64_t passing = 0;      ///< what is there takes no photons: they only go on
    std::uint64_t black = 0;        ///< nothing is scattered there
    std::uint64_t cut = 0;          ///< ended by the depth limit
    std::uint64_t cut_passing = 0;  ///< of these, where photons only pass
};

struct TransportStatistics {
    std::vector<LightStatistics> lights;        ///< [light]; may end before the last
    std::vector<MaterialStatistics> materials;  ///< [material]; may end before the last
    std::uint64_t eye_paths = 0;
    std::uint64_t cut_eye_paths = 0;  ///< ended by the depth limit at glass or mirrors
    double radius = 0;                ///< photons are gathered within, scene units; 0: none are
    /// Lobes that take no photons, of an integrator that shoots some: light that comes to them
    /// through glass or by mirrors is there only if a ray meets the emitter.
    LobeMask without_photons = 0;
    std::vector<std::string> skipped;  ///< parts left out: "media: none in the scene"
    std::vector<std::pair<std::string, double>> seconds;  ///< by stage, of wall time
};

}  // namespace lxs
