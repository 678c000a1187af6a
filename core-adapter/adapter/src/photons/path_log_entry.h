// Writes a photon path into the log while it is traced.
#pragma once

#include <vector>

#include "photons/photon_state.h"
#include "photons/scatter_photon.h"

namespace aips {

/// A path's record while the first of its photons is traced: closed when the path ends, wherever
/// that is.
class LogEntry {
  public:
    LogEntry(PathLog* log, bool vertices, const EmissionStart& start,
             const std::vector<Photon>& photons, const PhotonCounts& counts)
        : log_(log),
          vertices_(log && vertices),
          photons_(photons),
          counts_(counts),
          rays_before_(counts.rays) {
        if (!log_) return;
        PathRecord record;
        record.light = start.light;
        record.start = start.point;
        record.pdf = start.pdf;
        record.first_vertex = static_cast<std::uint32_t>(log_->vertices.size());
        record.first_photon = static_cast<std::uint32_t>(photons.size());
        log_->paths.push_back(record);
    }
    ~LogEntry() {
        if (!log_) return;
        PathRecord& record = log_->paths.back();
        record.vertices = static_cast<std::uint32_t>(log_->vertices.size()) - record.first_vertex;
        record.photons = static_cast<std::uint32_t>(photons_.size()) - record.first_photon;
        record.rays = rays();
    }
    LogEntry(const LogEntry&) = delete;
    LogEntry& operator=(const LogEntry&) = delete;

    bool has_vertices() const { return vertices_; }
    void add_vertex(const SurfacePoint& point, const PhotonState& photon,
                    const Survival& survived) const {
        if (!vertices_) return;
        PathVertex vertex;
        vertex.position = point.position;
        vertex.normal = normal_towards(-photon.ray.direction, point);
        vertex.power = luminance(photon.power) / survived.photons;
        vertex.survival = survived;
        vertex.rays = rays();
        vertex.depth = photon.depth;
        log_->vertices.push_back(vertex);
    }

    /// How the photon, which came from wo, left the vertex added last. The density of what the Bsdf
    /// drew by itself is found here: but for the log nothing asks for it.
    void set_direction(const SurfacePoint& point, Vec3 wo, const ScatteredPhoton& scattered) const {
        if (!vertices_) return;
        PathVertex& vertex = log_->vertices.back();
        vertex.direction = scattered.direction;
        vertex.pdf = scattered.pdf;
        vertex.plain_pdf = scattered.plain_pdf;
        if (scattered.lobe & kNonSpecular) {
            vertex.pdf = vertex.plain_pdf = point.bsdf->pdf(wo, scattered.direction, kNonSpecular);
        }
        vertex.lobes = point.bsdf->lobes();
    }

  private:
    std::uint32_t rays() const { return static_cast<std::uint32_t>(counts_.rays - rays_before_); }

    PathLog* log_;
    bool vertices_;
    const std::vector<Photon>& photons_;
    const PhotonCounts& counts_;
    std::uint64_t rays_before_;
};

}  // namespace aips
