// An iteration: a block of photon paths traced with a frozen guide.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "aips/core/base/cache_line.h"
#include "aips/core/base/unwritten.h"
#include "photons/constants.h"
#include "photons/photon_path.h"

namespace aips {

/// Photon paths of an iteration that no guide learns from.
inline constexpr std::uint32_t kPlainIterationPaths = 1u << 16;

/// Most surfaces at which a photon path may leave a photon: those that count for its bound, and
/// the first that it passes straight, as the shadow ray passes them that may take its place.
inline std::uint32_t most_photons_per_path(const Settings& settings) {
    return photon_depth(settings).surfaces + kMostFreeSurfaces;
}

/// Most surfaces that a photon path meets: specular ones take no photon.
inline std::uint32_t most_surfaces(const Settings& settings) {
    return most_photons_per_path(settings) + photon_depth(settings).specular;
}

/// Photons in a block from which on no photon is split: as many as whole paths may leave at most.
inline std::size_t split_limit(const Settings& settings) {
    return std::size_t{kPathsPerBlock} * photon_depth(settings).surfaces;
}

/// Most photons of blocks with so many paths: with splitting, those up to the limit, those of all
/// other paths, and those of photons that wait.
inline std::size_t most_photons(const Settings& settings, std::size_t paths) {
    const bool splits = settings.guide == GuideKind::Adaptive && settings.guide_survival;
    return paths * most_photons_per_path(settings) * (splits ? 3 : 1);
}

/// The photons of photon paths, in the order of the paths.
class PhotonStore {
  public:
    std::span<const Photon> photons() const { return photons_; }
    void clear() { photons_.clear(); }
    std::size_t memory_bytes() const { return photons_.capacity() * sizeof(Photon); }
    void append(std::span<const Photon> photons) {
        std::ranges::copy(photons, grow(photons.size()).begin());
    }
    /// Room for so many photons behind the others, to be written to; valid until there are more.
    std::span<Photon> grow(std::size_t photons);
    /// Of all photons from number `first` on.
    void scale_power(std::size_t first, float factor);

  private:
    UnwrittenVector<Photon> photons_;
};

/// Traces photon paths in parallel blocks, whose memory it keeps.
class PhotonTracer {
  public:
    /// Traces `count` paths from number `first` of the pass and appends their photons to `store`,
    /// the records of those that input.log_one_of selects to `log`, and what is left in media that
    /// scatter to `collisions` (null if none does).
    /// The result does not depend on the number of threads, nor on that of ranks.
    PhotonCounts trace(const PhotonInput& input, std::uint64_t paths_before_pass,
                       std::uint32_t first, std::uint32_t count, InvalidSampleFilter& filter,
                       PhotonStore& store, PathLog* log = nullptr,
                       std::vector<VolumePhoton>* collisions = nullptr);

    std::size_t memory_bytes() const;

  private:
    struct alignas(kCacheLine) Block {
        std::size_t first = 0;  // photon of the iteration
        std::vector<Photon> photons;
        std::vector<VolumePhoton> collisions;
        PathLog log;
        PhotonCounts counts;

        /// Saves it for another rank, or takes it from one.
        void state(StateArchive& archive);
    };

    PhotonCounts join(std::span<Block> blocks, PhotonStore& store) const;

    std::vector<Block> blocks_;
    tbb::enumerable_thread_specific<Arena> arenas_;
};

}  // namespace aips
