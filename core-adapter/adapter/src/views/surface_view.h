// What an eye path sees of surfaces, for layers beside the image.
#pragma once

#include "aips/adapter/layers.h"
#include "aips/adapter/scene.h"

namespace aips {

/// Told of every surface that the path meets and of how it goes on; it only looks.
class SurfaceView {
  public:
    SurfaceView() = default;
    /// `seen` may be null: nothing is wanted.
    explicit SurfaceView(SeenSurface* seen) : seen_(seen) {}

    /// Whether there is more to be seen.
    bool wanted() const { return seen_ != nullptr; }

    /// The path has arrived at `point` along `direction`.
    void meet(const SurfacePoint& point, Vec3 direction, const Rgb& throughput, float depth) {
        const Vec3 wo = -direction;
        if (!met_) {
            met_ = true;
            straight_ = true;
            direction_ = direction;
            throughput_ = throughput;
            const bool front = dot(wo, point.geometric_normal) > 0;
            seen_->normal = front ? point.shading_normal : -point.shading_normal;
            seen_->depth = depth;
            seen_->object = point.object;
            seen_->material = point.material;
        }
        if (point.bsdf && point.bsdf->lobes() == kSpecular) return;
        if (point.bsdf) seen_->albedo = throughput * point.bsdf->albedo(wo, kAllLobes);
        seen_ = nullptr;
    }

    /// The path leaves the surface that it has met last. One that lets it pass as it came is none.
    void leave(Vec3 direction, const Rgb& throughput) {
        if (!straight_) return;
        straight_ = false;
        if (!(direction == direction_) || !(throughput == throughput_)) return;
        met_ = false;
        *seen_ = {};
    }

  private:
    SeenSurface* seen_ = nullptr;
    bool met_ = false;       // a surface that is none of those
    bool straight_ = false;  // the path is at it
    Vec3 direction_;         // with which the path arrived at it
    Rgb throughput_;
};

}  // namespace aips
