// What a path sees of surfaces, for layers beside the image.
#pragma once

#include "lxs/sdk/layers.h"
#include "lxs/sdk/scene.h"

namespace lxs {

/// Told of every surface that the path meets and of how it goes on; it only looks.
class SurfaceView {
  public:
    /// `seen` may be null: nothing is wanted. Its depth is a distance along the camera ray.
    explicit SurfaceView(SeenSurface* seen) : seen_(seen) {}

    /// Whether there is more to be seen.
    bool wanted() const { return seen_ != nullptr; }

    /// The path has arrived at `hit` along `direction`.
    void meet(const SurfaceHit& hit, const Vec3& direction, const Rgb& throughput) {
        if (!met_) {
            met_ = true;
            straight_ = true;
            direction_ = direction;
            throughput_ = throughput;
            travelled_ += hit.distance;
            seen_->normal = hit.ng.dot(direction) < 0 ? hit.ns : -hit.ns;
            seen_->depth = travelled_;
            seen_->object = hit.object;
            seen_->material = hit.material;
        }
        if (hit.bsdf && hit.bsdf->lobes() == kSpecular) return;
        if (hit.bsdf) seen_->albedo = throughput * hit.bsdf->albedo(-direction, kAllLobes);
        seen_ = nullptr;
    }

    /// The path leaves the surface that it has met last. One that lets it pass as it came is none.
    void leave(const Vec3& direction, const Rgb& throughput) {
        if (!straight_) return;
        straight_ = false;
        if (direction != direction_ || throughput != throughput_) return;
        met_ = false;
        *seen_ = {};
    }

    /// A medium has scattered the path: what it meets from now on is not what the camera looks at.
    void scattered() { seen_ = nullptr; }

  private:
    SeenSurface* seen_;
    bool met_ = false;       ///< a surface that is none of those
    bool straight_ = false;  ///< the path is at it
    Vec3 direction_{0.0f};   ///< with which the path arrived at it
    Rgb throughput_{0.0f};
    float travelled_ = 0;
};

}  // namespace lxs
