// Input of the benchmarks: what photons do in scenes/cornell-box.lxs, recorded once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aips/adapter/scene.h"
#include "aips/core/photon_map/photon.h"
#include "lxs/scene/geometry.h"
#include "lxs/sdk/scene.h"

namespace aips::bench {

struct PhotonWorkload {
    std::vector<lxs::Geometry> geometry;  ///< of the whole scene, world space
    std::unique_ptr<lxs::Scene> host_scene;
    std::unique_ptr<Scene> scene;  ///< the same as the engine sees it
    std::uint32_t paths = 0;       ///< photon paths recorded
    std::vector<Ray> rays;         ///< in the order in which one thread traced them
    std::vector<Photon> photons;   ///< in the order of the paths
};

/// Throws when the scene can't be read.
const PhotonWorkload& photon_workload();

/// Photons of paths [first, first + count).
std::span<const Photon> photons_of_paths(std::uint32_t first, std::uint32_t count);

}  // namespace aips::bench
