// A profile of intensities as it lies on the surface of an area light.
#include "surface_profile.h"

#include <cmath>

namespace lxs {

SurfaceProfile::SurfaceProfile(std::shared_ptr<const FrontProfile> front, const Matrix& to_world)
    : front_(std::move(front)), mirrored_(to_world.determinant() < 0) {
    const auto axis = [&](int i) {
        return Vec3(Imath::V3d(to_world[i][0], to_world[i][1], to_world[i][2]).normalized());
    };
    x_ = axis(0), y_ = axis(1);
}

Frame SurfaceProfile::frame(const Vec3& n) const {
    constexpr float kNearlyAlong = 0.999f;  // 2.6 degrees
    Frame frame(n, std::abs(n ^ x_) < kNearlyAlong ? x_ : y_);
    if (mirrored_) frame.t = -frame.t;
    return frame;
}

Rgb SurfaceProfile::radiance(const Vec3& n, const Vec3& w) const {
    return front_->radiance(frame(n).to_local(w));
}

float SurfaceProfile::sample(const Vec3& n, const Vec2& u, Vec3& w) const {
    Vec3 local(0.0f);
    const float density = front_->sample(u, local);
    w = frame(n).to_world(local).normalized();
    return density;
}

bool SurfaceProfile::coordinates(const Vec3& n, const Vec3& w, Vec2& u) const {
    return front_->coordinates(frame(n).to_local(w), u);
}

}  // namespace lxs
