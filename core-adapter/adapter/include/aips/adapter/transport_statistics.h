// Transport statistics: what became of the light of each emitter, and of the photons that met each
// material. Plain counts, so that a host can tell its user why an image looks as it does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aips {

/// Lights that transport statistics tell apart; the last entry stands for all from here on.
inline constexpr std::uint32_t kMostToldLights = 1024;

/// Of one light. Both luminances are means over the image; that of photons is told by a part of the
/// visible points. What photons bring in media is in neither.
struct LightStatistics {
    std::uint64_t paths = 0;    ///< photon paths that it began
    std::uint64_t counted = 0;  ///< of these, those that landed near what the camera sees
    double seen = 0;     ///< luminance that eye paths brought: seen itself, or by shadow rays
    double photons = 0;  ///< luminance that its photons brought
};

/// Of the photons that met one material: each hit is in `hits` and in one of the five below it.
struct MaterialStatistics {
    std::uint64_t hits = 0;
    std::uint64_t stored = 0;        ///< landed near what the camera sees
    std::uint64_t unseen = 0;        ///< would land, but nothing near is seen
    std::uint64_t direct = 0;        ///< straight from a light: left to shadow rays
    std::uint64_t specular = 0;      ///< no lobe there takes photons: they only pass
    std::uint64_t black = 0;         ///< nothing is scattered there, or no power was left
    std::uint64_t cut = 0;           ///< had power left, and ended by the depth limit
    std::uint64_t cut_specular = 0;  ///< of these, where no lobe takes photons

    MaterialStatistics& operator+=(const MaterialStatistics& other);
};

struct TransportStatistics {
    std::vector<LightStatistics> lights;        ///< [light], up to kMostToldLights; may end earlier
    std::vector<MaterialStatistics> materials;  ///< [material]; may end earlier
    std::uint64_t eye_paths = 0;
    std::uint64_t cut_eye_paths = 0;   ///< ended at a specular surface by the depth limit
    bool caustics_on_gloss = false;    ///< photons bring them to glossy lobes
    std::vector<std::string> skipped;  ///< parts that were left out, with the reason of each
};

}  // namespace aips
