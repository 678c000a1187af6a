// What became of photons, by the light that sent them and by the material that they met.
#pragma once

#include <cstdint>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/adapter/transport_statistics.h"
#include "aips/core/base/state_archive.h"

namespace aips {

/// What a surface did with a photon that met it.
enum class PhotonFate : std::uint8_t {
    Stored,    ///< left a photon
    Unseen,    ///< nothing near is seen
    Direct,    ///< shadow rays own it
    Specular,  ///< no lobe there takes photons
    Black      ///< nothing is scattered
};

/// Counts over photon paths, if the settings ask for transport statistics. Integers alone: their
/// sums do not depend on the order.
class PhotonStatistics {
  public:
    void path(LightIndex light, bool counted);
    /// `cut`: it might have gone on, but for the depth limit.
    void hit(std::uint32_t material, PhotonFate fate, bool cut);
    /// Forgets all counts, keeps their memory.
    void clear() {
        lights_.clear();
        materials_.clear();
    }
    PhotonStatistics& operator+=(const PhotonStatistics& other);
    /// Saves or restores the counts.
    void state(StateArchive& archive);
    void add_to(TransportStatistics& transport) const;

  private:
    struct Paths {
        std::uint64_t all = 0, counted = 0;

        Paths& operator+=(const Paths& other) {
            all += other.all;
            counted += other.counted;
            return *this;
        }
    };

    std::vector<Paths> lights_;                  // [light], as far as one was counted
    std::vector<MaterialStatistics> materials_;  // [material], likewise
};

}  // namespace aips
